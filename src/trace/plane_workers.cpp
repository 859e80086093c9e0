#include "trace/plane_workers.h"

#include <algorithm>
#include <limits>

namespace rt {

PlaneWorkers::PlaneWorkers(const World& world, const RenderOptions& options)
    : world_(world),
      options_(options),
      workers_(static_cast<std::size_t>(worker_count(options.threads, std::numeric_limits<std::size_t>::max()))) {}

void PlaneWorkers::for_each(std::size_t tasks, const std::function<void(PlaneWorker&, std::size_t)>& work) {
    const int threads = for_each_tile(options_.threads, tasks, [&](int index, std::size_t task) {
        std::unique_ptr<PlaneWorker>& worker = workers_[static_cast<std::size_t>(index)];
        if (!worker) worker = std::make_unique<PlaneWorker>(world_, options_);
        work(*worker, task);
    });
    threads_ = std::max(threads_, threads);
}

bool PlaneWorkers::light(PlaneWorker& worker) const {
    constexpr std::size_t points_at_a_time = 32;
    worker.pixels.resize(worker.points.size());
    for (std::size_t i = 0; i < worker.points.size(); i += points_at_a_time) {
        if (ended()) return false;
        const std::size_t count = std::min(points_at_a_time, worker.points.size() - i);
        worker.plane(std::span(worker.points).subspan(i, count), 1, std::span(worker.pixels).subspan(i, count));
    }
    return true;
}

RayCounts PlaneWorkers::counts() const {
    RayCounts counts;
    for (const std::unique_ptr<PlaneWorker>& worker : workers_)
        if (worker) counts += worker->plane.counts();
    return counts;
}

}  // namespace rt
