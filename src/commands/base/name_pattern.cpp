#include "commands/base/name_pattern.h"

#include <fmt/format.h>

#include "core/source.h"

// Under the sanitizers GCC 12 takes members of <regex>'s own for uninitialised.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <regex>

namespace rt {

std::function<bool(const std::string&)> name_pattern(std::string_view what, const std::string& expression) {
    try {
        return [regex = std::regex(expression)](const std::string& name) { return std::regex_search(name, regex); };
    } catch (const std::regex_error&) {
        throw OptionError(fmt::format("--{}: '{}' is no regular expression", what, expression));
    }
}

}  // namespace rt
