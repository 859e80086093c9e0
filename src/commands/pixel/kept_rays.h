// A ray tree that is too large to tell of, cut: a scene of mirrors has one of thousands of rays for a pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "trace/ray_log.h"

namespace rt {

/// A ray that is told of.
struct KeptRay {
    std::uint32_t ray = 0;                 ///< its place in the record
    std::uint32_t parent = RayNode::none;  ///< its parent's place among the rays that are kept
    std::uint32_t left_out = 0;            ///< rays that are not told of and have this one as their last ancestor that is
};

/// At most `most` (and at least one) of a record's rays in their order: those with the fewest ancestors, of which none is missing.
std::vector<KeptRay> keep_rays(const RayLog& log, std::size_t most);

}  // namespace rt
