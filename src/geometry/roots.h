// Real roots of functions and polynomials. Every polynomial is asked for on [0, 1]: whoever asks chooses the variable so that it is.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace rt {

inline int sign_of(double x) { return (x > 0.0) - (x < 0.0); }

/// Newton's method kept inside a bracket: `f` is monotone on [lo, hi] and `rising` or falling through zero there. Halves the bracket
/// whenever a step leaves it or shrinks too slowly, so the number of steps is bounded. Accurate to `tolerance` or to the noise of `f`.
template <typename F, typename D>
double bracketed_root(double lo, double hi, bool rising, double tolerance, F f, D derivative) {
    constexpr int most_steps = 100;
    double x = 0.5 * (lo + hi);
    double last_step = hi - lo;
    for (int i = 0; i < most_steps; ++i) {
        const double fx = f(x);
        if (fx == 0.0) return x;
        ((fx < 0.0) == rising ? lo : hi) = x;
        double next = x - fx / derivative(x);
        if (!(next > lo && next < hi && std::fabs(next - x) <= 0.5 * last_step)) next = 0.5 * (lo + hi);
        last_step = std::fabs(next - x);
        x = next;
        if (!(last_step > tolerance)) return x;
    }
    return x;
}

/// The highest degree that `SignChanges` takes.
inline constexpr std::size_t highest_degree = 35;

/// Where a polynomial changes its sign on [0, 1], in increasing order: its roots of odd multiplicity. Where it only touches zero it has
/// none.
///
/// The polynomial is written in Bernstein's basis, whose coefficients change sign at least as often as the polynomial does (Lane and
/// Riesenfeld 1981, "Bounds on a Polynomial"): pieces without a change are dropped, pieces with one are bracketed, others are halved.
/// Halving takes means, so nothing grows and each coefficient is wrong by at most some n units in the last place of the largest: what is
/// found are the sign changes of a polynomial whose coefficients differ from the given ones by no more than that. Two roots nearer to each
/// other than such a difference may be taken for none.
class SignChanges {
public:
    enum class Basis {
        powers,    ///< c[0] + c[1] x + c[2] x^2 + ...
        bernstein  ///< sum of c[i] C(n, i) x^i (1 - x)^(n - i)
    };
    /// At most highest_degree + 1 coefficients. `sign_before` is that of the polynomial just before 0 where it goes on there, for roots
    /// that lie exactly at 0; 0 if nothing is before. Not finite coefficients: no roots.
    explicit SignChanges(std::span<const double> c, Basis basis = Basis::powers, int sign_before = 0);

    /// The next place of a change beyond `after`; false if there is none. Changes up to `after` cost less to pass over than to find.
    bool next(double after, double& x);
    /// After the last one: the sign just before 1; `sign_before` if the polynomial is zero throughout.
    int sign() const { return sign_; }

private:
    /// A piece [begin, begin + length] and its coefficients in the stack, from `pieces_[i * (degree_ + 1)]` on.
    struct Place {
        double begin, length;
    };
    static constexpr std::size_t most_pieces = 64;

    double root(const Place& place, const double* b, bool rising) const;
    void halve(Place& place, double* b);

    std::size_t degree_ = 0;
    std::size_t count_ = 0;
    int sign_ = 0;
    std::array<Place, most_pieces> places_;
    std::array<double, most_pieces*(highest_degree + 1)> pieces_;
};

}  // namespace rt
