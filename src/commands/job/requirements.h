// What a scene needs of the program, read off the scene without building a world.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace rt {

/// Something that is not modelled, with its place; line and column count from 1.
struct MissingFeature {
    std::string name;
    std::string file;
    std::size_t line = 0;
    std::size_t column = 0;
};

struct Requirements {
    std::map<std::string, std::size_t> shapes;  ///< objects by shape
    std::size_t objects = 0;
    std::size_t triangles = 0;                  ///< those of meshes included
    std::map<std::string, std::size_t> lights;  ///< by kind
    std::string camera;
    std::string gamma;
    double language_version = 0.0;
    std::vector<std::string> features;  ///< sorted
    std::vector<std::string> includes;  ///< files read besides the scene itself
    std::vector<MissingFeature> missing;
};

/// Choices in comments that this version does not select count as not modelled; throws SceneError for one that has an unknown value.
Requirements requirements_of(const Scene& scene);

}  // namespace rt
