// Choices about lines over the picture, from the command line or a scene's comments.
#pragma once

#include <array>
#include <string_view>

#include "trace/options.h"

namespace rt {

struct EdgeKey {
    std::string_view key, values;
};

/// The keys, which are options of the command line as well.
inline constexpr std::array<EdgeKey, 4> edge_keys{
    {{"edges", "NAME"}, {"edge-width", "PIXELS"}, {"edge-color", "X|R,G,B"}, {"edge-angle", "DEGREES"}}};

bool is_edge_key(std::string_view key);

/// Adds one choice; `key` is an edge key. Throws OptionError for a value that does not exist or is out of range.
void choose_edges(EdgeOptions& edges, std::string_view key, std::string_view value);

}  // namespace rt
