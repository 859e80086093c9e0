#include "commands/base/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace rt {

namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// Damerau's distance in its restricted form: no letter is edited twice.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
    for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i)
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (same ? 0 : 1)});
            const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
            if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[a.size()][b.size()];
}

}  // namespace

std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
    constexpr std::size_t longest_compared = 64;   // the distance costs the product of both lengths
    constexpr std::size_t shortest_beginning = 4;  // of an option: two dashes and two letters
    if (word.size() > longest_compared) return "";
    std::size_t limit = std::max<std::size_t>(1, word.size() / 3);
    std::string best;
    for (const std::string& candidate : candidates) {
        if (candidate.size() > word.size() + limit) continue;  // so many insertions at least, and it may be megabytes
        const std::size_t distance = edit_distance(word, candidate);
        if (distance > limit || (distance == limit && !best.empty())) continue;
        limit = distance;
        best = candidate;
    }
    if (!best.empty() || word.size() < shortest_beginning) return best;
    for (const std::string& candidate : candidates)
        if (candidate.starts_with(word) && (best.empty() || candidate.size() < best.size())) best = candidate;
    return best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
    const std::string best = nearest_word(word, candidates);
    return best.empty() ? "" : fmt::format("; did you mean '{}'?", best);
}

}  // namespace rt
