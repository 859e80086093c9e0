// Embree as a filter in single precision in front of tests in double: the only file pair that knows Embree.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "world/compile.h"
#include "world/surfaces.h"

namespace rt {

class EmbreeIndex {
public:
    /// Over the given objects of `surfaces`, whose bounds are finite; `surfaces` outlives the index and does not move. Throws LimitError
    /// when memory runs out. Leaves the floating-point environment of the calling thread as it was.
    EmbreeIndex(const Surfaces& surfaces, const std::vector<std::uint32_t>& objects, Precision precision, int threads);
    ~EmbreeIndex();

    /// How a ray comes to the index's box. From `far` away single precision says too little, and everything is tested.
    enum class Entry { none, inside, far };
    /// Cuts `range` to what is inside the box (its end may be left as it is).
    Entry enter(const Ray& ray, Interval& range) const;

    /// Offers every hit that may be the nearest to the query, which may come with a best hit found elsewhere. `entry` and `inside` are what
    /// `enter` made of the query's ray and range.
    void nearest(Query& query, Entry entry, const Interval& inside) const;
    /// The same for up to `packet_size` rays that enter the box and go much the same way.
    void nearest(std::span<Query* const> queries, std::span<const Interval> inside) const;
    /// Whether any surface that the query sees is met inside its range.
    bool occluded(Query& query, Entry entry, const Interval& inside) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rt
