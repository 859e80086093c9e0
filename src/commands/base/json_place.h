// Where in a JSON text a value stands: nlohmann's parser keeps no places.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace rt {

/// The offset of the value at `path` (names of members, and indices of lists in decimal) in a text that is valid JSON; the
/// text's end if it is not there. Of members of one name it is the first.
std::size_t place_in_json(std::string_view json, std::span<const std::string> path);

}  // namespace rt
