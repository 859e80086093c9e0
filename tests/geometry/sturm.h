// Sturm's theorem in quadruple precision: how many roots a polynomial has.
#pragma once

#include <vector>

#include "tests/geometry/quad.h"

namespace rt::test {

using Polynomial = std::vector<Quad>;  // highest power first

inline Quad value(const Polynomial& p, Quad x) {
    Quad sum = 0;
    for (const Quad c : p) sum = sum * x + c;
    return sum;
}

inline Polynomial negative_remainder(Polynomial a, const Polynomial& b) {
    while (a.size() >= b.size()) {
        const Quad k = a[0] / b[0];
        for (std::size_t i = 0; i < b.size(); ++i) a[i] -= k * b[i];
        a.erase(a.begin());
    }
    for (Quad& c : a) c = -c;
    while (!a.empty() && a[0] == 0) a.erase(a.begin());
    return a;
}

/// Number of different real roots in (lo, hi].
inline int count_roots(const Polynomial& p, Quad lo, Quad hi) {
    if (!(lo < hi)) return 0;
    std::vector<Polynomial> chain{p, {}};
    for (std::size_t i = 0; i + 1 < p.size(); ++i) chain[1].push_back(p[i] * static_cast<int>(p.size() - 1 - i));
    for (;;) {
        Polynomial next = negative_remainder(chain[chain.size() - 2], chain.back());
        if (next.empty()) break;
        chain.push_back(next);
        if (next.size() == 1) break;
    }
    const auto variations = [&](Quad x) {
        int changes = 0;
        Quad last = 0;
        for (const Polynomial& q : chain) {
            const Quad y = value(q, x);
            if (y == 0) continue;
            changes += last * y < 0;
            last = y;
        }
        return changes;
    };
    return variations(lo) - variations(hi);
}

}  // namespace rt::test
