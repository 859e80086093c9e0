#include <utility>

#include "trace/sampling.h"

namespace rt {
namespace {

/// A traced pixel and what its neighbours need to know of it.
struct Cell {
    Pixel value;
    Contrast contrast;
    bool sampled_again = false;
};

class Block {
public:
    Block(const SamplingTask& task, const Region& tile) : task_(task), tile_(tile), cells_((tile.width() + 1) * (tile.height() + 1)) {}

    /// The row above the block and the column left of it only serve as neighbours: they are never sampled again.
    void trace_border_row() {
        for (int x = tile_.x0; x < tile_.x1; ++x) trace(x, tile_.y0 - 1).sampled_again = true;
    }
    void trace_border_cell(int y) { trace(tile_.x0 - 1, y).sampled_again = true; }

    /// Compares the pixel's centre with its neighbours as they are by now, which may already be means of many samples.
    void trace_pixel(int x, int y) {
        const Contrast centre = trace(x, y).contrast;
        for (const auto& [left, up] : {std::pair{1, 0}, std::pair{0, 1}}) {
            if (!(distance(centre, cell(x - left, y - up).contrast) >= task_.sampling.threshold)) continue;
            sample_again(x - left, y - up);
            sample_again(x, y);
        }
    }

    const Pixel& value(int x, int y) { return cell(x, y).value; }

private:
    Cell& cell(int x, int y) { return cells_[static_cast<std::size_t>(y - tile_.y0 + 1) * (tile_.width() + 1) + (x - tile_.x0 + 1)]; }

    Cell& trace(int x, int y) {
        Cell& c = cell(x, y);
        set(c, task_.sample(x + 0.5, y + 0.5));
        return c;
    }

    void set(Cell& c, const Pixel& value) {
        c.value = value;
        c.contrast = Contrast(value, task_.comparison);
    }

    /// The mean of the centre and n x n samples. Offsets grow by repeated addition, which decides ties on edges.
    void sample_again(int x, int y) {
        Cell& c = cell(x, y);
        if (c.sampled_again) return;
        c.sampled_again = true;
        const int n = task_.sampling.depth;
        const double step = 1.0 / n;
        const double first = -(0.5 - 0.5 / n);
        PixelSum sum;
        sum.add(c.value);
        points_.clear();
        double dy = first;
        for (int row = 0; row < n; ++row, dy += step) {
            double dx = first;
            for (int column = 0; column < n; ++column, dx += step) points_.push_back({(x + dx) + 0.5, (y + dy) + 0.5});
        }
        samples_.resize(points_.size());
        task_.samples(points_, 1, samples_);
        for (const Pixel& sample : samples_) sum.add(sample);
        set(c, sum.over(static_cast<double>(n) * n + 1.0).pixel());
    }

    const SamplingTask& task_;
    Region tile_;
    std::vector<Cell> cells_;
    std::vector<Vec2> points_;
    std::vector<Pixel> samples_;
};

}  // namespace

int sample_povray1(const SamplingTask& task, const Region& tile, std::vector<Pixel>& pixels) {
    Block block(task, tile);
    block.trace_border_row();
    int rows = tile.height();
    for (int y = tile.y0; y < tile.y1 && rows == tile.height(); ++y) {
        block.trace_border_cell(y);
        for (int x = tile.x0; x < tile.x1; ++x) {
            // The row above the one in hand may still be waiting for its second sampling.
            if (task.stopped()) rows = y > tile.y0 ? y - tile.y0 - 1 : 0;
            if (rows != tile.height()) break;
            block.trace_pixel(x, y);
        }
    }
    std::size_t next = 0;
    for (int y = tile.y0; y < tile.y0 + rows; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) pixels[next++] = block.value(x, y);
    }
    return rows;
}

}  // namespace rt
