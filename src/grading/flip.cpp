#include "grading/flip.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace rt {

namespace {

struct Triple {
    float x, y, z;
    bool operator==(const Triple&) const = default;
};

// Linear sRGB to CIE XYZ under D65, as exact quotients (the primaries' and the white point's chromaticities are short decimals), each row
// divided by its sum: the white point becomes (1, 1, 1), which is all that YyCxCz and L*a*b* need.
constexpr double x_weights[3] = {10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0};
constexpr double y_weights[3] = {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0};
constexpr double z_weights[3] = {1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0};

constexpr double sum(const double (&row)[3]) { return row[0] + row[1] + row[2]; }

/// The 3x3 matrix from linear RGB to XYZ / white, and its inverse by cofactors.
struct WhiteXyz {
    double forward[3][3], inverse[3][3];

    constexpr WhiteXyz() : forward{}, inverse{} {
        for (int i = 0; i < 3; ++i) {
            forward[0][i] = x_weights[i] / sum(x_weights);
            forward[1][i] = y_weights[i] / sum(y_weights);
            forward[2][i] = z_weights[i] / sum(z_weights);
        }
        const auto& m = forward;
        double determinant = 0.0;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
                inverse[j][i] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
            }
            determinant += m[0][i] * inverse[i][0];
        }
        for (auto& row : inverse) {
            for (double& value : row) value /= determinant;
        }
    }
};
constexpr WhiteXyz white_xyz;

Triple multiply(const double (&m)[3][3], const Triple& v) {
    const auto row = [&](int i) {
        return static_cast<float>(m[i][0]) * v.x + static_cast<float>(m[i][1]) * v.y + static_cast<float>(m[i][2]) * v.z;
    };
    return {row(0), row(1), row(2)};
}

/// "Linearised L*a*b*", an opponent space: Yy = 116 Y - 16, Cx = 500 (X - Y), Cz = 200 (Y - Z), all relative to white.
Triple yycxcz(const Triple& rgb) {
    const Triple v = multiply(white_xyz.forward, rgb);
    return {116.0f * v.y - 16.0f, 500.0f * (v.x - v.y), 200.0f * (v.y - v.z)};
}

/// Back to linear RGB, clamped to what a screen can show.
Triple shown_rgb(const Triple& opponent) {
    const float y = (opponent.x + 16.0f) / 116.0f;
    const Triple rgb = multiply(white_xyz.inverse, {y + opponent.y / 500.0f, y, y - opponent.z / 200.0f});
    return {std::clamp(rgb.x, 0.0f, 1.0f), std::clamp(rgb.y, 0.0f, 1.0f), std::clamp(rgb.z, 0.0f, 1.0f)};
}

/// Cube root of a number in 0.008..2 to one unit in the last place: a guess from the exponent, then two steps of Halley's iteration
/// (cubic convergence). The standard library's takes most of the time of a comparison.
float cube_root(float t) {
    float x = std::bit_cast<float>(std::bit_cast<std::uint32_t>(t) / 3 + 0x2a5137a0u);
    for (int i = 0; i < 2; ++i) {
        const float cube = x * x * x;
        x *= (cube + 2.0f * t) / (2.0f * cube + t);
    }
    return x;
}

/// The cube root of CIE L*a*b* with its linear part near black.
float lab_root(float t) {
    constexpr float delta = 6.0f / 29.0f;
    return t > delta * delta * delta ? cube_root(t) : t / (3.0f * delta * delta) + 4.0f / 29.0f;
}

/// CIE L*a*b* with the Hunt effect: colours fade with lightness, a* and b* are scaled by L* / 100.
Triple hunt_lab(const Triple& rgb) {
    const Triple v = multiply(white_xyz.forward, rgb);
    const float x = lab_root(v.x), y = lab_root(v.y), z = lab_root(v.z);
    const float lightness = 116.0f * y - 16.0f;
    return {lightness, 0.01f * lightness * 500.0f * (x - y), 0.01f * lightness * 200.0f * (y - z)};
}

/// HyAB distance: city block in lightness, Euclid in chroma; compressed by the power 0.7 (Abasi, Tehran, Fairchild 2019).
float compressed_hyab(const Triple& a, const Triple& b) {
    const float da = a.y - b.y, db = a.z - b.z;
    return std::pow(std::fabs(a.x - b.x) + std::sqrt(da * da + db * db), 0.7f);
}

/// Colour difference in 0..1: up to 0.4 of the largest possible one (green against blue) takes the range up to 0.95.
float redistributed(float difference, float largest) {
    constexpr float knee = 0.4f, value_at_knee = 0.95f;
    const float at_knee = knee * largest;
    if (difference < at_knee) return difference * (value_at_knee / at_knee);
    return value_at_knee + (difference - at_knee) / (largest - at_knee) * (1.0f - value_at_knee);
}

/// One Gaussian of a contrast sensitivity function a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees. In two dimensions the weight of a
/// separable kernel is the product of its two passes, hence the square root where two Gaussians are added.
struct Sensitivity {
    double a, b;
    Kernel kernel(bool square_root_of_weight) const {
        // The widest Gaussian (b = 0.04) is cut at three standard deviations; all kernels have its size.
        const int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * pi_ * pi_)) * flip_pixels_per_degree));
        const double weight = a * std::sqrt(pi_ / b);
        Kernel taps;
        for (int i = -radius; i <= radius; ++i) {
            const double x = i / flip_pixels_per_degree;
            taps.push_back(static_cast<float>((square_root_of_weight ? std::sqrt(weight) : weight) * std::exp(-pi_ * pi_ * x * x / b)));
        }
        return taps;
    }
    static constexpr double pi_ = 3.14159265358979323846;
};

float total(const Kernel& kernel) { return std::accumulate(kernel.begin(), kernel.end(), 0.0f); }

void scale(Kernel& kernel, float factor) {
    for (float& tap : kernel) tap *= factor;
}

/// Kernels of the achromatic, the red-green and the blue-yellow channel; the last is a sum of two Gaussians.
struct SensitivityKernels {
    Kernel achromatic = Sensitivity{1.0, 0.0047}.kernel(false);
    Kernel red_green = Sensitivity{1.0, 0.0053}.kernel(false);
    Kernel blue_yellow[2] = {Sensitivity{34.1, 0.04}.kernel(true), Sensitivity{13.5, 0.025}.kernel(true)};

    SensitivityKernels() {
        scale(achromatic, 1.0f / total(achromatic));
        scale(red_green, 1.0f / total(red_green));
        const float narrow = total(blue_yellow[0]), wide = total(blue_yellow[1]);
        for (Kernel& kernel : blue_yellow) scale(kernel, 1.0f / std::sqrt(narrow * narrow + wide * wide));
    }
};

/// Edges and points of about 0.082 degrees: a Gaussian and its first and second derivative. Weights of one sign sum to one.
struct FeatureKernels {
    Kernel gauss, edge, point;

    FeatureKernels() {
        const float deviation = static_cast<float>(0.5 * 0.082 * flip_pixels_per_degree);
        const int radius = static_cast<int>(std::ceil(3.0f * deviation));
        for (int i = -radius; i <= radius; ++i) {
            const float x = static_cast<float>(i);
            const float g = std::exp(-(x * x) / (2.0f * deviation * deviation));
            gauss.push_back(g);
            edge.push_back(-x * g);
            point.push_back((x * x / (deviation * deviation) - 1.0f) * g);
        }
        for (Kernel* kernel : {&gauss, &edge, &point}) {
            float positive = 0.0f, negative = 0.0f;
            for (float tap : *kernel) (tap > 0.0f ? positive : negative) += std::fabs(tap);
            for (float& tap : *kernel) tap /= tap > 0.0f ? positive : (negative > 0.0f ? negative : 1.0f);
        }
    }
};

/// One picture on its way from top to bottom: rows are filtered along x as they come into reach, then along y where they are looked at.
class Filtered {
public:
    Filtered(const LinearPlanes& rgb, const SensitivityKernels& colour, const FeatureKernels& feature)
        : rgb_(rgb),
          colour_(colour),
          feature_(feature),
          windows_(7, RowWindow(rgb[0].width, rgb[0].height, taps(colour))),
          opponent_(3, PaddedRow(rgb[0].width, taps(colour) / 2)) {}

    /// Rows must be selected from top to bottom; the values of the row's pixels can then be asked for.
    void select_row(int y) {
        const int reach = taps(colour_) / 2, last = std::min(y + reach, rgb_[0].height - 1);
        for (next_ = std::max(next_, y - reach); next_ <= last; ++next_) filter_row(next_);
        const Kernel* kernels[] = {&colour_.achromatic, &colour_.red_green, &colour_.blue_yellow[0], &colour_.blue_yellow[1],
                                   &feature_.gauss,     &feature_.edge,     &feature_.gauss,         &feature_.point};
        const Window sources[] = {achromatic, red_green, blue_yellow_0, blue_yellow_1, edges, gauss, points, gauss};
        for (std::size_t i = 0; i < 8; ++i) windows_[sources[i]].filter(y, *kernels[i], row_[i]);
    }
    Triple opponent(std::size_t x) const { return {row_[0][x], row_[1][x], row_[2][x] + row_[3][x]}; }
    float edge(std::size_t x) const { return std::sqrt(row_[4][x] * row_[4][x] + row_[5][x] * row_[5][x]); }
    float point(std::size_t x) const { return std::sqrt(row_[6][x] * row_[6][x] + row_[7][x] * row_[7][x]); }

private:
    enum Window { achromatic, red_green, blue_yellow_0, blue_yellow_1, gauss, edges, points };
    static int taps(const SensitivityKernels& colour) { return static_cast<int>(colour.achromatic.size()); }

    void filter_row(int y) {
        const std::size_t width = static_cast<std::size_t>(rgb_[0].width);
        const float *r = rgb_[0].row(y), *g = rgb_[1].row(y), *b = rgb_[2].row(y);
        float *yy = opponent_[0].begin(), *cx = opponent_[1].begin(), *cz = opponent_[2].begin();
        for (std::size_t x = 0; x < width; ++x) {
            const Triple v = yycxcz({r[x], g[x], b[x]});
            yy[x] = v.x;
            cx[x] = v.y;
            cz[x] = v.z;
        }
        for (PaddedRow& row : opponent_) row.pad();
        opponent_[0].filter(colour_.achromatic, windows_[achromatic].row(y));
        opponent_[1].filter(colour_.red_green, windows_[red_green].row(y));
        opponent_[2].filter(colour_.blue_yellow[0], windows_[blue_yellow_0].row(y));
        opponent_[2].filter(colour_.blue_yellow[1], windows_[blue_yellow_1].row(y));
        // Features are found in the luminance Y = (Yy + 16) / 116.
        for (std::size_t x = 0; x < width; ++x) yy[x] = yy[x] * (1.0f / 116.0f) + 16.0f / 116.0f;
        opponent_[0].pad();
        opponent_[0].filter(feature_.gauss, windows_[gauss].row(y));
        opponent_[0].filter(feature_.edge, windows_[edges].row(y));
        opponent_[0].filter(feature_.point, windows_[points].row(y));
    }

    const LinearPlanes& rgb_;
    const SensitivityKernels& colour_;
    const FeatureKernels& feature_;
    std::vector<RowWindow> windows_;
    std::vector<PaddedRow> opponent_;
    std::vector<float> row_[8];
    int next_ = 0;
};

/// Whether any pixel within `reach` rows of row `y` differs; where none does, the error is 0.
bool differs_near(const LinearPlanes& a, const LinearPlanes& b, int y, int reach) {
    const int first = std::max(y - reach, 0), last = std::min(y + reach, a[0].height - 1);
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!std::equal(a[i].row(first), a[i].row(last) + a[i].width, b[i].row(first))) return true;
    }
    return false;
}

/// Sorted ascending, by three counting passes over the bits: floats that are not negative are ordered as their bits are.
std::vector<float> sorted_ascending(std::vector<float> values) {
    constexpr std::uint32_t digits = 2048;
    std::vector<float> other(values.size());
    for (int shift = 0; shift < 33; shift += 11) {
        const auto digit = [shift](float value) { return (std::bit_cast<std::uint32_t>(value) >> shift) % digits; };
        std::vector<std::size_t> place(digits + 1);
        for (float value : values) ++place[digit(value) + 1];
        std::partial_sum(place.begin(), place.end(), place.begin());
        for (float value : values) other[place[digit(value)]++] = value;
        values.swap(other);
    }
    return values;
}

/// The value at which the running sum of the sorted errors reaches `share` of their total.
float weighted_percentile(const std::vector<float>& sorted, float total_error, float share) {
    float running = 0.0f;
    for (float error : sorted) {
        running += error;
        if (running >= share * total_error) return error;
    }
    return sorted.back();
}

}  // namespace

Plane flip(const LinearPlanes& reference, const LinearPlanes& test) {
    const SensitivityKernels colour;
    const FeatureKernels feature;
    const float largest = compressed_hyab(hunt_lab({0.0f, 1.0f, 0.0f}), hunt_lab({0.0f, 0.0f, 1.0f}));
    Filtered a(reference, colour, feature), b(test, colour, feature);
    Plane error(reference[0].width, reference[0].height);
    for (int y = 0; y < error.height; ++y) {
        if (!differs_near(reference, test, y, static_cast<int>(colour.achromatic.size()) / 2)) continue;
        a.select_row(y);
        b.select_row(y);
        float* row = error.row(y);
        for (std::size_t x = 0; x < static_cast<std::size_t>(error.width); ++x) {
            const Triple opponent_a = a.opponent(x), opponent_b = b.opponent(x);
            if (opponent_a == opponent_b) continue;
            const float difference = compressed_hyab(hunt_lab(shown_rgb(opponent_a)), hunt_lab(shown_rgb(opponent_b)));
            const float feature_difference = std::max(std::fabs(a.edge(x) - b.edge(x)), std::fabs(a.point(x) - b.point(x)));
            row[x] = std::pow(redistributed(difference, largest), 1.0f - std::sqrt(feature_difference * std::sqrt(0.5f)));
        }
    }
    return error;
}

FlipSummary summarise(const Plane& error) {
    FlipSummary summary;
    if (error.values.empty()) return summary;
    const double count = static_cast<double>(error.values.size());
    const float sum_of_errors = std::accumulate(error.values.begin(), error.values.end(), 0.0f);
    summary.mean = static_cast<double>(sum_of_errors) / count;
    summary.mean_exact = std::accumulate(error.values.begin(), error.values.end(), 0.0) / count;
    const std::vector<float> sorted = sorted_ascending(error.values);
    summary.min = static_cast<double>(sorted.front());
    summary.max = static_cast<double>(sorted.back());
    summary.median = static_cast<double>(weighted_percentile(sorted, sum_of_errors, 0.5f));
    summary.q1 = static_cast<double>(weighted_percentile(sorted, sum_of_errors, 0.25f));
    summary.q3 = static_cast<double>(weighted_percentile(sorted, sum_of_errors, 0.75f));
    return summary;
}

}  // namespace rt
