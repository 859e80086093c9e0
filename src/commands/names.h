// One table of names per thing that can be selected by name, whether on the command line, in an INI file or in a scene.
#pragma once

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "film/image_file.h"
#include "trace/options.h"
#include "world/compile.h"

namespace rt {

template <typename T, std::size_t N>
using NameTable = std::array<std::pair<std::string_view, T>, N>;

inline constexpr NameTable<ShadingModel, 2> shading_names{{{"general", ShadingModel::general}, {"povray", ShadingModel::povray}}};
inline constexpr NameTable<Distances, 2> distances_names{{{"scaled", Distances::scaled}, {"povray", Distances::povray}}};
inline constexpr NameTable<Precision, 2> precision_names{{{"fast", Precision::fast}, {"exact", Precision::exact}}};
inline constexpr NameTable<Profile, 2> profile_names{{{"povray", Profile::povray}, {"csc473", Profile::csc473}}};
inline constexpr NameTable<IndexKind, 3> index_names{
    {{"automatic", IndexKind::automatic}, {"embree", IndexKind::embree}, {"brute_force", IndexKind::brute_force}}};
inline constexpr NameTable<EdgeOptions::Kind, 4> edge_names{{{"off", EdgeOptions::Kind::off},
                                                             {"silhouette", EdgeOptions::Kind::silhouette},
                                                             {"crease", EdgeOptions::Kind::crease},
                                                             {"all", EdgeOptions::Kind::all}}};
inline constexpr NameTable<ImageFormat, 8> format_names{{{"png", ImageFormat::png},
                                                         {"exr", ImageFormat::exr},
                                                         {"hdr", ImageFormat::hdr},
                                                         {"tiff", ImageFormat::tiff},
                                                         {"jpeg", ImageFormat::jpeg},
                                                         {"ppm", ImageFormat::ppm},
                                                         {"tga", ImageFormat::tga},
                                                         {"bmp", ImageFormat::bmp}}};

template <typename T, std::size_t N>
std::optional<T> find_name(const NameTable<T, N>& table, std::string_view name) {
    for (const auto& [known, value] : table)
        if (known == name) return value;
    return std::nullopt;
}

template <typename T, std::size_t N>
std::string_view name_of(const NameTable<T, N>& table, T value) {
    for (const auto& [name, known] : table)
        if (known == value) return name;
    return "?";
}

/// "'foo' is no shading; expected one of general, povray".
template <typename T, std::size_t N>
std::string unknown_name_text(const NameTable<T, N>& table, std::string_view what, std::string_view name) {
    std::string text = fmt::format("'{}' is no {}; expected one of ", name, what);
    for (std::size_t i = 0; i < N; ++i) text += fmt::format("{}{}", i ? ", " : "", table[i].first);
    return text;
}

/// The value of `name`; throws OptionError with `unknown_name_text`.
template <typename T, std::size_t N>
T value_of_name(const NameTable<T, N>& table, std::string_view what, std::string_view name) {
    if (const std::optional<T> value = find_name(table, name)) return *value;
    throw OptionError(unknown_name_text(table, what, name));
}

}  // namespace rt
