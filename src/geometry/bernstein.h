// Polynomials on [0, 1] by their Bernstein coefficients: products, and what is left of them on a part of it.
#pragma once

#include <array>
#include <cstddef>

namespace rt {

constexpr double choose(std::size_t n, std::size_t k) {
    double c = 1.0;
    for (std::size_t i = 0; i < k; ++i) c = c * static_cast<double>(n - i) / static_cast<double>(i + 1);
    return c;
}

/// The product of two polynomials.
template <std::size_t p_size, std::size_t q_size>
std::array<double, p_size + q_size - 1> product(const std::array<double, p_size>& p, const std::array<double, q_size>& q) {
    constexpr std::size_t m = p_size - 1, n = q_size - 1;
    std::array<double, m + n + 1> r{};
    for (std::size_t i = 0; i <= m; ++i)
        for (std::size_t j = 0; j <= n; ++j) r[i + j] += choose(m, i) * choose(n, j) / choose(m + n, i + j) * (p[i] * q[j]);
    return r;
}

/// The polynomial on [from, to] as one on [0, 1]. With 0 and 1 the ends keep their values to the last bit.
template <std::size_t size>
std::array<double, size> part(const std::array<double, size>& p, double from, double to) {
    std::array<double, size> r;
    for (std::size_t j = 0; j < size; ++j) {  // its polar form with j arguments `to`, the others `from`
        std::array<double, size> mean = p;
        for (std::size_t step = 1; step < size; ++step) {
            const double x = step <= j ? to : from;
            for (std::size_t i = 0; i + step < size; ++i) mean[i] = (1.0 - x) * mean[i] + x * mean[i + 1];
        }
        r[j] = mean[0];
    }
    return r;
}

template <std::size_t size>
double value_at(std::array<double, size> p, double x) {
    for (std::size_t step = 1; step < size; ++step)
        for (std::size_t i = 0; i + step < size; ++i) p[i] = (1.0 - x) * p[i] + x * p[i + 1];
    return p[0];
}

template <std::size_t size>
double slope_at(const std::array<double, size>& p, double x) {
    std::array<double, size - 1> steps;
    for (std::size_t i = 0; i + 1 < size; ++i) steps[i] = static_cast<double>(size - 1) * (p[i + 1] - p[i]);
    return value_at(steps, x);
}

}  // namespace rt
