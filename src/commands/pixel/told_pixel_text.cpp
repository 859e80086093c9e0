// The course's texts, back to numbers.
#include <fmt/format.h>

#include <charconv>
#include <string_view>
#include <utility>

#include "commands/pixel/told_pixel_file.h"

namespace rt {

namespace {

/// Reads along the text; every failure has the place where it stands.
class Cursor {
public:
    explicit Cursor(const Sources& sources) : sources_(sources), text_(sources.file(0).text) {}

    bool at_end() const { return at_ >= text_.size(); }
    std::size_t column() const { return at_ - line_; }
    std::string_view rest_of_line() const { return text_.substr(at_, text_.find('\n', at_) - at_); }

    void next_line() {
        const std::size_t end = text_.find('\n', at_);
        at_ = line_ = end == text_.npos ? text_.size() : end + 1;
    }
    void skip(std::string_view any_of) { at_ = std::min(text_.find_first_not_of(any_of, at_), text_.size()); }
    bool accept(std::string_view word) {
        if (!text_.substr(at_).starts_with(word)) return false;
        at_ += word.size();
        return true;
    }
    /// Blanks before it do not count.
    void expect(std::string_view word) {
        skip(" \t");
        if (!accept(word)) fail(fmt::format("Expected '{}'", word));
    }
    double number() {
        skip(" \t");
        double x = 0.0;
        const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), x);
        if (error != std::errc()) fail("Expected a number");
        at_ = static_cast<std::size_t>(end - text_.data());
        return x;
    }
    int whole_number() {
        skip(" \t");
        int n = 0;
        const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), n);
        if (error != std::errc()) fail("Expected a whole number");
        at_ = static_cast<std::size_t>(end - text_.data());
        return n;
    }
    std::string until(char end) {
        const std::string_view line = rest_of_line();
        const std::size_t n = line.find(end);
        if (n == line.npos) fail(fmt::format("Expected '{}' later in this line", end));
        at_ += n + 1;
        return std::string(line.substr(0, n));
    }
    [[noreturn]] void fail(std::string_view expected) const {
        const auto at = static_cast<std::uint32_t>(at_);
        const std::string_view line = rest_of_line();
        const std::string found = at_end() ? "the end of the text" : line.empty() ? "the end of the line" : fmt::format("'{}'", line);
        throw SceneError(sources_.describe({0, at, at + 1}, "Parse Error", fmt::format("{}, {} found instead.", expected, found)));
    }

private:
    const Sources& sources_;
    std::string_view text_;
    std::size_t at_ = 0, line_ = 0;
};

Vec3 vector(Cursor& at) {
    at.expect("{");
    const double x = at.number(), y = at.number(), z = at.number();
    at.expect("}");
    return {x, y, z};
}

Ray ray(Cursor& at) {
    const Vec3 origin = vector(at);
    at.expect("->");
    return {origin, vector(at)};
}

class Reader {
public:
    explicit Reader(const Sources& sources) : at_(sources) {}

    ToldPixel read() {
        at_.skip(" \t\r\n");
        header();
        for (at_.next_line(); !at_.at_end(); at_.next_line()) line();
        finish_ray();
        if (pixel_.samples.empty()) at_.fail("Expected 'Iteration type: Primary'");
        return std::move(pixel_);
    }

private:
    void header() {
        at_.expect("Pixel:");
        at_.expect("[");
        pixel_.x = at_.whole_number();
        at_.expect(",");
        pixel_.y = at_.whole_number();
        at_.expect("]");
        at_.expect("Color:");
        at_.expect("(");
        for (std::size_t c = 0; c < 3; ++c) {
            if (c > 0) at_.expect(",");
            pixel_.color[c] = at_.whole_number();
        }
        at_.expect(")");
        end_of_line();
        pixel_.rounded = true;
    }

    void end_of_line() {
        at_.skip(" \t\r");
        if (!at_.at_end() && !at_.rest_of_line().empty()) at_.fail("Expected the end of the line");
    }

    /// One line; branches that are drawn before it do not count, but for the depth of a ray in the tree.
    void line() {
        at_.skip(" \t|\\");
        const std::size_t column = at_.column();
        if (at_.accept("o - ")) depth_ = column / 2;
        if (at_.rest_of_line().find_first_not_of("- \t\r") == std::string_view::npos) return;  // rules between rays, blank lines
        if (at_.accept("Iteration type:")) {
            finish_ray();
            start_ray();
        } else if (pixel_.samples.empty()) {
            at_.fail("Expected 'Iteration type: Primary'");
        } else {
            field();
        }
        end_of_line();
    }

    void start_ray() {
        at_.skip(" \t");
        ToldRay ray;
        if (at_.accept("Primary")) {
            pixel_.samples.emplace_back();
            path_.clear();
        } else if (pixel_.samples.empty()) {
            at_.fail("Expected 'Primary'");
        } else if (at_.accept("Reflection")) {
            ray.kind = ToldRay::Kind::reflection;
        } else if (at_.accept("Refraction")) {
            ray.kind = ToldRay::Kind::refraction;
        } else {
            at_.fail("Expected 'Primary', 'Reflection' or 'Refraction'");
        }
        pixel_.samples.back().push_back(ray);
        has_ray_ = has_end_ = false;
    }

    ToldRay& current() { return pixel_.samples.back().back(); }

    ToldHit& hit() {
        if (!current().hit) at_.fail("Expected 'Hit Object' before this");
        return *current().hit;
    }

    void field() {
        if (at_.accept("Ray:")) {
            current().ray = ray(at_);
            has_ray_ = true;
            find_parent();
        } else if (at_.accept("Transformed Ray:")) {
            object_ray_ = ray(at_);
        } else if (at_.accept("Hit Object:")) {
            object();
        } else if (at_.accept("Intersection:")) {
            ToldHit& met = hit();
            met.point = vector(at_);
            at_.expect("at T =");
            met.t = at_.number();
            has_end_ = true;
        } else if (at_.accept("Normal:")) {
            ToldHit& met = hit();
            met.normal = vector(at_);
        } else if (at_.accept("Contributions:")) {
            shares();
        } else if (at_.accept("Shadow Ray:")) {
            shadow();
        } else if (at_.accept("Extra Info:")) {
            at_.skip(" \t");
            const bool leaves = at_.accept("into-air");
            if (!leaves && !at_.accept("into-object")) at_.fail("Expected 'into-air' or 'into-object'");
            if (current().parent != ToldRay::none) pixel_.samples.back()[current().parent].hit->inside = leaves;
        } else if (!light() && !end()) {
            at_.fail("Expected a line of printrays or pixeltrace");
        }
    }

    bool light() {
        constexpr std::pair<std::string_view, LightPart> parts[] = {
            {"Final Color:", LightPart::radiance}, {"Ambient:", LightPart::ambient},       {"Diffuse:", LightPart::diffuse},
            {"Specular:", LightPart::specular},    {"Reflection:", LightPart::reflection}, {"Refraction:", LightPart::refraction}};
        for (const auto& [name, part] : parts) {
            if (!at_.accept(name)) continue;
            current().part(part) = vector(at_);
            return true;
        }
        return false;
    }

    bool end() {
        constexpr std::pair<std::string_view, ToldRay::End> ends[] = {{"No intersection.", ToldRay::End::background},
                                                                      {"Not followed: as deep as rays go.", ToldRay::End::level},
                                                                      {"Not followed: too faint to matter.", ToldRay::End::weight}};
        for (const auto& [text, end] : ends) {
            if (!at_.accept(text)) continue;
            current().end = end;
            has_end_ = true;
            return true;
        }
        return false;
    }

    void object() {
        ToldHit hit;
        at_.expect("(ID #");
        hit.object = static_cast<std::uint32_t>(at_.whole_number());
        at_.expect("-");
        at_.skip(" \t");
        hit.type = at_.until(')');
        hit.object_ray = std::exchange(object_ray_, std::nullopt);
        current().hit = std::move(hit);
        current().end = ToldRay::End::surface;
    }

    void shares() {
        ToldRay::Shares shares;
        shares.local = at_.number();
        at_.expect("Local,");
        shares.reflection = at_.number();
        at_.expect("Reflection,");
        shares.transmission = at_.number();
        at_.expect("Transmission");
        current().shares = shares;
    }

    void shadow() {
        ToldShadow shadow;
        at_.expect("Light[");
        shadow.light = static_cast<std::uint32_t>(at_.whole_number());
        at_.expect("]");
        at_.skip(" \t");
        const bool hidden = at_.accept("is hidden");
        if (!hidden && !at_.accept("arrives")) at_.fail("Expected 'arrives' or 'is hidden'");
        shadow.transmitted = Rgb(hidden ? 0.0 : 1.0);
        shadow.exact = hidden;
        std::optional<std::vector<ToldShadow>>& shadows = hit().shadows;
        if (!shadows) shadows.emplace();
        shadow.sample = shadows->empty() || shadows->back().light != shadow.light ? 0 : shadows->back().sample + 1;
        shadows->push_back(shadow);
    }

    void find_parent() {
        std::vector<ToldRay>& rays = pixel_.samples.back();
        ToldRay& ray = rays.back();
        if (rays.size() > 1) {
            if (depth_) {
                if (*depth_ == 0 || *depth_ > path_.size()) at_.fail("Expected a branch from the ray above");
                path_.resize(*depth_);
            } else {
                path_.resize(nearest_end(rays, ray.ray.origin) + 1);
            }
            ray.parent = path_.back();
            if (!rays[ray.parent].hit) at_.fail("Expected no ray from one that meets nothing");
        }
        path_.push_back(rays.size() - 1);
    }

    /// The place in `path_` of the ray that ends nearest to `origin`; of equals the last.
    std::size_t nearest_end(const std::vector<ToldRay>& rays, const Vec3& origin) const {
        std::size_t best = 0;
        double least = infinity;
        for (std::size_t i = 0; i < path_.size(); ++i) {
            if (!rays[path_[i]].hit) continue;
            const double distance = length(rays[path_[i]].hit->point - origin);
            if (distance <= least) best = i, least = distance;
        }
        return best;
    }

    void finish_ray() {
        if (pixel_.samples.empty()) return;
        if (!has_ray_) at_.fail("Expected 'Ray' in the ray above");
        if (!has_end_) at_.fail("Expected 'Intersection' or 'No intersection.' in the ray above");
        object_ray_.reset();
    }

    Cursor at_;
    ToldPixel pixel_;
    std::vector<std::size_t> path_;     ///< from the camera ray to the current one
    std::optional<std::size_t> depth_;  ///< of the current ray, in a drawn tree
    std::optional<Ray> object_ray_;
    bool has_ray_ = false, has_end_ = false;
};

}  // namespace

ToldPixel told_pixel_of_text(const Sources& sources) { return Reader(sources).read(); }

}  // namespace rt
