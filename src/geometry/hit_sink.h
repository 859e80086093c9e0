// For shapes that a ray can meet many times: where they put what they find.
#pragma once

#include <algorithm>
#include <vector>

#include "geometry/hits.h"

namespace rt {

/// Takes hits in any order and keeps the nearest inside the interval, or all of them.
class HitSink {
public:
    explicit HitSink(const Interval& range, std::vector<ShapeHit>* all = nullptr) : range_(range), all_(all) {}

    /// Hits count beyond `after()` and before `before()`, which draws nearer with every hit if only the nearest is wanted.
    double after() const { return range_.min; }
    double before() const { return range_.max; }
    void offer(const ShapeHit& hit) {
        if (!range_.contains(hit.t)) return;
        if (all_) {
            all_->push_back(hit);
        } else {
            nearest_ = hit;
            range_.max = hit.t;
        }
    }
    /// The nearest one; its t is infinite if there is none.
    const ShapeHit& nearest() const { return nearest_; }

private:
    Interval range_;
    ShapeHit nearest_;
    std::vector<ShapeHit>* all_;
};

/// A shape that offers a sink its hits: all of those inside the sink's interval, as far as the sink still takes them.
template <typename S>
concept FindsHits = requires(const S& shape, const Ray& ray, HitSink& sink) {
    find_hits(shape, ray, sink);
};

template <FindsHits S>
bool intersect(const S& shape, const Ray& ray, const Interval& range, ShapeHit& hit) {
    HitSink sink(range);
    find_hits(shape, ray, sink);
    if (sink.nearest().t == infinity) return false;
    hit = sink.nearest();
    return true;
}

/// All hits at once; of several at the same distance, the one that was found first.
template <FindsHits S, typename Visit>
bool visit_hits(const S& shape, const Ray& ray, Interval range, Visit visit) {
    std::vector<ShapeHit> all;
    HitSink sink(range, &all);
    find_hits(shape, ray, sink);
    std::stable_sort(all.begin(), all.end(), [](const ShapeHit& a, const ShapeHit& b) { return a.t < b.t; });
    for (std::size_t i = 0; i < all.size(); ++i)
        if ((i == 0 || all[i].t != all[i - 1].t) && visit(all[i])) return true;
    return false;
}

}  // namespace rt
