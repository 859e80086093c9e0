#include "commands/job/edge_choices.h"

#include <algorithm>

#include "commands/base/names.h"
#include "commands/base/values.h"

namespace rt {

bool is_edge_key(std::string_view key) {
    return std::any_of(edge_keys.begin(), edge_keys.end(), [&](const EdgeKey& known) { return known.key == key; });
}

void choose_edges(EdgeOptions& edges, std::string_view key, std::string_view value) {
    if (key == "edges") {
        const std::optional<EdgeOptions::Kind> kind = find_name(edge_names, value);
        if (!kind) throw OptionError(fmt::format("{}: {}", key, unknown_name_text(edge_names, "kind of edges", value)));
        edges.kind = *kind;
    }
    if (key == "edge-width") edges.width = real_number(key, value, 1e-3, 1e3);
    if (key == "edge-color") edges.color = one_or_three(key, value, 0.0, 1e30);
    if (key == "edge-angle") edges.crease_angle = real_number(key, value, 0.0, 180.0);
}

}  // namespace rt
