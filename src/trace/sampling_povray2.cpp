#include <algorithm>
#include <cstdint>

#include "trace/sampling.h"

namespace rt {
namespace {

struct Node {
    std::uint64_t pixel = 0;  ///< number of the pixel it was traced for; others are stale
    Pixel value;
    Contrast contrast;
};

/// The corners and, where they differ, the finer grid of one pixel after another. What lies on the edge to the next pixel is handed over.
class AdaptiveGrid {
public:
    AdaptiveGrid(const SamplingTask& task, const Region& tile)
        : task_(task),
          tile_(tile),
          steps_(1 << (std::clamp(task.sampling.depth, 1, 9) - 1)),
          nodes_(nodes_a_side() * nodes_a_side()),
          above_(nodes_a_side() * tile.width()) {}

    Pixel pixel(int x, int y) {
        x_ = x, y_ = y;
        ++number_;
        Node* above = &above_[nodes_a_side() * (x - tile_.x0)];
        if (x > tile_.x0) {
            for (int row = 0; row <= steps_; ++row) hand_over(node(steps_, row), number_ - 1, node(0, row));
        }
        if (y > tile_.y0) {
            for (int column = 0; column <= steps_; ++column) hand_over(above[column], number_ - tile_.width(), node(column, 0));
        }
        const Pixel mean = square(0, 0, steps_).pixel();
        for (int column = 0; column <= steps_; ++column) above[column] = node(column, steps_);
        return mean;
    }

private:
    std::size_t nodes_a_side() const { return static_cast<std::size_t>(steps_) + 1; }
    Node& node(int column, int row) { return nodes_[nodes_a_side() * row + column]; }

    void hand_over(const Node& from, std::uint64_t owner, Node& to) {
        if (from.pixel != owner || to.pixel == number_) return;
        to = from;
        to.pixel = number_;
    }

    const Node& traced(int column, int row) {
        Node& n = node(column, row);
        if (n.pixel == number_) return n;
        n.pixel = number_;
        n.value = task_.sample(x_ + static_cast<double>(column) / steps_, y_ + static_cast<double>(row) / steps_);
        n.contrast = Contrast(n.value, task_.comparison);
        return n;
    }

    /// Mean over the square of `size` steps with its corner at (column, row).
    PixelSum square(int column, int row, int size) {
        const Node* corners[4] = {&traced(column, row), &traced(column + size, row), &traced(column, row + size),
                                  &traced(column + size, row + size)};
        PixelSum sum;
        if (size > 1 && differ(corners)) {
            const int half = size / 2;
            sum.add(square(column, row, half));
            sum.add(square(column + half, row, half));
            sum.add(square(column, row + half, half));
            sum.add(square(column + half, row + half, half));
        } else {
            for (const Node* corner : corners) sum.add(corner->value);
        }
        return sum.over(4.0);
    }

    bool differ(const Node* const (&corners)[4]) const {
        for (int i = 0; i < 4; ++i) {
            for (int j = i + 1; j < 4; ++j) {
                if (distance(corners[i]->contrast, corners[j]->contrast) >= task_.sampling.threshold) return true;
            }
        }
        return false;
    }

    const SamplingTask& task_;
    Region tile_;
    int steps_;  ///< smallest squares along a pixel's side
    int x_ = 0, y_ = 0;
    std::uint64_t number_ = 0;
    std::vector<Node> nodes_;  ///< of the pixel in hand
    std::vector<Node> above_;  ///< lower edges of the last pixels of all columns
};

}  // namespace

int sample_povray2(const SamplingTask& task, const Region& tile, std::vector<Pixel>& pixels) {
    AdaptiveGrid grid(task, tile);
    std::size_t next = 0;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            if (task.stopped()) return y - tile.y0;
            pixels[next++] = grid.pixel(x, y);
        }
    }
    return tile.height();
}

}  // namespace rt
