// Whether this build has the module for picture formats beyond PNG and PPM: it is optional.
#pragma once

#include <filesystem>

namespace rt {

/// The module lies in the build folder, the tests in a folder of it.
inline bool has_image_module() {
    const std::filesystem::path tests = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    return std::filesystem::exists(tests.parent_path() / "raytrace_images.so");
}

}  // namespace rt

/// Ends a test that needs the module in a build that has none.
#define NEEDS_IMAGE_MODULE() \
    if (!has_image_module()) GTEST_SKIP() << "built without OpenImageIO"
