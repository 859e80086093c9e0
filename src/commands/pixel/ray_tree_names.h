// The words of a pixel's ray tree in JSON, for who writes and who reads them.
#pragma once

#include "commands/base/names.h"
#include "trace/ray_log.h"

namespace rt {

inline constexpr std::string_view ray_tree_format = "raytrace ray tree 1";

inline constexpr NameTable<RayNode::Kind, 5> ray_kind_names{{{"camera", RayNode::Kind::camera},
                                                             {"reflected", RayNode::Kind::reflected},
                                                             {"refracted", RayNode::Kind::refracted},
                                                             {"straight", RayNode::Kind::straight},
                                                             {"total", RayNode::Kind::total}}};
inline constexpr NameTable<RayNode::End, 4> ray_end_names{{{"surface", RayNode::End::surface},
                                                           {"background", RayNode::End::background},
                                                           {"level", RayNode::End::level},
                                                           {"weight", RayNode::End::weight}}};

}  // namespace rt
