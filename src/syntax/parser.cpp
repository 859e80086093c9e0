#include "syntax/parser.h"

#include <fmt/format.h>

#include <new>

#include "syntax/blocks.h"
#include "syntax/file_text.h"
#include "syntax/reader_state.h"

namespace rt {

namespace {

constexpr std::string_view version_missing =
    "This scene did not contain a #version directive. Please be aware that as of POV-Ray 3.7, unless already specified via an INI option, "
    "a "
    "#version is expected as the first declaration in a scene file. POV-Ray may apply settings to some features that are intended to "
    "maintain compatibility with pre-3.7 scenes. You are strongly encouraged to add a #version statement to the scene to make your intent "
    "clear. Future versions of POV-Ray may make the presence of a #version statement mandatory.";
constexpr std::string_view version_late =
    "This scene had other declarations preceding the first #version directive. Please be aware that as of POV-Ray 3.7, unless already "
    "specified via an INI option, a #version is expected as the first declaration in a scene file. If this is not done, POV-Ray may apply "
    "compatibility settings to some features that are intended to make pre-3.7 scenes render as designed. You are strongly encouraged to "
    "add a #version statement to the scene to make your intent clear. Future versions of POV-Ray may make the presence of a #version "
    "mandatory.";

constexpr std::string_view experimental_spline =
    "This rendering uses the following experimental feature(s): spline. The design and implementation of these features is likely to "
    "change in future versions of POV-Ray. Backward compatibility with the current implementation is not guaranteed.";

}  // namespace

Scene parse_file(const std::string& path, const ParseOptions& options, const MessageSink& messages) {
    auto text = read_file_text(path, options.max_file_bytes);
    if (!text) throw SceneError(fmt::format("File '{}': Parse Error: Cannot open input file.", path));
    return parse_text({path, std::move(*text)}, options, messages);
}

Scene parse_text(SourceFile file, const ParseOptions& options, const MessageSink& messages) {
    Scene scene;
    Reader reader(options, scene, messages);
    reader.open(std::move(file));
    try {
        parse_scene(reader);
    } catch (const std::bad_alloc&) {
        reader.fail_memory();
    }
    if (!reader.version_stated()) reader.warn({}, version_missing);
    if (reader.version_came_late()) reader.warn({}, version_late);
    if (reader.any_spline()) reader.warn({}, experimental_spline);
    return scene;
}

}  // namespace rt
