#include "geometry/roots.h"

#include <algorithm>

namespace rt {

namespace {

/// How often numbers in a row change their sign, zeros left out, and the first and last sign; 0 if all are zero.
struct Signs {
    int first = 0, last = 0;
    int changes = 0;
};

Signs signs_of(const double* b, std::size_t count) {
    Signs s;
    for (std::size_t i = 0; i < count; ++i) {
        const int sign = sign_of(b[i]);
        if (sign == 0) continue;
        if (s.first == 0) s.first = sign;
        s.changes += s.last != 0 && s.last != sign;
        s.last = sign;
    }
    return s;
}

/// From powers of x to Bernstein's basis on [0, 1]: b[j] = sum over i <= j of C(j, i) / C(n, i) c[i].
void to_bernstein(std::span<const double> c, double* b) {
    const std::size_t n = c.size() - 1;
    double choose_n = 1.0;  // C(n, i)
    for (std::size_t i = 0; i <= n; ++i) {
        b[i] = c[i] / choose_n;
        choose_n = choose_n * static_cast<double>(n - i) / static_cast<double>(i + 1);
    }
    // Sums of C(j, i) b[i], by the rows of Pascal's triangle.
    for (std::size_t row = 1; row <= n; ++row)
        for (std::size_t j = n; j >= row; --j) b[j] += b[j - 1];
}

/// Value and derivative at x by de Casteljau's means.
struct Tangent {
    double value, slope;
};

Tangent evaluate(const double* b, std::size_t n, double x) {
    if (n == 0) return {b[0], 0.0};
    std::array<double, highest_degree + 1> mean;
    std::copy(b, b + n + 1, mean.begin());
    for (std::size_t left = n; left > 1; --left)
        for (std::size_t j = 0; j < left; ++j) mean[j] += x * (mean[j + 1] - mean[j]);
    const double rise = mean[1] - mean[0];
    return {mean[0] + x * rise, static_cast<double>(n) * rise};
}

}  // namespace

SignChanges::SignChanges(std::span<const double> c, Basis basis, int sign_before) : sign_(sign_before) {
    if (basis == Basis::powers)
        while (!c.empty() && c.back() == 0.0) c = c.first(c.size() - 1);
    if (c.empty()) return;
    double finite = 0.0;
    for (const double x : c) finite += 0.0 * x;
    if (finite != 0.0) return;
    degree_ = c.size() - 1;
    if (basis == Basis::powers)
        to_bernstein(c, pieces_.data());
    else
        std::copy(c.begin(), c.end(), pieces_.begin());
    places_[0] = {0.0, 1.0};
    count_ = 1;
}

/// Of a piece whose coefficients change their sign an odd number of times.
double SignChanges::root(const Place& place, const double* b, bool rising) const {
    Tangent at{};
    const auto value = [&](double x) {
        at = evaluate(b, degree_, x);
        return at.value;
    };
    constexpr double tolerance = 0x1p-54;
    const double x = place.length <= tolerance
                         ? 0.5
                         : bracketed_root(0.0, 1.0, rising, tolerance / place.length, value, [&](double) { return at.slope; });
    return place.begin + place.length * x;
}

/// De Casteljau's halves: the right one stays in `b`'s place, the left one goes on top of it.
void SignChanges::halve(Place& place, double* b) {
    double* left = b + degree_ + 1;
    left[0] = b[0];
    for (std::size_t k = 1; k <= degree_; ++k) {
        for (std::size_t j = 0; j + k <= degree_; ++j) b[j] = 0.5 * (b[j] + b[j + 1]);
        left[k] = b[0];
    }
    const double half = 0.5 * place.length;
    places_[count_] = {place.begin, half};
    place = {place.begin + half, half};
    ++count_;
}

bool SignChanges::next(double after, double& x) {
    while (count_ > 0) {
        Place& place = places_[count_ - 1];
        double* b = pieces_.data() + (count_ - 1) * (degree_ + 1);
        const Signs signs = signs_of(b, degree_ + 1);
        const bool changed_before = sign_ != 0 && signs.first != 0 && sign_ != signs.first;
        if (changed_before) {  // at the very border of the two pieces
            sign_ = signs.first;
            x = place.begin;
            if (x > after) return true;
        }
        const bool too_short = count_ == most_pieces || place.length <= 0x1p-53;
        if (signs.changes > 1 && !too_short && place.begin + place.length > after) {
            halve(place, b);
            continue;
        }
        --count_;
        if (signs.last != 0) sign_ = signs.last;
        if (signs.changes % 2 == 0 || place.begin + place.length <= after) continue;
        x = root(place, b, signs.first < 0);
        if (x > after) return true;
    }
    return false;
}

}  // namespace rt
