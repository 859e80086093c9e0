// A supposed mistake and how much of a picture's difference it explains.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rt {

/// How far a picture is from what was predicted for it.
struct Misfit {
    /// Differences below it are taken for rounding, of full scale: bytes that were rounded twice, steep curves.
    static constexpr float visible = 0.02f;

    double differing = 0.0;  ///< pixels with a channel that differs visibly
    double squares = 0.0;    ///< sum over the pixels of the largest squared channel difference

    void add(float difference, double weight = 1.0) {
        if (difference >= visible) differing += weight;
        squares += weight * static_cast<double>(difference) * static_cast<double>(difference);
    }
    bool operator==(const Misfit&) const = default;
};

/// What a hypothesis leaves of a difference, 0 (nothing) to 1 (all of it) and beyond (it makes it worse): the mean of the shares of
/// pixels and of squares that are left.
inline double share_left(const Misfit& left, const Misfit& whole) {
    const auto share = [](double a, double b) { return b > 0.0 ? a / b : 1.0; };
    return 0.5 * (share(left.differing, whole.differing) + share(left.squares, whole.squares));
}

struct Finding {
    std::string cause;     ///< two or three words, e.g. "missing shadows"
    std::string evidence;  ///< a sentence with numbers, without the full stop
    double left = 1.0;     ///< share of the difference that it does not explain
    double freedom = 0.0;  ///< handicap of a hypothesis that fits itself to the picture
};

/// The causes in the order of what speaks for them.
struct Verdicts {
    std::string cause;  ///< empty if none fits clearly
    std::vector<std::string> lines;
};

/// The cause that explains at least 85 % of the difference (70 % if no other comes near it), the best one; among equals the first. Its
/// evidence comes first, then
/// other causes that explain it as well. If none does: that it is so, and the best two.
Verdicts choose(std::vector<Finding> findings);

}  // namespace rt
