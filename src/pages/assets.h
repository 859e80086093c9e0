// The page assets of this folder, compiled into the program.
#pragma once

#include <string_view>

namespace rt {

/// The text of an asset by its file name, e.g. "page.css"; empty if there is none.
std::string_view page_asset(std::string_view name);

}  // namespace rt
