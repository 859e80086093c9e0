// Embree as a filter in single precision in front of tests in double: the only file pair that knows Embree.
#pragma once

#include <cstdint>
#include <memory>
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

    /// Offers every hit that may be the nearest to the query, which may come with a best hit found elsewhere.
    void nearest(Query& query) const;
    /// Whether any surface that the query sees is met inside its range.
    bool occluded(Query& query) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rt
