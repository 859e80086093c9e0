// Threads that light points of the picture plane until there is an end of it.
#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include "trace/plane_sampler.h"

namespace rt {

using Deadline = std::chrono::steady_clock::time_point;

struct PlaneWorker {
    PlaneWorker(const World& world, const RenderOptions& options) : plane(world, options) {}
    PlaneSampler plane;
    std::vector<Vec2> points;
    std::vector<Pixel> pixels;
};

/// Keeps what its threads have built up from one pass over the picture to the next. The world and options outlive it.
class PlaneWorkers {
public:
    PlaneWorkers(const World& world, const RenderOptions& options);

    /// As for_each_tile(): work(worker, task).
    void for_each(std::size_t tasks, const std::function<void(PlaneWorker&, std::size_t)>& work);
    /// The worker's pixels of its points. Looks at the end every few points; false if it has come: the pixels say nothing then.
    bool light(PlaneWorker& worker) const;

    /// Work ends then, too; nullptr: never.
    void end_at(const Deadline* deadline) { deadline_ = deadline; }
    bool stopped() const { return options_.stop && options_.stop->load(std::memory_order_relaxed); }
    bool ended() const { return stopped() || (deadline_ && std::chrono::steady_clock::now() >= *deadline_); }

    RayCounts counts() const;
    /// The most that worked at once.
    int threads() const { return threads_; }

private:
    const World& world_;
    const RenderOptions& options_;
    std::vector<std::unique_ptr<PlaneWorker>> workers_;
    const Deadline* deadline_ = nullptr;
    int threads_ = 0;
};

}  // namespace rt
