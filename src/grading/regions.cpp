#include "grading/regions.h"

#include <algorithm>
#include <vector>

#include "grading/difference.h"

namespace rt {

namespace {

/// One number a pixel.
template <typename T>
struct Grid {
    int width, height;
    std::vector<T> values;
    Grid(int w, int h, T value) : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), value) {}
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    T& at(int x, int y) { return values[index(x, y)]; }
    T at_or(int x, int y, T outside) const { return x < 0 || y < 0 || x >= width || y >= height ? outside : values[index(x, y)]; }
};

/// Marks the whole group of (x, y) with `mark`; its box and size.
DifferingRegion flood(Grid<int>& groups, int x, int y, int mark) {
    constexpr int differing = 0;
    DifferingRegion region{0, x, y, x + 1, y + 1, x, y};
    std::vector<std::pair<int, int>> open{{x, y}};
    groups.at(x, y) = mark;
    while (!open.empty()) {
        const auto [cx, cy] = open.back();
        open.pop_back();
        ++region.pixels;
        region.x0 = std::min(region.x0, cx), region.x1 = std::max(region.x1, cx + 1);
        region.y0 = std::min(region.y0, cy), region.y1 = std::max(region.y1, cy + 1);
        for (int ny = cy - 1; ny <= cy + 1; ++ny)
            for (int nx = cx - 1; nx <= cx + 1; ++nx)
                if (groups.at_or(nx, ny, -1) == differing) {
                    groups.at(nx, ny) = mark;
                    open.push_back({nx, ny});
                }
    }
    return region;
}

/// Steps along rows and columns to the nearest pixel outside the group; the picture's border is outside.
Grid<int> depths(const Grid<int>& groups, int mark, const DifferingRegion& box) {
    Grid<int> depth(groups.width, groups.height, 0);
    const auto inside = [&](int x, int y) { return groups.at_or(x, y, -1) == mark; };
    for (int y = box.y0; y < box.y1; ++y)
        for (int x = box.x0; x < box.x1; ++x)
            if (inside(x, y)) depth.at(x, y) = 1 + std::min(depth.at_or(x - 1, y, 0), depth.at_or(x, y - 1, 0));
    for (int y = box.y1 - 1; y >= box.y0; --y)
        for (int x = box.x1 - 1; x >= box.x0; --x)
            if (inside(x, y)) depth.at(x, y) = std::min(depth.at(x, y), 1 + std::min(depth.at_or(x + 1, y, 0), depth.at_or(x, y + 1, 0)));
    return depth;
}

}  // namespace

std::optional<DifferingRegion> largest_region(const StoredImage& reference, const StoredImage& test, double fuzz_percent) {
    const StoredImage differences = difference_picture(reference, test, 1.0);
    const auto strength = [&](int x, int y) {
        const float* rgb = differences.values.data() +
                           3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(differences.width) + static_cast<std::size_t>(x));
        return std::max({rgb[0], rgb[1], rgb[2]});
    };
    const float limit = static_cast<float>(std::max(fuzz_percent / 100.0 * 255.0, 0.5));
    Grid<int> groups(differences.width, differences.height, -1);
    for (int y = 0; y < groups.height; ++y)
        for (int x = 0; x < groups.width; ++x)
            if (strength(x, y) >= limit) groups.at(x, y) = 0;

    std::optional<DifferingRegion> largest;
    int mark = 0, largest_mark = 0;
    for (int y = 0; y < groups.height; ++y)
        for (int x = 0; x < groups.width; ++x) {
            if (groups.at(x, y) != 0) continue;
            const DifferingRegion region = flood(groups, x, y, ++mark);
            if (!largest || region.pixels > largest->pixels) largest = region, largest_mark = mark;
        }
    if (!largest) return largest;

    const Grid<int> depth = depths(groups, largest_mark, *largest);
    std::pair<int, float> best{0, 0.0f};
    for (int y = largest->y0; y < largest->y1; ++y)
        for (int x = largest->x0; x < largest->x1; ++x) {
            const std::pair<int, float> here{depth.at_or(x, y, 0), strength(x, y)};
            if (groups.at_or(x, y, -1) == largest_mark && here > best) best = here, largest->x = x, largest->y = y;
        }
    return largest;
}

}  // namespace rt
