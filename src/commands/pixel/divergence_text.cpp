#include "commands/pixel/divergence_text.h"

#include <fmt/format.h>

namespace rt {

namespace {

/// "sample 1, ray 3 (camera > transmission > mirror)": rays are counted from 1, as they stand in the file.
std::string ray_text(const Divergence& found, const ToldPixel& told, std::size_t ray) {
    const std::vector<ToldRay>& rays = told.samples[found.sample];
    std::string path;
    for (std::size_t i = ray; i != ToldRay::none; i = rays[i].parent) {
        const char* name = rays[i].kind == ToldRay::Kind::camera       ? "camera"
                           : rays[i].kind == ToldRay::Kind::reflection ? "mirror"
                                                                       : "transmission";
        path = path.empty() ? name : fmt::format("{} > {}", name, path);
    }
    return fmt::format("sample {}, ray {} ({})", found.sample + 1, ray + 1, path);
}

}  // namespace

std::string divergence_text(const Divergence& found, const ToldPixel& a) {
    const std::string place = found.ray_a == ToldRay::none ? "" : " of " + ray_text(found, a, found.ray_a);
    return fmt::format("first difference: {}{}\n  A  {}\n  B  {}\nlikely cause: {}\n{}\n", found.field, place, found.value_a, found.value_b,
                       name_of(found.cause), meaning_of(found.cause));
}

}  // namespace rt
