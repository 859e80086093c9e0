#include "syntax/quadric_box.h"

namespace rt {

namespace {

/// Where a box without end ends.
constexpr double far = 1e10;

/// Least value of q x^2 + l x between two places.
double least(double q, double l, double from, double to) {
    const double ends = std::fmin((q * from + l) * from, (q * to + l) * to);
    const double vertex = -l / (2.0 * q);
    return q > 0.0 && vertex > from && vertex < to ? -l * l / (4.0 * q) : ends;
}

/// Cuts the interval to where q x^2 + l x + k <= 0, q >= 0.
void cut(double q, double l, double k, double& from, double& to) {
    double low = -infinity, high = infinity;
    if (q > 0.0) {
        const double root = std::sqrt(std::fmax(l * l - 4.0 * q * k, 0.0));
        low = (-l - root) / (2.0 * q), high = (-l + root) / (2.0 * q);
    } else if (l != 0.0) {
        (l > 0.0 ? high : low) = -k / l;
    }
    from = std::fmax(from, low), to = std::fmin(to, high);
}

}  // namespace

Quadric moved(const Quadric& q, const Transform& t) {
    const Mat3 s(q.squares.x, q.products.x / 2.0, q.products.y / 2.0, q.products.x / 2.0, q.squares.y, q.products.z / 2.0,
                 q.products.y / 2.0, q.products.z / 2.0, q.squares.z);
    const Mat3& a = t.inverse_linear;
    const Vec3& b = t.inverse_offset;
    const Mat3 there = glm::transpose(a) * s * a;
    const Vec3 linear = (2.0 * (s * b) + q.linear) * a;
    return {Vec3(there[0][0], there[1][1], there[2][2]), 2.0 * Vec3(there[1][0], there[2][0], there[2][1]), linear,
            dot(b, s * b) + dot(q.linear, b) + q.constant};
}

Bounds cut_to(Quadric q, const Bounds& box) {
    constexpr double turned = 1e-9;
    if (max_abs(q.products) > turned) return box;
    int positive = 0, negative = 0;
    for (int i = 0; i < 3; ++i) {
        if (std::fabs(q.squares[i]) <= turned) q.squares[i] = 0.0;
        positive += q.squares[i] > 0.0, negative += q.squares[i] < 0.0;
    }
    if (negative > positive) {
        q = {-q.squares, q.products, -q.linear, -q.constant};
        std::swap(positive, negative);
    }
    double center = q.constant;
    for (int i = 0; i < 3; ++i)
        if (q.squares[i] != 0.0) center -= q.linear[i] * q.linear[i] / (4.0 * q.squares[i]);
    if (negative > 0 && center > 0.0) return box;  // two sheets
    const Bounds inside = common(box, {Vec3(-far), Vec3(far)});
    Bounds left = inside;
    for (int i = 0; i < 3; ++i) {
        if (q.squares[i] < 0.0) continue;
        double others = q.constant;
        for (int j = 0; j < 3; ++j)
            if (j != i) others += least(q.squares[j], q.linear[j], inside.min[j], inside.max[j]);
        double from = inside.min[i], to = inside.max[i];
        cut(q.squares[i], q.linear[i], others, from, to);
        left.min[i] = from, left.max[i] = to;
    }
    return left;
}

}  // namespace rt
