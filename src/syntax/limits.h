// The limits of what a scene file may ask for, by the names that the command line has for them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "syntax/parser.h"

namespace rt {

struct SceneLimit {
    std::string_view name;
    std::string_view meaning;
    std::variant<int ParseOptions::*, std::size_t ParseOptions::*> member;
    std::uint64_t highest = std::uint64_t{1} << 62;  ///< that can be set; the least is 1
    bool bytes = false;                              ///< else a count
    std::string_view standard = {};                  ///< in words, of what is not the same on every machine
};

/// All of them, in the order in which they are told.
std::span<const SceneLimit> scene_limits();

std::uint64_t value_of(const SceneLimit& limit, const ParseOptions& options);
/// `value` is in 1..limit.highest.
void set_value(const SceneLimit& limit, ParseOptions& options, std::uint64_t value);

/// The sentence behind an error that tells how to allow more; begins with a blank.
std::string allow_more(std::string_view name);

}  // namespace rt
