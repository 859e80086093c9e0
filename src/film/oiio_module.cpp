#include "film/oiio_module.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "core/source.h"

namespace rt {
namespace {

constexpr const char* file_name = "raytrace_images.so";

const RaytraceImages* functions_of(void* library) {
    const auto entry = reinterpret_cast<RaytraceEntry*>(dlsym(library, "raytrace_images"));
    const RaytraceImages* functions = entry ? entry() : nullptr;
    return functions && functions->version == raytrace_images_version ? functions : nullptr;
}

const RaytraceImages& load() {
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    std::string reason = fmt::format("there is no {} beside the program", file_name);
    for (const auto& place : {folder / file_name, folder.parent_path() / file_name}) {
        if (!std::filesystem::exists(place, error)) continue;
        void* library = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
        const RaytraceImages* functions = library ? functions_of(library) : nullptr;
        if (functions) return *functions;
        reason = library ? fmt::format("'{}' belongs to another version of the program", place.string()) : dlerror();
    }
    throw OptionError(
        fmt::format("Picture formats other than PNG and PPM need OpenImageIO, and {}. Install the package "
                    "libopenimageio-dev and build again.",
                    reason));
}

}  // namespace

const RaytraceImages& image_module() {
    static const RaytraceImages& module = load();
    return module;
}

}  // namespace rt
