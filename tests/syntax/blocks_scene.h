// Parsing a piece of a scene in tests of blocks: the scene, its messages, its error.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "syntax/parser.h"

namespace rt {

struct ParsedScene {
    Scene scene;
    std::vector<std::string> messages;  ///< without the excerpts
    std::string error;                  ///< text after "Parse Error: ", empty if the scene was read
};

inline std::string first_line(std::string_view text) { return std::string(text.substr(0, text.find('\n'))); }

/// Text of a message without its place and kind.
inline std::string bare(std::string_view message, std::string_view kind) {
    const std::string line = first_line(message);
    const std::size_t at = line.find(kind);
    return at == std::string::npos ? line : line.substr(at + kind.size());
}

/// Parses `text` after a head of one line that states version and gamma, so that only its own messages come.
inline ParsedScene parse_block(const std::string& text, ParseOptions options = {},
                               const std::string& head = "#version 3.7; global_settings { assumed_gamma 1 } ") {
    ParsedScene parsed;
    const MessageSink sink = [&](std::string_view message) {
        if (message.find("No objects in scene") == std::string_view::npos) parsed.messages.push_back(first_line(message));
    };
    try {
        parsed.scene = parse_text({"test.pov", head + text}, options, sink);
    } catch (const SceneError& error) {
        parsed.error = bare(error.what(), "Parse Error: ");
    }
    return parsed;
}

/// The only object's shape as an S; fails the test by an exception if there is none.
template <typename S>
S only_shape(const std::string& text) {
    const ParsedScene parsed = parse_block(text);
    if (!parsed.error.empty()) throw std::runtime_error(parsed.error);
    return std::get<S>(parsed.scene.objects.at(0).shape);
}

inline PlainTexture layer(const Object& object, std::size_t index = 0) {
    return std::get<PlainTexture>((**object.texture).at(index).content);
}

/// Pigment of the one sphere `sphere { 0, 1 MODIFIERS }`.
inline Object sphere_with(const std::string& modifiers) { return parse_block("sphere { 0, 1 " + modifiers + " }").scene.objects.at(0); }
inline PigmentColor color_of(const Object& object, std::size_t index = 0) {
    return std::get<PigmentColor>(layer(object, index).pigment.content);
}

}  // namespace rt
