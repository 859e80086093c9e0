// Whether this build has the module for picture formats beyond PNG and PPM: it is optional.
#pragma once

#include <filesystem>

namespace rt {

inline bool has_image_module() { return std::filesystem::exists(std::filesystem::path(PROGRAM).parent_path() / "raytrace_images.so"); }

}  // namespace rt

/// Ends a test that needs the module in a build that has none.
#define NEEDS_IMAGE_MODULE() \
    if (!has_image_module()) GTEST_SKIP() << "built without OpenImageIO"
