#include "trace/spaced_passes.h"

#include <algorithm>
#include <atomic>

namespace rt {

bool SpacedPasses::trace(int spacing, PlaneWorkers& workers, Film& film) {
    const int side = spacing == 1 ? 32 : 8 * spacing;
    const int columns = (region_.width() + side - 1) / side, rows = (region_.height() + side - 1) / side;
    std::atomic<bool> whole{true};
    workers.for_each(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), [&](PlaneWorker& worker, std::size_t task) {
        const int tile = static_cast<int>(task);
        if (workers.ended() || !trace_tile(tile % columns * side, tile / columns * side, side, spacing, workers, worker, film))
            whole = false;
    });
    return whole;
}

bool SpacedPasses::trace_tile(int tile_x, int tile_y, int side, int spacing, PlaneWorkers& workers, PlaneWorker& worker, Film& film) {
    const auto for_each_unknown = [&](auto&& visit) {
        for (int y = tile_y; y < std::min(tile_y + side, film.height); y += spacing)
            for (int x = tile_x; x < std::min(tile_x + side, film.width); x += spacing)
                if (std::uint8_t& known = known_[static_cast<std::size_t>(y) * film.width + x]; known == 0) visit(x, y, known);
    };
    worker.points.clear();
    for_each_unknown([&](int x, int y, std::uint8_t&) { worker.points.emplace_back(region_.x0 + x + 0.5, region_.y0 + y + 0.5); });
    if (!workers.light(worker)) return false;
    auto pixel = worker.pixels.begin();
    for_each_unknown([&](int x, int y, std::uint8_t& known) { film.at(x, y) = *pixel++, known = 1; });
    return true;
}

double SpacedPasses::share() const {
    const auto known = std::count(known_.begin(), known_.end(), std::uint8_t{1});
    return known_.empty() ? 1.0 : static_cast<double>(known) / static_cast<double>(known_.size());
}

}  // namespace rt
