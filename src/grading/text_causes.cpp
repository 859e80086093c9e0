#include "grading/text_causes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <iterator>
#include <vector>

#include "grading/text_difference.h"

namespace rt {

namespace {

struct Number {
    double value = 0.0;
    double last_place = 1.0;  ///< what one more in its last digit is worth
};

/// A text as its numbers, and what is left with a mark in the place of each.
struct Parts {
    std::vector<Number> numbers;
    std::string frame;
};

bool is_decimal_digit(char c) { return c >= '0' && c <= '9'; }

Parts parts_of(const std::vector<std::string>& lines) {
    Parts parts;
    for (const std::string& line : lines) {
        for (std::size_t i = 0; i < line.size();) {
            const bool sign =
                (line[i] == '-' || line[i] == '.') && i + 1 < line.size() && (is_decimal_digit(line[i + 1]) || line[i + 1] == '.');
            const bool inside_word = i > 0 && (std::isalnum(static_cast<unsigned char>(line[i - 1])) || line[i - 1] == '_');
            Number number;
            const char* const begin = line.data() + i;
            if (!inside_word && (sign || is_decimal_digit(line[i])))
                if (const auto [end, error] = std::from_chars(begin, line.data() + line.size(), number.value); error == std::errc()) {
                    const std::string_view text(begin, static_cast<std::size_t>(end - begin));
                    if (const std::size_t point = text.find('.'); point != text.npos)
                        number.last_place = std::pow(10.0, -static_cast<double>(text.size() - point - 1));
                    parts.numbers.push_back(number);
                    parts.frame += '#';
                    i += text.size();
                    continue;
                }
            parts.frame += line[i++];
        }
        parts.frame += '\n';
    }
    return parts;
}

std::string letters(const std::string& text) {
    std::string only;
    std::copy_if(text.begin(), text.end(), std::back_inserter(only),
                 [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; });
    return only;
}

/// Whether the lines of `some` are in `all`, in their order.
bool in_order(const std::vector<std::string>& some, const std::vector<std::string>& all) {
    std::size_t found = 0;
    for (const std::string& line : all)
        if (found < some.size() && line == some[found]) ++found;
    return found == some.size();
}

/// Texts with the same frame differ in numbers alone.
TextCause cause_of_numbers(const std::vector<Number>& expected, const std::vector<Number>& actual) {
    std::size_t differing = 0, rounded = 0, negated = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const Number &a = expected[i], &b = actual[i];
        const double apart = std::fabs(a.value - b.value), place = std::max(a.last_place, b.last_place);
        if (apart == 0.0) continue;
        ++differing;
        const double slack = 2.001 * place;
        rounded += apart <= slack;
        negated += apart > slack && std::fabs(a.value + b.value) <= slack;
    }
    const std::string count = fmt::format("{} of {} numbers differ", differing, expected.size());
    if (differing == 0) return {"another format", "the numbers are the same, written otherwise"};
    if (rounded == differing) return {"rounding", fmt::format("{}, all by at most two units of the last place", count)};
    if (rounded + negated == differing) return {"sign", fmt::format("{}, {} of them by their sign alone", count, negated)};
    return {"other numbers", fmt::format("{}, {} of them by at most two units of the last place", count, rounded)};
}

}  // namespace

TextCause text_cause(std::string_view expected, std::string_view actual) {
    const std::vector<std::string> a = compared_lines(expected), b = compared_lines(actual);
    const std::string lines = fmt::format("{} lines, {} expected", b.size(), a.size());
    const Parts pa = parts_of(a), pb = parts_of(b);
    if (pa.frame == pb.frame) return cause_of_numbers(pa.numbers, pb.numbers);
    if (b.size() < a.size() && in_order(b, a)) return {"missing lines", lines + "; those that are there are right"};
    if (b.size() > a.size() && in_order(a, b)) return {"lines too many", lines + "; all that are expected are among them"};
    std::vector<std::string> sorted_a = a, sorted_b = b;
    std::sort(sorted_a.begin(), sorted_a.end()), std::sort(sorted_b.begin(), sorted_b.end());
    if (sorted_a == sorted_b) return {"another order", fmt::format("the same {} lines in another order", a.size())};
    const auto same_value = [](const Number& x, const Number& y) {
        return std::fabs(x.value - y.value) <= 0.501 * std::max(x.last_place, y.last_place);
    };
    if (!pa.numbers.empty() && letters(pa.frame) == letters(pb.frame) && pa.numbers.size() == pb.numbers.size() &&
        std::equal(pa.numbers.begin(), pa.numbers.end(), pb.numbers.begin(), same_value))
        return {"another format",
                fmt::format("all {} numbers are right; what stands between them, or their digits, is not", pa.numbers.size())};
    if (b.size() < a.size()) return {"missing lines", lines};
    if (b.size() > a.size()) return {"lines too many", lines};
    return {"other words", fmt::format("{}; words differ, not only numbers", lines)};
}

}  // namespace rt
