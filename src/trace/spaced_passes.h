// The centres of a region's pixels, first a few far apart, then those between them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "trace/plane_workers.h"

namespace rt {

class SpacedPasses {
public:
    explicit SpacedPasses(const Region& region)
        : region_(region), known_(static_cast<std::size_t>(region.width()) * static_cast<std::size_t>(region.height())) {}

    /// Traces what is not yet known of every `spacing`-th pixel of every `spacing`-th row, counted from the region's corner, into a film of
    /// the region. False if it ended before.
    bool trace(int spacing, PlaneWorkers& workers, Film& film);
    /// For each pixel of the region 1 if it was traced.
    std::span<const std::uint8_t> known() const { return known_; }
    /// Of all pixels, 0..1.
    double share() const;

private:
    bool trace_tile(int tile_x, int tile_y, int side, int spacing, PlaneWorkers& workers, PlaneWorker& worker, Film& film);

    Region region_;
    std::vector<std::uint8_t> known_;
};

}  // namespace rt
