// Names chosen by a regular expression.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace rt {

/// Whether a name holds a match of the expression (ECMAScript's grammar). Throws OptionError naming the option `what` if it is none.
std::function<bool(const std::string& name)> name_pattern(std::string_view what, const std::string& expression);

}  // namespace rt
