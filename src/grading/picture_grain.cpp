// Differences from pixel to pixel: noise, specks of shadow, edges that are jagged or smooth.
#include <fmt/format.h>

#include <optional>

#include "grading/picture_causes.h"

namespace rt {

namespace {

/// Least and largest value of a channel among the 3 x 3 around a pixel.
struct Range {
    Color low, high;
    float widest() const { return apart(low, high); }
};
Range range_at(const ColorPicture& picture, int x, int y) {
    Range range{picture.at(x, y), picture.at(x, y)};
    for (int ny = y - 1; ny <= y + 1; ++ny)
        for (int nx = x - 1; nx <= x + 1; ++nx)
            for (std::size_t c = 0; c < 3; ++c) {
                range.low[c] = std::min(range.low[c], picture.nearest(nx, ny)[c]);
                range.high[c] = std::max(range.high[c], picture.nearest(nx, ny)[c]);
            }
    return range;
}

/// Whether a colour stands clearly between those around it, as on an edge that was averaged.
bool is_between(const Color& color, const Range& range) {
    for (std::size_t c = 0; c < 3; ++c) {
        const float width = range.high[c] - range.low[c];
        if (width >= 0.1f && color[c] > range.low[c] + 0.15f * width && color[c] < range.high[c] - 0.15f * width) return true;
    }
    return false;
}

/// One picture jagged where the other is smooth. `smooth` has the edge's own colours, `jagged` those of its sides.
std::optional<Finding> edges(const ColorPicture& smooth, const ColorPicture& jagged, bool missing, const Misfit& whole) {
    Misfit left;  // what is not on edges, or is none of the colours there
    double differing = 0.0, between_in_smooth = 0.0, between_in_jagged = 0.0;
    for (int y = 0; y < smooth.height; ++y)
        for (int x = 0; x < smooth.width; ++x) {
            const float difference = apart(smooth.at(x, y), jagged.at(x, y));
            const Range around = range_at(smooth, x, y);
            float beyond = 0.0f;
            for (std::size_t c = 0; c < 3; ++c)
                beyond = std::max({beyond, around.low[c] - jagged.at(x, y)[c], jagged.at(x, y)[c] - around.high[c]});
            const Range around_jagged = range_at(jagged, x, y);
            const bool edge = std::min(around.widest(), around_jagged.widest()) >= 2.0f * Misfit::visible;
            left.add(edge ? beyond : difference);
            if (difference < Misfit::visible) continue;
            ++differing;
            between_in_smooth += is_between(smooth.at(x, y), around);
            between_in_jagged += is_between(jagged.at(x, y), around_jagged);
        }
    if (!(between_in_smooth >= 0.5 * differing && between_in_jagged <= 0.5 * between_in_smooth)) return std::nullopt;
    return Finding{missing ? "missing anti-aliasing" : "needless anti-aliasing",
                   fmt::format("{:.0f} of {:.0f} differing pixels are smoothed edges in the {} picture, {:.0f} in the other",
                               between_in_smooth, differing, missing ? "expected" : "program's", between_in_jagged),
                   share_left(left, whole), 0.06};
}

/// How the differences stand beside each other where the expected picture is smooth.
struct Grain {
    double squares = 0.0, rough = 0.0;           ///< of the differences; of what remains of them beside the mean of their neighbours
    double differing = 0.0;                      ///< pixels
    double on_lit = 0.0, brighter_on_lit = 0.0;  ///< neither black nor white in the expected picture
    double lit = 0.0;                            ///< pixels that are, whether they differ or not
};

Grain grain_of(const ColorPicture& expected, const ColorPicture& actual) {
    ColorPicture difference = actual;
    for (std::size_t i = 0; i < actual.pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) difference.pixels[i][c] = actual.pixels[i][c] - expected.pixels[i][c];
    Grain grain;
    for (int y = 1; y + 1 < expected.height; ++y)
        for (int x = 1; x + 1 < expected.width; ++x) {
            if (range_at(expected, x, y).widest() > 0.1f) continue;
            Color mean{};
            for (int ny = y - 1; ny <= y + 1; ++ny)
                for (int nx = x - 1; nx <= x + 1; ++nx)
                    for (std::size_t c = 0; c < 3; ++c) mean[c] += difference.at(nx, ny)[c] / 9.0f;
            const Color& d = difference.at(x, y);
            for (std::size_t c = 0; c < 3; ++c) {
                grain.squares += static_cast<double>(d[c] * d[c]);
                grain.rough += static_cast<double>((d[c] - mean[c]) * (d[c] - mean[c]));
            }
            const Color& e = expected.at(x, y);
            const float brightest = std::max({e[0], e[1], e[2]}), darkest = std::min({e[0], e[1], e[2]});
            const bool lit = brightest > 0.1f && darkest < 0.9f;
            grain.lit += lit;
            if (apart(d, Color{}) < Misfit::visible) continue;
            const bool brighter = d[0] + d[1] + d[2] > 0.0f;
            ++grain.differing;
            if (lit) ++grain.on_lit, grain.brighter_on_lit += brighter;
        }
    return grain;
}

double roughness_of(const Grain& grain) { return grain.squares > 0.0 ? grain.rough / grain.squares : 0.0; }

}  // namespace

double roughness_of(const ColorPicture& expected, const ColorPicture& actual) { return roughness_of(grain_of(expected, actual)); }

std::vector<Finding> grain_findings(const ColorPicture& expected, const ColorPicture& actual, const Misfit& whole) {
    std::vector<Finding> findings;
    for (const bool missing : {true, false})
        if (std::optional<Finding> found = missing ? edges(expected, actual, true, whole) : edges(actual, expected, false, whole))
            findings.push_back(std::move(*found));

    const Grain grain = grain_of(expected, actual);
    const double roughness = roughness_of(grain);
    const double in_smooth_parts = whole.differing > 0.0 ? grain.differing / whole.differing : 0.0;
    if (roughness < 0.4 || in_smooth_parts < 0.5) return findings;
    const auto left = [&](double pure) { return std::max(0.0, 1.0 - std::max(roughness / pure, in_smooth_parts)); };
    const double brighter = grain.on_lit > 0.0 ? grain.brighter_on_lit / grain.on_lit : 0.5;
    const std::string words = fmt::format(
        "{:.0f} of {:.0f} differing pixels lie in smooth parts and differ from their neighbours ({:.0f} % of the squared difference; 89 % "
        "in "
        "pure noise), {:.0f} % of them brighter than expected",
        grain.differing, whole.differing, 100.0 * roughness, 100.0 * brighter);
    if (brighter >= 0.2 && brighter <= 0.85) findings.push_back({"noise", words, left(8.0 / 9.0), 0.05});
    // Of specks on a share p of the pixels, all as dark, 1 - p of the squares is beside their mean.
    const double p = grain.lit > 0.0 ? std::min(grain.on_lit / grain.lit, 0.6) : 0.0;
    if (brighter <= 0.05) findings.push_back({"shadow acne", words, left(8.0 / 9.0 * (1.0 - p)), 0.1});
    return findings;
}

}  // namespace rt
