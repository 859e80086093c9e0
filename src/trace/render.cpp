#include "trace/render.h"

#include <fmt/format.h>
#include <pthread.h>
#include <xmmintrin.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <fstream>
#include <limits>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>

#include "core/source.h"
#include "trace/enlarged.h"
#include "trace/plane_sampler.h"
#include "trace/progressive.h"

namespace rt {
namespace {

/// 256 levels of recursion at 64 kB each, more than any build of the tracer uses. The system's default depends on the user's limits.
constexpr std::size_t worker_stack = std::size_t{16} << 20;

/// New threads get a stack of at least `worker_stack` while this exists.
class DeepStacks {
public:
    DeepStacks() {
        pthread_getattr_default_np(&saved_);
        std::size_t size = 0;
        pthread_attr_getstacksize(&saved_, &size);
        if (size >= worker_stack) return;
        pthread_attr_t deep;
        pthread_getattr_default_np(&deep);
        pthread_attr_setstacksize(&deep, worker_stack);
        pthread_setattr_default_np(&deep);
        pthread_attr_destroy(&deep);
    }
    ~DeepStacks() {
        pthread_setattr_default_np(&saved_);
        pthread_attr_destroy(&saved_);
    }
    DeepStacks(const DeepStacks&) = delete;
    DeepStacks& operator=(const DeepStacks&) = delete;

private:
    pthread_attr_t saved_;
};

/// The first exception of any worker.
class FirstFailure {
public:
    void keep(std::exception_ptr failure) {
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = failure;
    }
    void rethrow() const {
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    std::mutex mutex_;
    std::exception_ptr failure_;
};

}  // namespace

int worker_count(int threads, std::size_t tiles) {
    const unsigned wanted = threads > 0 ? static_cast<unsigned>(threads) : std::thread::hardware_concurrency();
    return static_cast<int>(std::clamp<std::size_t>(wanted, 1, std::max<std::size_t>(tiles, 1)));
}

int for_each_tile(int threads, std::size_t count, const std::function<void(int worker, std::size_t tile)>& work, Rounding rounding) {
    std::atomic<std::size_t> next{0};
    FirstFailure failure;
    const auto run = [&](int worker) {
        try {
            for (std::size_t tile = next++; tile < count; tile = next++) {
                _mm_setcsr(floating_point_state(rounding));  // creating an Embree device leaves flush-to-zero set on some threads
                work(worker, tile);
            }
        } catch (...) {
            failure.keep(std::current_exception());
            next = count;
        }
    };
    const int wanted = worker_count(threads, count);
    std::vector<std::jthread> workers;
    {
        const DeepStacks stacks;
        try {
            while (static_cast<int>(workers.size()) < wanted) workers.emplace_back(run, static_cast<int>(workers.size()));
        } catch (const std::system_error& error) {
            // Fewer workers than asked for make the same picture; none makes no picture.
            if (workers.empty()) throw LimitError(fmt::format("Cannot start a thread: {}", error.what()));
        }
    }
    const int started = static_cast<int>(workers.size());
    workers.clear();
    failure.rethrow();
    return started;
}

namespace {

/// The whole number that follows `key` in a file of the kernel's, or 0.
std::uint64_t number_after(const char* path, const std::string& key) {
    std::ifstream file(path);
    std::string word;
    while (!key.empty() && file >> word && word != key) {
    }
    std::uint64_t number = 0;
    return file >> number ? number : 0;
}

}  // namespace

std::uint64_t available_memory() {
    std::uint64_t available = number_after("/proc/meminfo", "MemAvailable:") * 1024;
    if (available == 0) available = std::uint64_t{1} << 32;
    // A container's own limit, where there is one ("max" otherwise).
    const std::uint64_t limit = number_after("/sys/fs/cgroup/memory.max", "");
    const std::uint64_t used = number_after("/sys/fs/cgroup/memory.current", "");
    return limit == 0 ? available : std::min(available, limit - std::min(limit, used));
}

std::uint64_t picture_memory(int width, int height) {
    constexpr int longest = 1 << 26;
    if (width < 1 || height < 1) throw LimitError(fmt::format("A picture of {} x {} has no pixels", width, height));
    if (width > longest || height > longest) throw LimitError(fmt::format("A picture of {} x {} is not possible", width, height));
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) * sizeof(Pixel);
}

void check_picture_memory(int width, int height, std::uint64_t available, std::uint64_t further) {
    const std::uint64_t needed = picture_memory(width, height) + further;
    if (needed <= available) return;
    constexpr double gigabyte = 1e9;
    throw LimitError(fmt::format("A picture of {} x {} needs {:.1f} GB of memory; {:.1f} GB are available", width, height,
                                 static_cast<double>(needed) / gigabyte, static_cast<double>(available) / gigabyte));
}

namespace {

/// Tiles of equal size, anchored at the picture's corner, that touch the region; row by row from the top.
std::vector<Region> tiles_of(int side, const Region& region, int width, int height) {
    std::vector<Region> tiles;
    for (int y = region.y0 / side * side; y < region.y1; y += side) {
        for (int x = region.x0 / side * side; x < region.x1; x += side) {
            tiles.push_back({x, y, std::min(x + side, width), std::min(y + side, height)});
        }
    }
    return tiles;
}

/// A block of POV-Ray's first method must stay whole; the others may be cut to the region and be as small as the work allows.
std::vector<Region> choose_tiles(const RenderOptions& options, const Region& region) {
    const bool blocks = options.sampling.method == Sampling::Method::povray1;
    if (blocks) {
        const int side = std::clamp(options.sampling.block, 4, std::max({options.width, options.height, 4}));
        return tiles_of(side, region, options.width, options.height);
    }
    int side = 32;
    const double pixels = static_cast<double>(region.width()) * region.height();
    const int workers = worker_count(options.threads, std::numeric_limits<std::size_t>::max());
    while (side > 8 && pixels < 16.0 * side * side * workers) side /= 2;
    std::vector<Region> tiles = tiles_of(side, region, options.width, options.height);
    for (Region& tile : tiles) {
        tile = {std::max(tile.x0, region.x0), std::max(tile.y0, region.y0), std::min(tile.x1, region.x1), std::min(tile.y1, region.y1)};
    }
    return tiles;
}

/// Tells the caller how far the work is: from one thread at a time, and seldom.
class Progress {
public:
    Progress(const std::function<void(double)>& report, std::size_t tiles) : report_(report), tiles_(tiles) {}

    void tile_done() {
        const std::size_t done = ++done_;
        if (!report_) return;
        const std::unique_lock lock(mutex_, std::try_to_lock);
        const auto now = std::chrono::steady_clock::now();
        if (!lock || now - last_ < std::chrono::milliseconds(100)) return;
        last_ = now;
        report_(static_cast<double>(done) / static_cast<double>(tiles_));
    }

private:
    const std::function<void(double)>& report_;
    std::size_t tiles_;
    std::atomic<std::size_t> done_{0};
    std::mutex mutex_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// What one worker keeps from tile to tile.
struct Worker {
    std::unique_ptr<PlaneSampler> plane;
    SamplingTask task;
    std::vector<Pixel> pixels;
    std::uint64_t non_finite = 0;
    bool complete = true;
};

Comparison comparison_of(const RenderOptions& options) {
    const double gamma = options.working_srgb ? 1.0 : options.working_gamma;
    return {gamma / options.sampling.gamma, options.working_srgb};
}

void prepare(Worker& worker, const World& world, const RenderOptions& options) {
    worker.plane = std::make_unique<PlaneSampler>(world, options);
    worker.task = {options.sampling, comparison_of(options), options.stop, std::ref(*worker.plane)};
}

/// Copies what of the tile is finished and inside the region. The film shows `frame`. Tiles never overlap, so no two workers touch one
/// pixel.
void store(Worker& worker, const Region& tile, int rows, const Region& region, const Region& frame, Film& film) {
    for (int y = std::max(tile.y0, region.y0); y < std::min(tile.y0 + rows, region.y1); ++y) {
        for (int x = std::max(tile.x0, region.x0); x < std::min(tile.x1, region.x1); ++x) {
            const Pixel& p = worker.pixels[static_cast<std::size_t>(y - tile.y0) * tile.width() + (x - tile.x0)];
            if (finite(p)) {
                film.at(x - frame.x0, y - frame.y0) = p;
            } else {
                ++worker.non_finite;
            }
        }
    }
}

void check_limits(const RenderOptions& options) {
    check_picture_memory(options.width, options.height, available_memory());
    const double side = static_cast<double>(std::max(options.width, options.height)) * samples_a_side(options.sampling);
    if (side > std::numeric_limits<int>::max() || options.sampling.depth < 1)
        throw LimitError(fmt::format("{} x {} samples a pixel are not possible", options.sampling.depth, options.sampling.depth));
}

}  // namespace

Region rendered_region(const RenderOptions& options) {
    Region r = options.region.value_or(Region{0, 0, options.width, options.height});
    r.x0 = std::clamp(r.x0, 0, options.width), r.x1 = std::clamp(r.x1, r.x0, options.width);
    r.y0 = std::clamp(r.y0, 0, options.height), r.y1 = std::clamp(r.y1, r.y0, options.height);
    return r;
}

RenderResult render(const World& world, const RenderOptions& options) {
    if (options.scale > 1) return render_enlarged(world, options);
    if (options.sampling.method == Sampling::Method::adaptive) return render_progressive(world, options, {});
    check_limits(options);
    RenderResult result;
    const Region region = rendered_region(options);
    const Region frame = options.only_region ? region : Region{0, 0, options.width, options.height};
    result.film = Film(frame.width(), frame.height());
    const std::vector<Region> tiles = choose_tiles(options, region);
    std::vector<Worker> workers(worker_count(options.threads, tiles.size()));
    Progress progress(options.progress, tiles.size());
    const auto trace_tile = [&](int index, std::size_t tile) {
        Worker& worker = workers[index];
        if (!worker.plane) prepare(worker, world, options);
        const int rows = worker.task.stopped() ? 0 : sample_tile(worker.task, tiles[tile], worker.pixels);
        store(worker, tiles[tile], rows, region, frame, result.film);
        if (rows == tiles[tile].height()) {
            progress.tile_done();
        } else {
            worker.complete = false;
        }
    };
    result.threads = for_each_tile(options.threads, tiles.size(), trace_tile, options.rounding);
    for (const Worker& worker : workers) {
        if (worker.plane) result.counts += worker.plane->counts();
        result.non_finite += worker.non_finite;
        result.complete = result.complete && worker.complete;
    }
    if (options.progress && result.complete) options.progress(1.0);
    return result;
}

}  // namespace rt
