// A picture made larger by a smooth filter.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "film/film.h"

namespace rt {

/// Pixels [begin, end) of a line of `large` pixels, made from a line of `small` ones that has the same ends. Each lies on the cubic through
/// the four nearest of the small line whose slopes are those of E. Catmull and R. Rom (A class of local interpolating splines, 1974);
/// beyond an end the last one is repeated. Which pixels of the large line are asked for changes none of them.
class Stretch {
public:
    /// `1 <= `small` <= `large`, 0 <= `begin` <= `end` <= `large`.
    Stretch(int small, int large, int begin, int end);

    /// Of the small line, the pixels that count: [first, last).
    int first() const { return first_; }
    int last() const { return last_; }
    /// Of the large line.
    int count() const { return static_cast<int>(taps_.size()); }

    /// The pixel at `begin` + i; `line[k * stride]` is pixel first() + k of the small line.
    Pixel at(int i, const Pixel* line, std::ptrdiff_t stride) const;

private:
    struct Taps {
        std::array<int, 4> places;  ///< from first()
        std::array<float, 4> weights;
    };
    std::vector<Taps> taps_;
    int first_ = 0, last_ = 0;
};

/// What of a colour is filtered: linear light's roots are nearly as far apart as they are seen to be.
enum class Filtered { values, square_roots };

/// The large picture's pixels that both stretches are about. `small` has the pixels that count, [first, last) of each, all of them finite.
/// No channel of the result is below 0, no transmittance above 1.
Film enlarge(Film small, const Stretch& across, const Stretch& down, Filtered filtered);

}  // namespace rt
