#include "syntax/words.h"

#include <array>
#include <cstddef>
#include <iterator>

namespace rt {

namespace {

constexpr std::string_view spelling(std::string_view enumerator) {
    if (!enumerator.empty() && enumerator.back() == '_') enumerator.remove_suffix(1);
    return enumerator;
}

constexpr std::string_view spellings[]{std::string_view{},
#define RT_SPELLING(name) spelling(#name),
                                       RT_WORDS(RT_SPELLING)
#undef RT_SPELLING
};

constexpr std::size_t slots = 2048;  // a power of two, a quarter full
static_assert(slots >= 4 * std::size(spellings));

/// Four characters and the length tell nearly all words apart: a word is found at the first slot nine times in ten, at the third at most.
constexpr std::size_t hash(std::string_view name) {
    const auto character = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(name[i])); };
    const std::size_t n = name.size();
    return (581 * character(0) + 798 * character(n > 1) + 948 * character(n / 2) + 1121 * character(n - 1) + 1188 * n) % slots;
}

/// Open addressing with linear probing; 0 marks a free slot.
constexpr std::array<std::uint16_t, slots> make_table() {
    std::array<std::uint16_t, slots> table{};
    for (std::size_t i = 1; i < std::size(spellings); ++i) {
        std::size_t slot = hash(spellings[i]);
        while (table[slot] != 0) slot = (slot + 1) % slots;
        table[slot] = static_cast<std::uint16_t>(i);
    }
    return table;
}

constexpr auto table = make_table();

}  // namespace

Word find_word(std::string_view name) {
    if (name.empty()) return Word::none;
    for (std::size_t slot = hash(name); table[slot] != 0; slot = (slot + 1) % slots)
        if (spellings[table[slot]] == name) return static_cast<Word>(table[slot]);
    return Word::none;
}

std::string_view text(Word w) { return spellings[static_cast<std::size_t>(w)]; }

}  // namespace rt
