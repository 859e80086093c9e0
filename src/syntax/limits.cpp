#include "syntax/limits.h"

#include <fmt/format.h>

#include <limits>

namespace rt {

namespace {

constexpr std::uint64_t most_places =
    std::numeric_limits<std::uint32_t>::max() - 1;  ///< a place in a file is 32 bits, one of them means none
constexpr std::uint64_t most_levels = 1'000'000'000;
constexpr std::uint64_t unbounded = std::uint64_t{1} << 62;

using Options = ParseOptions;

constexpr SceneLimit limits[] = {
    {"file", "bytes of one file", &Options::max_file_bytes, most_places, true},
    {"memory", "bytes of the whole program", &Options::max_memory_bytes, unbounded, true, "3/4 of the machine's"},
    {"reread", "bytes that loops and macros read again", &Options::max_replayed_bytes, unbounded, true},
    {"written", "bytes that #write keeps", &Options::max_written_bytes, unbounded, true},
    {"string", "bytes of one string", &Options::max_string_bytes, most_places, true},
    {"includes", "#include, carried out", &Options::max_includes},
    {"include-depth", "files that include each other", &Options::max_include_depth, most_levels},
    {"macro-depth", "macros that call each other", &Options::max_macro_depth, most_levels},
    {"nesting", "blocks and parentheses in each other", &Options::max_nesting, most_levels},
    {"directive-nesting", "directives in values of directives", &Options::max_directive_nesting, most_levels},
    {"array", "elements of an array", &Options::max_array_elements, most_levels},
    {"picture", "pixels of a picture that is read", &Options::max_picture_pixels, std::uint64_t{1} << 40},
    {"texture", "pigments of a texture", &Options::max_texture_nodes},
    {"texture-depth", "patterns in patterns", &Options::max_texture_depth, most_levels},
    {"textures", "pigments beyond the first of all textures", &Options::max_scene_nodes},
    {"parts", "parts of all sets of objects", &Options::max_set_parts},
};

}  // namespace

std::span<const SceneLimit> scene_limits() { return limits; }

std::uint64_t value_of(const SceneLimit& limit, const ParseOptions& options) {
    return std::visit([&](auto member) { return static_cast<std::uint64_t>(options.*member); }, limit.member);
}

void set_value(const SceneLimit& limit, ParseOptions& options, std::uint64_t value) {
    std::visit(
        [&](auto member) {
            auto& target = options.*member;
            target = static_cast<std::remove_reference_t<decltype(target)>>(value);
        },
        limit.member);
}

std::string allow_more(std::string_view name) { return fmt::format(" --limit {}=N allows more.", name); }

}  // namespace rt
