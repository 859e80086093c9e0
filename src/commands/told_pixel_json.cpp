// Our JSON of a pixel's rays, back to numbers. Every mistake has its place.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "commands/json_place.h"
#include "commands/ray_tree_names.h"
#include "commands/told_pixel_file.h"

namespace rt {

namespace {

using nlohmann::json;

/// One value, and the way to it.
class Value {
public:
    Value(const Sources& sources, const json& content) : sources_(&sources), content_(&content) {}

    bool has(const char* name) const { return content_->is_object() && content_->contains(name); }
    bool is_null() const { return content_->is_null(); }

    Value operator[](const char* name) const {
        if (!content_->is_object()) fail("an object");
        if (!content_->contains(name)) fail(fmt::format("a member \"{}\"", name));
        return below((*content_)[name], name);
    }
    Value item(std::size_t index) const { return below((*content_)[index], std::to_string(index)); }
    /// Of a list.
    std::size_t size() const {
        if (!content_->is_array()) fail("a list");
        return content_->size();
    }

    double number() const {
        if (content_->is_number()) return content_->get<double>();
        if (*content_ == "Infinity") return std::numeric_limits<double>::infinity();
        if (*content_ == "-Infinity") return -std::numeric_limits<double>::infinity();
        if (*content_ == "NaN") return std::numeric_limits<double>::quiet_NaN();
        fail("a number, \"Infinity\", \"-Infinity\" or \"NaN\"");
    }
    std::uint32_t count() const {
        if (!content_->is_number_unsigned() || content_->get<std::uint64_t>() > 0x7fffffffu) fail("a whole number");
        return content_->get<std::uint32_t>();
    }
    bool truth() const {
        if (!content_->is_boolean()) fail("true or false");
        return content_->get<bool>();
    }
    const std::string& word() const {
        if (!content_->is_string()) fail("a string");
        return content_->get_ref<const std::string&>();
    }
    Vec3 vector() const {
        if (size() != 3) fail("a list of three numbers");
        return {item(0).number(), item(1).number(), item(2).number()};
    }
    template <typename T, std::size_t N>
    T name(const NameTable<T, N>& table, std::string_view what) const {
        if (const std::optional<T> value = find_name(table, word())) return *value;
        fail(fmt::format("a {}", what));
    }

    [[noreturn]] void fail(std::string_view expected) const {
        const std::string& text = sources_->file(0).text;
        const auto at = static_cast<std::uint32_t>(place_in_json(text, path_));
        std::string found = content_->dump(-1, ' ', false, json::error_handler_t::replace);
        if (found.size() > 40) found = found.substr(0, 37) + "...";
        throw SceneError(
            sources_->describe({0, at, at + 1}, "Parse Error", fmt::format("Expected {}, {} found instead.", expected, found)));
    }

private:
    Value below(const json& content, std::string key) const {
        Value value(*sources_, content);
        value.path_ = path_;
        value.path_.push_back(std::move(key));
        return value;
    }

    const Sources* sources_;
    const json* content_;
    std::vector<std::string> path_;
};

Ray ray_of(const Value& value) { return {value["origin"].vector(), value["direction"].vector()}; }

ToldHit hit_of(const Value& value) {
    ToldHit hit;
    hit.object = value["object"].count();
    hit.type = value["type"].word();
    hit.t = value["t"].number();
    hit.point = value["point"].vector();
    if (value.has("normal")) hit.normal = value["normal"].vector();
    if (value.has("object_ray")) hit.object_ray = ray_of(value["object_ray"]);
    if (value.has("inside")) hit.inside = value["inside"].truth();
    if (value.has("layers")) {
        const Value layers = value["layers"];
        for (std::size_t i = 0; i < layers.size(); ++i)
            hit.layers.push_back({layers.item(i)["rgb"].vector(), layers.item(i)["filter"].number(), layers.item(i)["transmit"].number()});
    }
    if (value.has("shadows")) {
        const Value shadows = value["shadows"];
        hit.shadows.emplace();
        for (std::size_t i = 0; i < shadows.size(); ++i)
            hit.shadows->push_back({shadows.item(i)["light"].count(), shadows.item(i)["sample"].count(),
                                    shadows.item(i)["transmitted"].vector(),
                                    shadows.item(i).has("crossed") && shadows.item(i)["crossed"].size() > 0, true});
    }
    return hit;
}

ToldRay::Kind kind_of(RayNode::Kind kind) {
    if (kind == RayNode::Kind::camera) return ToldRay::Kind::camera;
    const bool mirrored = kind == RayNode::Kind::reflected || kind == RayNode::Kind::total;
    return mirrored ? ToldRay::Kind::reflection : ToldRay::Kind::refraction;
}

ToldRay::End end_of(RayNode::End end) {
    switch (end) {
        case RayNode::End::surface:
            return ToldRay::End::surface;
        case RayNode::End::background:
            return ToldRay::End::background;
        case RayNode::End::level:
            return ToldRay::End::level;
        case RayNode::End::weight:
            return ToldRay::End::weight;
    }
    return ToldRay::End::background;
}

/// A ray behind those of its sample that are already known.
ToldRay told_ray(const Value& value, const std::vector<ToldRay>& before) {
    ToldRay ray;
    const Value parent = value["parent"], kind = value["kind"], end = value["end"];
    const RayNode::Kind told_kind = kind.name(ray_kind_names, "kind of ray");
    ray.kind = kind_of(told_kind);
    ray.total = told_kind == RayNode::Kind::total;
    ray.end = end_of(end.name(ray_end_names, "kind of end"));
    if ((ray.kind == ToldRay::Kind::camera) != before.empty()) kind.fail("the camera ray first and no other one");
    if (parent.is_null() != before.empty()) parent.fail(before.empty() ? "null" : "the place of the ray that causes this one");
    if (!parent.is_null()) {
        ray.parent = parent.count();
        if (ray.parent >= before.size() || !before[ray.parent].hit) parent.fail("the place of a ray before that meets a surface");
    }
    ray.ray = ray_of(value);
    if (ray.end == ToldRay::End::surface) ray.hit = hit_of(value["hit"]);
    if (value.has("factor")) ray.factor = value["factor"].vector();
    constexpr std::pair<const char*, LightPart> parts[] = {{"ambient", LightPart::ambient},       {"diffuse", LightPart::diffuse},
                                                           {"specular", LightPart::specular},     {"reflection", LightPart::reflection},
                                                           {"refraction", LightPart::refraction}, {"background", LightPart::background},
                                                           {"radiance", LightPart::radiance}};
    for (const auto& [name, part] : parts)
        if (value.has(name)) ray.part(part) = value[name].vector();
    if (value.has("shares")) {
        const Value shares = value["shares"];
        ray.shares = {shares["local"].number(), shares["reflection"].number(), shares["transmission"].number()};
    }
    return ray;
}

ToldPixel told_pixel(const Value& value) {
    ToldPixel told;
    if (value["format"].word() != ray_tree_format) value["format"].fail(fmt::format("\"{}\"", ray_tree_format));
    const Value pixel = value["pixel"];
    told.x = static_cast<int>(pixel["x"].count());
    told.y = static_cast<int>(pixel["y"].count());
    constexpr NameTable<bool, 2> origins{{{"top left", true}, {"bottom left", false}}};
    told.from_top = pixel["origin"].name(origins, "corner, \"top left\" or \"bottom left\"");
    const Value color = pixel["color"];
    if (color.size() != 3) color.fail("a list of three bytes");
    for (std::size_t c = 0; c < 3; ++c) told.color[c] = static_cast<int>(color.item(c).count());
    if (value.has("camera") && !value["camera"]["orthographic"].truth()) {
        const Value camera = value["camera"];
        told.camera = {camera["direction"].vector(), camera["right"].vector(), camera["up"].vector(),
                       static_cast<int>(value["width"].count()), static_cast<int>(value["height"].count())};
    }
    const Value samples = value["samples"];
    for (std::size_t s = 0; s < samples.size(); ++s) {
        const Value rays = samples.item(s);
        std::vector<ToldRay>& sample = told.samples.emplace_back();
        for (std::size_t i = 0; i < rays.size(); ++i) sample.push_back(told_ray(rays.item(i), sample));
        if (sample.empty()) rays.fail("a camera ray");
    }
    if (told.samples.empty()) samples.fail("the rays of a sample");
    return told;
}

/// nlohmann's text begins with its own name and place: "[json.exception.parse_error.101] parse error at line 1, column 2: ".
std::string_view bare(std::string_view message) {
    const std::size_t place = message.find(": ");
    return place == message.npos ? message : message.substr(place + 2);
}

}  // namespace

ToldPixel told_pixel_of_json(const Sources& sources) {
    json content;
    try {
        content = json::parse(sources.file(0).text);
    } catch (const json::parse_error& error) {
        const auto at = static_cast<std::uint32_t>(error.byte > 0 ? error.byte - 1 : 0);
        throw SceneError(sources.describe({0, at, at + 1}, "Parse Error", bare(error.what())));
    } catch (const json::out_of_range& error) {  // a number beyond double precision: its digits are told, not their place
        const std::string_view message = error.what();
        const std::size_t begin = message.find('\'') + 1;
        const std::string_view digits = message.substr(begin, message.rfind('\'') - begin);
        const auto at = static_cast<std::uint32_t>(std::min(sources.file(0).text.find(digits), sources.file(0).text.size()));
        throw SceneError(sources.describe({0, at, at + static_cast<std::uint32_t>(digits.size())}, "Parse Error",
                                          fmt::format("Expected a number of double precision, {} found instead.", digits)));
    }
    return told_pixel(Value(sources, content));
}

}  // namespace rt
