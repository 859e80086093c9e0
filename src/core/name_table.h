// Things that can be selected by name: one table each, which reads, prints and lists the names.
#pragma once

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/source.h"

namespace rt {

template <typename T, std::size_t N>
using NameTable = std::array<std::pair<std::string_view, T>, N>;

template <typename T, std::size_t N>
std::optional<T> find_name(const NameTable<T, N>& table, std::string_view name) {
    for (const auto& [known, value] : table)
        if (known == name) return value;
    return std::nullopt;
}

template <typename T, std::size_t N>
std::string_view name_of(const NameTable<T, N>& table, T value) {
    for (const auto& [name, known] : table)
        if (known == value) return name;
    return "?";
}

/// "'foo' is no shading; expected one of general, povray".
template <typename T, std::size_t N>
std::string unknown_name_text(const NameTable<T, N>& table, std::string_view what, std::string_view name) {
    std::string text = fmt::format("'{}' is no {}; expected one of ", name, what);
    for (std::size_t i = 0; i < N; ++i) text += fmt::format("{}{}", i ? ", " : "", table[i].first);
    return text;
}

/// The value of `name`; throws OptionError with `unknown_name_text`.
template <typename T, std::size_t N>
T value_of_name(const NameTable<T, N>& table, std::string_view what, std::string_view name) {
    if (const std::optional<T> value = find_name(table, name)) return *value;
    throw OptionError(unknown_name_text(table, what, name));
}

}  // namespace rt
