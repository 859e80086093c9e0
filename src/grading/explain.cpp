#include "grading/explain.h"

#include <fmt/format.h>

#include <algorithm>

#include "grading/explain_rules.h"

namespace rt {

namespace {

using rules::same;
using Rays = std::vector<ToldRay>;

std::string text(const Vec3& v) { return fmt::format("{{{:.6g} {:.6g} {:.6g}}}", v.x, v.y, v.z); }
std::string text(const ToldRay::Shares& s) {
    return fmt::format("{:.6g} local, {:.6g} reflection, {:.6g} transmission", s.local, s.reflection, s.transmission);
}

std::string text_of_end(const ToldRay& ray) {
    if (ray.hit) return fmt::format("object {} ({}) at t = {:.6g}", ray.hit->object, ray.hit->type, ray.hit->t);
    if (ray.end == ToldRay::End::level) return "not followed, as deep as rays go";
    return ray.end == ToldRay::End::weight ? "not followed, too faint" : "nothing";
}

std::string text_of_arrival(const ToldShadow& shadow) {
    if (shadow.transmitted == Rgb(0.0)) return "is hidden";
    return shadow.exact ? "arrives by " + text(shadow.transmitted) : "arrives";
}

constexpr std::string_view part_names[light_parts] = {"ambient",    "diffuse",    "specular", "reflection",
                                                      "refraction", "background", "radiance"};

std::string_view kind_name(ToldRay::Kind kind) { return kind == ToldRay::Kind::reflection ? "mirrored ray" : "transmitted ray"; }

/// The walk through one sample of both records; the first difference ends it.
class Walk {
public:
    Walk(const ToldPixel& a, const ToldPixel& b, std::size_t sample, double tolerance)
        : a_(a.samples[sample]),
          b_(b.samples[sample]),
          camera_(a.camera   ? &*a.camera
                  : b.camera ? &*b.camera
                             : nullptr),
          grid_(std::sqrt(static_cast<double>(a.samples.size()))),
          rounded_(a.rounded || b.rounded),
          tolerance_(tolerance),
          deepest_a_(deepest(a_)),
          deepest_b_(deepest(b_)),
          children_a_(children_of(a_)),
          children_b_(children_of(b_)) {}

    std::optional<Divergence> from_camera() {
        if (!a_.empty() && !b_.empty()) compare_from_camera();
        return std::move(found_);
    }

private:
    using Children = std::vector<std::vector<std::size_t>>;  ///< of each ray, in the order of the record
    /// Two rays whose further rays are being compared, `next` at a time.
    struct Open {
        std::size_t i, j, next;
    };

    static Children children_of(const Rays& rays) {
        Children children(rays.size());
        for (std::size_t i = 0; i < rays.size(); ++i)
            if (rays[i].parent != ToldRay::none) children[rays[i].parent].push_back(i);
        return children;
    }

    static int deepest(const Rays& rays) {
        std::vector<int> depth(rays.size(), 0);
        for (std::size_t i = 0; i < rays.size(); ++i)
            if (rays[i].parent != ToldRay::none) depth[i] = depth[rays[i].parent] + 1;
        return depth.empty() ? 0 : *std::max_element(depth.begin(), depth.end());
    }

    bool differ(std::size_t i, std::size_t j, Cause cause, std::string_view field, std::string value_a, std::string value_b) {
        found_ = {cause, 0, i, j, std::string(field), std::move(value_a), std::move(value_b)};
        return true;
    }

    /// A ray, then its further rays, then what they bring to it. By a stack of its own: a record may be any number of rays deep.
    void compare_from_camera() {
        if (begin(0, 0, 0)) return;
        std::vector<Open> open{{0, 0, 0}};
        while (!open.empty()) {
            const Open at = open.back();
            const std::vector<std::size_t>&a = children_a_[at.i], &b = children_b_[at.j];
            if (at.next == a.size()) {
                if (brought_light(at.i, at.j)) return;
                open.pop_back();
                continue;
            }
            ++open.back().next;
            if (begin(a[at.next], b[at.next], static_cast<int>(open.size()))) return;
            open.push_back({a[at.next], b[at.next], 0});
        }
    }

    /// Each of these is true where it found the first difference.
    bool begin(std::size_t i, std::size_t j, int depth) {
        return rays(i, j) || hits(i, j) || surfaces(i, j) || shadows(i, j) || own_light(i, j) || further(i, j, depth);
    }

    bool brought_light(std::size_t i, std::size_t j) {
        for (std::size_t k = 0; k < children_a_[i].size(); ++k)
            if (factors_differ(children_a_[i][k], children_b_[j][k])) return differ_in_factor(children_a_[i][k], children_b_[j][k]);
        return sums(i, j);
    }

    bool rays(std::size_t i, std::size_t j) {
        const ToldRay &a = a_[i], &b = b_[j];
        const bool from_camera = a.parent == ToldRay::none;
        const bool same_direction = same(a.ray.direction, b.ray.direction, tolerance_);
        if (!same(a.ray.origin, b.ray.origin, tolerance_) && (same_direction || !is_offset_along_itself(a, b))) {
            const Cause cause = from_camera ? Cause::camera : rules::origin(a.ray.origin, b.ray.origin, a_[a.parent].hit->point);
            return differ(i, j, cause, "origin", text(a.ray.origin), text(b.ray.origin));
        }
        if (same_direction) return false;
        Cause cause = Cause::other;
        if (from_camera) {
            cause = rules::camera_direction(a.ray.direction, b.ray.direction, camera_, grid_, tolerance_);
        } else if (const ToldRay& parent = a_[a.parent]; parent.hit->normal) {
            cause = rules::direction(a.kind, a.ray.direction, b.ray.direction, parent.ray.direction, *parent.hit->normal, tolerance_);
        }
        return differ(i, j, cause, "direction", text(a.ray.direction), text(b.ray.direction));
    }

    /// Whether both begin so far from the surface that their directions alone make the difference.
    bool is_offset_along_itself(const ToldRay& a, const ToldRay& b) const {
        if (a.parent == ToldRay::none) return false;
        const Vec3 &from_a = a_[a.parent].hit->point, &from_b = b_[b.parent].hit->point;
        return same(length(a.ray.origin - from_a), length(b.ray.origin - from_b), 2.0 * tolerance_);
    }

    bool factors_differ(std::size_t i, std::size_t j) const {
        return a_[i].factor && b_[j].factor && !same(*a_[i].factor, *b_[j].factor, tolerance_);
    }

    bool differ_in_factor(std::size_t i, std::size_t j) {
        const Rgb &a = *a_[i].factor, &b = *b_[j].factor;
        Cause cause = rules::factor(a_[i].kind, a, b, tolerance_);
        // The mirror of what light also passes.
        const bool passes = has_child(a_, children_a_[a_[i].parent], ToldRay::Kind::refraction);
        if (cause == Cause::wrong_share && a_[i].kind == ToldRay::Kind::reflection && passes) cause = Cause::missing_fresnel;
        return differ(i, j, cause, "factor", text(a), text(b));
    }

    bool hits(std::size_t i, std::size_t j) {
        const ToldRay &a = a_[i], &b = b_[j];
        const bool end = a.end == b.end && a.hit.has_value() == b.hit.has_value();
        const bool met = end && (!a.hit || (a.hit->object == b.hit->object && same(a.hit->t, b.hit->t, tolerance_) &&
                                            same(a.hit->point, b.hit->point, tolerance_)));
        if (met) return false;
        const bool faint = (a.end == ToldRay::End::weight) != (b.end == ToldRay::End::weight);
        if (faint && factors_differ(i, j)) return differ_in_factor(i, j);
        const ToldRay* parent = b.parent == ToldRay::none ? nullptr : &b_[b.parent];
        return differ(i, j, rules::hit(a, b, parent, tolerance_), "what it meets", text_of_end(a), text_of_end(b));
    }

    bool surfaces(std::size_t i, std::size_t j) {
        if (!a_[i].hit) return false;
        const ToldHit &a = *a_[i].hit, &b = *b_[j].hit;
        if (a.normal && b.normal && !same(*a.normal, *b.normal, tolerance_))
            return differ(i, j, rules::normal(*a.normal, *b.normal, tolerance_), "normal", text(*a.normal), text(*b.normal));
        if (a.inside && b.inside && *a.inside != *b.inside)
            return differ(i, j, Cause::wrong_normal_side, "side", *a.inside ? "inside" : "outside", *b.inside ? "inside" : "outside");
        for (std::size_t k = 0; k < std::min(a.layers.size(), b.layers.size()); ++k) {
            const ToldLayer &la = a.layers[k], &lb = b.layers[k];
            if (same(la.rgb, lb.rgb, tolerance_) && same(la.filter, lb.filter, tolerance_) && same(la.transmit, lb.transmit, tolerance_))
                continue;
            const auto told = [](const ToldLayer& l) {
                return fmt::format("{} filter {:.6g} transmit {:.6g}", text(l.rgb), l.filter, l.transmit);
            };
            return differ(i, j, rules::layers(la, lb, tolerance_), "pigment", told(la), told(lb));
        }
        const std::optional<ToldRay::Shares>&sa = a_[i].shares, &sb = b_[j].shares;
        const bool shares_differ = sa && sb &&
                                   !(same(sa->local, sb->local, tolerance_) && same(sa->reflection, sb->reflection, tolerance_) &&
                                     same(sa->transmission, sb->transmission, tolerance_));
        return shares_differ && differ(i, j, cause_of_shares(i, *sa, *sb), "contributions", text(*sa), text(*sb));
    }

    /// Where no mistake in the indices makes the reflection total, the reflectance does.
    Cause cause_of_shares(std::size_t i, const ToldRay::Shares& a, const ToldRay::Shares& b) const {
        const Cause cause = rules::shares(a, b, tolerance_);
        if (cause != Cause::total_reflection) return cause;
        for (const std::size_t child : children_a_[i])
            if (a_[child].kind == ToldRay::Kind::refraction && !rules::inverse_ratio_is_total(a_[i], a_[child], tolerance_))
                return Cause::missing_fresnel;
        return cause;
    }

    bool shadows(std::size_t i, std::size_t j) {
        if (!a_[i].hit || !a_[i].hit->shadows || !b_[j].hit->shadows) return false;
        const std::vector<ToldShadow>&a = *a_[i].hit->shadows, &b = *b_[j].hit->shadows;
        // B may ask further lamps, those behind the surface: if it takes light from them, the light differs.
        std::size_t l = 0;
        for (const ToldShadow& of_a : a) {
            while (l < b.size() && (b[l].light != of_a.light || b[l].sample != of_a.sample)) ++l;
            const std::string field = fmt::format("shadow ray to light {}", of_a.light);
            if (l == b.size()) return differ(i, j, Cause::missing_light, field, text_of_arrival(of_a), "there is none");
            const ToldShadow& of_b = b[l++];
            const bool exact = of_a.exact && of_b.exact;
            const bool arrives = (of_a.transmitted != Rgb(0.0)) == (of_b.transmitted != Rgb(0.0));
            if (arrives && (!exact || same(of_a.transmitted, of_b.transmitted, tolerance_))) continue;
            Cause cause = rules::shadow(of_a, of_b);
            if (cause == Cause::false_shadow && (rules::hides_all(a, b) || further_rays_are_moved(i, j))) cause = Cause::offset;
            return differ(i, j, cause, field, text_of_arrival(of_a), text_of_arrival(of_b));
        }
        return false;
    }

    /// Whether rays that the same points cause begin at other places: then those to the lamps do, too.
    bool further_rays_are_moved(std::size_t i, std::size_t j) const {
        const std::vector<std::size_t>&a = children_a_[i], &b = children_b_[j];
        for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
            if (a_[a[k]].kind == b_[b[k]].kind && !same(a_[a[k]].ray.origin, b_[b[k]].ray.origin, tolerance_)) return true;
        return false;
    }

    bool part_differs(std::size_t i, std::size_t j, LightPart part) const {
        const std::optional<Rgb>&a = a_[i].part(part), &b = b_[j].part(part);
        return a && b && !same(*a, *b, tolerance_);
    }

    bool differ_in_part(std::size_t i, std::size_t j, LightPart part, Cause cause) {
        return differ(i, j, cause, part_names[static_cast<std::size_t>(part)], text(*a_[i].part(part)), text(*b_[j].part(part)));
    }

    bool own_light(std::size_t i, std::size_t j) {
        for (const LightPart part : {LightPart::ambient, LightPart::diffuse, LightPart::specular})
            if (part_differs(i, j, part)) return differ_in_part(i, j, part, cause_of_own_light(i, j, part));
        return part_differs(i, j, LightPart::background) && differ_in_part(i, j, LightPart::background, Cause::background);
    }

    /// Light of the surface itself that has another share, since the rest of it goes where one of the records has no ray.
    Cause cause_of_own_light(std::size_t i, std::size_t j, LightPart part) const {
        const Cause cause = rules::local_light(part, a_[i], b_[j], rounded_, tolerance_);
        if (cause == Cause::false_shadow) return cause_of_dark(i, j);
        if (cause != Cause::wrong_share) return cause;
        const auto only_a_has = [&](ToldRay::Kind kind) {
            return has_child(a_, children_a_[i], kind) && !has_child(b_, children_b_[j], kind);
        };
        if (only_a_has(ToldRay::Kind::refraction)) return Cause::missing_filter;
        if (only_a_has(ToldRay::Kind::reflection)) return Cause::missing_reflection;
        return cause;
    }

    /// B has no diffuse light at a point where A has some, and does not tell of its lamps.
    Cause cause_of_dark(std::size_t i, std::size_t j) const {
        const auto passes_something = [](const ToldShadow& s) { return s.through || s.transmitted == Rgb(0.0); };
        if (a_[i].hit->shadows && std::all_of(a_[i].hit->shadows->begin(), a_[i].hit->shadows->end(), passes_something))
            return Cause::missing_filter;
        const auto is_lit = [](const ToldRay& ray) { return ray.part(LightPart::diffuse).value_or(Rgb(0.0)) != Rgb(0.0); };
        if (std::none_of(b_.begin(), b_.end(), is_lit) && std::count_if(a_.begin(), a_.end(), is_lit) > 1) return Cause::wrong_diffuse;
        return further_rays_are_moved(i, j) ? Cause::offset : Cause::false_shadow;
    }

    static bool has_child(const Rays& rays, const std::vector<std::size_t>& children, ToldRay::Kind kind) {
        return std::any_of(children.begin(), children.end(), [&](std::size_t child) { return rays[child].kind == kind; });
    }

    /// Whether one of the records has a further ray that the other has not.
    bool further(std::size_t i, std::size_t j, int depth) {
        const std::vector<std::size_t>&a = children_a_[i], &b = children_b_[j];
        for (std::size_t k = 0; k < std::max(a.size(), b.size()); ++k) {
            const ToldRay* of_a = k < a.size() ? &a_[a[k]] : nullptr;
            const ToldRay* of_b = k < b.size() ? &b_[b[k]] : nullptr;
            if (of_a != nullptr && of_b != nullptr && of_a->kind == of_b->kind) continue;
            // Mirrors come first: of two kinds, the mirrored ray is the one too many.
            const bool a_has = of_a != nullptr && (of_b == nullptr || of_a->kind == ToldRay::Kind::reflection);
            const ToldRay::Kind kind = a_has ? of_a->kind : of_b->kind;
            const bool beyond = depth > 0 && depth + 1 > (a_has ? deepest_b_ : deepest_a_);
            const bool total = std::any_of(a.begin(), a.end(), [&](std::size_t c) { return a_[c].total; }) ||
                               std::any_of(b.begin(), b.end(), [&](std::size_t c) { return b_[c].total; });
            const Cause cause = total ? Cause::total_reflection : rules::further_ray(kind, a_has, beyond);
            return differ(i, j, cause, fmt::format("the {} it causes", kind_name(kind)), a_has ? "there is one" : "there is none",
                          a_has ? "there is none" : "there is one");
        }
        return false;
    }

    bool sums(std::size_t i, std::size_t j) {
        for (const auto& [part, kind] :
             {std::pair(LightPart::reflection, ToldRay::Kind::reflection), std::pair(LightPart::refraction, ToldRay::Kind::refraction)})
            if (part_differs(i, j, part)) return differ_in_part(i, j, part, cause_of_brought_light(i, j, part, kind));
        return part_differs(i, j, LightPart::radiance) && differ_in_part(i, j, LightPart::radiance, rules::sum(a_[i], b_[j], tolerance_));
    }

    /// Light that further rays bring, their own being the same as far as it is told: texts leave out what the background brings.
    Cause cause_of_brought_light(std::size_t i, std::size_t j, LightPart part, ToldRay::Kind kind) const {
        const Rgb &sum_a = *a_[i].part(part), &sum_b = *b_[j].part(part);
        for (std::size_t k = 0; k < children_a_[i].size(); ++k) {
            const ToldRay &a = a_[children_a_[i][k]], &b = b_[children_b_[j][k]];
            if (a.kind != kind) continue;
            const std::optional<Rgb>&light_a = a.part(LightPart::radiance), &light_b = b.part(LightPart::radiance);
            if (!a.hit && (!light_a || (!light_b && sum_b == Rgb(0.0)))) return Cause::background;
            const auto divides = [](const Rgb& light) { return light.r > 0.0 && light.g > 0.0 && light.b > 0.0; };
            // The factors that the sums have on the light of the further ray.
            const Rgb other = light_b.value_or(*light_a);
            if (divides(*light_a) && divides(other)) return rules::factor(kind, sum_a / *light_a, sum_b / other, tolerance_);
        }
        return rules::factor(kind, sum_a, sum_b, tolerance_);
    }

    const Rays &a_, &b_;
    const ToldCamera* camera_;
    double grid_;  ///< rays of the pixel in a row
    bool rounded_;
    double tolerance_;
    int deepest_a_, deepest_b_;
    Children children_a_, children_b_;
    std::optional<Divergence> found_;
};

std::string text(const std::array<int, 3>& color) { return fmt::format("({}, {}, {})", color[0], color[1], color[2]); }

/// Differences of the pixel itself, before its rays.
std::optional<Divergence> of_pixel(const ToldPixel& a, const ToldPixel& b) {
    const auto place = [](const ToldPixel& p) { return fmt::format("[{}, {}] from the {} left", p.x, p.y, p.from_top ? "top" : "bottom"); };
    if (a.x != b.x || (a.from_top == b.from_top && a.y != b.y))
        return Divergence{Cause::another_pixel, 0, ToldRay::none, ToldRay::none, "place of the pixel", place(a), place(b)};
    if (a.samples.size() != b.samples.size())
        return Divergence{Cause::sampling,
                          0,
                          ToldRay::none,
                          ToldRay::none,
                          "number of samples",
                          std::to_string(a.samples.size()),
                          std::to_string(b.samples.size())};
    return std::nullopt;
}

}  // namespace

std::optional<Divergence> first_divergence(const ToldPixel& a, const ToldPixel& b, double tolerance) {
    if (std::optional<Divergence> found = of_pixel(a, b)) return found;
    for (std::size_t s = 0; s < a.samples.size(); ++s) {
        std::optional<Divergence> found = Walk(a, b, s, tolerance).from_camera();
        if (!found) continue;
        found->sample = s;
        return found;
    }
    if (a.color == b.color) return std::nullopt;
    Cause cause = rules::color(a.color, b.color);
    const auto leaves = [](const Rays& rays) { return !rays.empty() && rays.front().end == ToldRay::End::background; };
    if (cause == Cause::other && b.rounded && std::any_of(b.samples.begin(), b.samples.end(), leaves)) cause = Cause::background;
    return Divergence{cause, 0, ToldRay::none, ToldRay::none, "colour of the pixel", text(a.color), text(b.color)};
}

}  // namespace rt
