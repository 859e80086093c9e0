// Runs the parser on text in memory and keeps what came out.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "syntax/parser.h"

namespace rt {

struct Outcome {
    std::optional<Scene> scene;
    std::string error;                  ///< the complete text of a SceneError or LimitError
    std::vector<std::string> messages;  ///< except the advice on `#version` and gamma that ends every old scene
    bool limit = false;                 ///< it was a LimitError

    /// All messages in one string, each on its own line.
    std::string log() const {
        std::string text;
        for (const std::string& message : messages) text += message + "\n";
        return text;
    }
};

using Files = std::map<std::string, std::string>;

inline Outcome read_scene(const std::string& text, ParseOptions options = {}, const Files& files = {}) {
    if (!options.read_include) {
        options.read_include = [&files](const std::string& path) -> std::optional<std::string> {
            const auto found = files.find(path);
            return found == files.end() ? std::nullopt : std::optional(found->second);
        };
    }
    Outcome outcome;
    const MessageSink sink = [&](std::string_view message) {
        for (const char* advice : {"Parse Warning: assumed_gamma not", "Possible Parse Error: assumed_gamma not",
                                   "Parse Warning: This scene did not", "Parse Warning: This scene had other"})
            if (message.starts_with(advice)) return;
        if (message.find("No objects in scene.") == std::string_view::npos) outcome.messages.emplace_back(message);
    };
    try {
        outcome.scene = parse_text({"t.pov", text}, options, sink);
    } catch (const SceneError& e) {
        outcome.error = e.what();
    } catch (const LimitError& e) {
        outcome.error = e.what();
        outcome.limit = true;
    }
    return outcome;
}

/// What the error says after "Parse Error: ", without the excerpt; the whole message if it has no such part.
inline std::string error_text(const std::string& scene, const ParseOptions& options = {}, const Files& files = {}) {
    const std::string error = read_scene(scene, options, files).error;
    const std::size_t begin = error.find("Parse Error: ");
    if (begin == std::string::npos) return error;
    return error.substr(begin + 13, error.find('\n') - begin - 13);
}

/// What `#debug` writes, or the error if there was one.
inline std::string debug_text(const std::string& scene, const ParseOptions& options = {}, const Files& files = {}) {
    const Outcome outcome = read_scene(scene, options, files);
    if (!outcome.error.empty()) return outcome.error;
    std::string text;
    for (const std::string& message : outcome.messages) text += message;
    return text;
}

}  // namespace rt
