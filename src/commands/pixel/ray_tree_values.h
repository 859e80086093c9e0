// A recorded ray as a JSON value, for every text and page that tells of one. The fields: ray_tree_json.h.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "scene/scene.h"
#include "trace/ray_log.h"
#include "world/world.h"

namespace rt {

/// Keeps its fields in the order in which they were set.
using Json = nlohmann::ordered_json;

/// A number that reads back to the same bits; one that is not finite is its name as a string.
Json json_of(double x);
Json json_of(const Vec3& v);
Json json_of(const Ray& ray);
Json json_of(const CameraBasis& camera);
/// One entry of `samples`.
Json json_of(const Scene& scene, const RayNode& node);

}  // namespace rt
