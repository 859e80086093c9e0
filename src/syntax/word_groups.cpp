#include "syntax/word_groups.h"

#include <algorithm>
#include <array>

namespace rt {

namespace {

constexpr std::array float_functions{Word::abs,         Word::acos,       Word::acosh,       Word::asc,     Word::asin,
                                     Word::asinh,       Word::atan,       Word::atan2,       Word::atanh,   Word::ceil,
                                     Word::bitwise_and, Word::bitwise_or, Word::bitwise_xor, Word::clock,   Word::clock_on,
                                     Word::cos,         Word::cosh,       Word::defined,     Word::degrees, Word::dimension_size,
                                     Word::dimensions,  Word::div,        Word::exp,         Word::false_,  Word::file_exists,
                                     Word::floor,       Word::inside,     Word::int_,        Word::ln,      Word::log,
                                     Word::max,         Word::min,        Word::mod,         Word::no,      Word::now,
                                     Word::off,         Word::on,         Word::pi,          Word::pow,     Word::prod,
                                     Word::radians,     Word::rand,       Word::seed,        Word::select,  Word::sin,
                                     Word::sinh,        Word::sqrt,       Word::strcmp,      Word::strlen,  Word::sum,
                                     Word::tan,         Word::tanh,       Word::true_,       Word::val,     Word::vdot,
                                     Word::version,     Word::vlength,    Word::yes};

constexpr std::array vector_functions{Word::max_extent, Word::min_extent, Word::trace,   Word::vaxis_rotate,
                                      Word::vcross,     Word::vnormalize, Word::vrotate, Word::vturbulence,
                                      Word::x,          Word::y,          Word::z};

constexpr std::array color_keywords{Word::alpha, Word::blue,  Word::filter, Word::gray,  Word::green,
                                    Word::red,   Word::rgb,   Word::rgbf,   Word::rgbft, Word::rgbt,
                                    Word::srgb,  Word::srgbf, Word::srgbft, Word::srgbt, Word::transmit};

constexpr std::array string_functions{Word::chr,    Word::concat, Word::datetime, Word::str,
                                      Word::strlwr, Word::strupr, Word::substr,   Word::vstr};

constexpr std::size_t word_count = 1
#define RT_COUNT(name) +1
    RT_WORDS(RT_COUNT)
#undef RT_COUNT
    ;

constexpr std::array<WordGroup, word_count> make_groups() {
    std::array<WordGroup, word_count> groups{};
    for (const Word w : float_functions) groups[static_cast<std::size_t>(w)] = WordGroup::float_function;
    for (const Word w : vector_functions) groups[static_cast<std::size_t>(w)] = WordGroup::vector_function;
    for (const Word w : color_keywords) groups[static_cast<std::size_t>(w)] = WordGroup::color_keyword;
    for (const Word w : string_functions) groups[static_cast<std::size_t>(w)] = WordGroup::string_function;
    return groups;
}

constexpr auto groups = make_groups();

}  // namespace

WordGroup group_of(Word w) { return groups[static_cast<std::size_t>(w)]; }

std::string_view message_name(Word w) {
    switch (w) {
        case Word::colour:
            return "color";
        case Word::colour_map:
            return "color_map";
        case Word::fade_color:
            return "fade_colour";
        case Word::quick_colour:
            return "quick_color";
        case Word::use_colour:
            return "use_color";
        default:
            return text(w);
    }
}

}  // namespace rt
