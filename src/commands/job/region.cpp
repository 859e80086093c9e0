#include <fmt/format.h>

#include <cmath>

#include "commands/job/render_job.h"

namespace rt {

namespace {

/// First column or row, from 0. POV-Ray: a fraction s in [0, 1) of n pixels means pixel floor(n s) + 1, counted from 1.
int first_pixel(double start, int n) { return start < 1.0 ? static_cast<int>(std::floor(n * start)) : static_cast<int>(start) - 1; }

/// One past the last column or row. POV-Ray: a fraction e in [0, 1] means pixel floor(n e), counted from 1.
int end_pixel(double end, int n) { return end <= 1.0 ? static_cast<int>(std::floor(n * end)) : static_cast<int>(end); }

void check(const char* what, int first, int end, int n) {
    if (first >= end && first < n && end > 0)
        throw OptionError(fmt::format("region: {} begin at {} and end before, at {}", what, first + 1, end));
    if (first < 0 || end > n || first >= end)
        throw OptionError(fmt::format("region: {} {} to {} are no part of a picture of {}", what, first + 1, end, n));
}

}  // namespace

std::optional<Region> resolve_region(const RegionEdges& edges, int width, int height) {
    if (!edges.start_column && !edges.end_column && !edges.start_row && !edges.end_row) return std::nullopt;
    Region region{0, 0, width, height};
    if (edges.start_column) region.x0 = first_pixel(*edges.start_column, width);
    if (edges.end_column) region.x1 = end_pixel(*edges.end_column, width);
    if (edges.start_row) region.y0 = first_pixel(*edges.start_row, height);
    if (edges.end_row) region.y1 = end_pixel(*edges.end_row, height);
    check("columns", region.x0, region.x1, width);
    check("rows", region.y0, region.y1, height);
    return region;
}

}  // namespace rt
