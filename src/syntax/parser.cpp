#include "syntax/parser.h"

#include <fmt/format.h>

#include "syntax/blocks.h"
#include "syntax/file_text.h"
#include "syntax/reader_state.h"

namespace rt {

namespace {

constexpr std::string_view gamma_unstated =
    "assumed_gamma not specified in this POV-Ray 3.7 or later scene. Future versions of POV-Ray may consider this a fatal error. To avoid "
    "this warning, explicitly specify 'assumed_gamma 1.0' in the global_settings section.";
constexpr std::string_view version_late =
    "This scene had other declarations preceding the first #version directive. Please be aware that as of POV-Ray 3.7, unless already "
    "specified via an INI option, a #version is expected as the first declaration in a scene file.";

/// A scene of version 3.7 that says nothing of gamma is in linear light; an older one is written as it is.
void settle_gamma(Scene& scene, const Reader& reader, const MessageSink& messages) {
    if (scene.settings.gamma.kind != Gamma::Kind::legacy) return;
    if (!reader.version_stated() || reader.version() < 3.7) return;
    scene.settings.gamma = {Gamma::Kind::power, 1.0};
    messages(scene.sources.describe({}, "Possible Parse Error", gamma_unstated));
}

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
    parse_scene(reader);
    if (scene.objects.empty()) reader.warn({}, "No objects in scene.");
    settle_gamma(scene, reader, messages);
    if (reader.version_came_late()) reader.warn({}, version_late);
    return scene;
}

}  // namespace rt
