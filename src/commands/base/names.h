// One table of names per thing that can be selected by name, whether on the command line, in an INI file or in a scene.
#pragma once

#include "core/name_table.h"
#include "film/image_file.h"
#include "trace/options.h"
#include "world/compile.h"

namespace rt {

inline constexpr NameTable<ShadingModel, 2> shading_names{{{"general", ShadingModel::general}, {"povray", ShadingModel::povray}}};
inline constexpr NameTable<Distances, 2> distances_names{{{"scaled", Distances::scaled}, {"povray", Distances::povray}}};
inline constexpr NameTable<ShadowKind, 3> shadow_names{
    {{"full", ShadowKind::full}, {"opaque", ShadowKind::opaque}, {"none", ShadowKind::none}}};
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

}  // namespace rt
