// Before all parts of a trade: how large its pictures are, where nobody says so.
#include <fmt/format.h>

#include <cmath>

#include "commands/trade/work.h"

namespace rt {

namespace {

PictureSize size_of_share(const TradeWork& work, double share) {
    const auto part = [&](int side) { return static_cast<int>(std::lround(side * share)); };
    return {part(work.request.job.width), part(work.request.job.height)};
}

/// The largest of some shares of the usual width at which the exact preset takes no more than a hundredth of the whole trade: some sixty
/// settings are run three times and more, most of them several times quicker than that.
double share_of_size(const TradeWork& work) {
    const RenderJob job = exact_job(work);
    const double limit = work.request.seconds / 100.0;
    const World world = work.scene.build(job);
    for (const double share : {1.0, 0.75, 0.5, 0.375}) {
        const PictureSize size = size_of_share(work, share);
        RenderJob smaller = job;
        smaller.width = size.width, smaller.height = size.height;
        if (expected_seconds(work, world, smaller, limit) <= limit) return share;
    }
    return 0.25;
}

}  // namespace

PictureSize usual_size(const TradeWork& work) {
    work.progress.show("how large the pictures can be");
    const std::string words = fmt::format("{}", work.request.seconds);
    std::optional<double> share = work.store.size(words);
    if (!share) {
        share = share_of_size(work);
        work.store.put_size(words, *share);
    }
    return size_of_share(work, *share);
}

}  // namespace rt
