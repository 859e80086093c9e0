// Which rays of a large tree are told of.
#include "commands/pixel/kept_rays.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rt::kept_rays_test {
namespace {

/// A record with these parents.
RayLog log_of(const std::vector<std::uint32_t>& parents) {
    RayLog log;
    for (const std::uint32_t parent : parents) log.nodes.emplace_back().parent = parent;
    return log;
}

constexpr std::uint32_t none = RayNode::none;

/// 0 has 1 and 4 below it, 1 has 2, 2 has 3, 4 has 5 and 6.
const RayLog& tree() {
    static const RayLog log = log_of({none, 0, 1, 2, 0, 4, 4});
    return log;
}

std::vector<std::uint32_t> places(const std::vector<KeptRay>& kept) {
    std::vector<std::uint32_t> rays;
    for (const KeptRay& ray : kept) rays.push_back(ray.ray);
    return rays;
}

TEST(KeptRays, AreAllOfASmallTree) {
    const std::vector<KeptRay> kept = keep_rays(tree(), 7);
    ASSERT_EQ(kept.size(), 7u);
    for (std::uint32_t i = 0; i < 7; ++i) {
        EXPECT_EQ(kept[i].ray, i);
        EXPECT_EQ(kept[i].parent, tree().nodes[i].parent);
        EXPECT_EQ(kept[i].left_out, 0u);
    }
}

TEST(KeptRays, AreThoseNearestToTheCameraWithAllTheirAncestors) {
    const std::vector<KeptRay> kept = keep_rays(tree(), 4);
    EXPECT_THAT(places(kept), testing::ElementsAre(0, 1, 2, 4));
    EXPECT_EQ(kept[3].parent, 0u);
    EXPECT_EQ(kept[2].parent, 1u);
    EXPECT_EQ(kept[0].left_out, 0u);
    EXPECT_EQ(kept[1].left_out, 0u);
    EXPECT_EQ(kept[2].left_out, 1u);
    EXPECT_EQ(kept[3].left_out, 2u);
}

TEST(KeptRays, NameTheirParentsByTheNewPlaces) {
    const std::vector<KeptRay> kept = keep_rays(tree(), 6);
    EXPECT_THAT(places(kept), testing::ElementsAre(0, 1, 2, 4, 5, 6));
    EXPECT_EQ(kept[4].parent, 3u);
    EXPECT_EQ(kept[5].parent, 3u);
    EXPECT_EQ(kept[2].left_out, 1u);
}

TEST(KeptRays, AreNeverLessThanTheCameraRay) {
    const std::vector<KeptRay> kept = keep_rays(tree(), 0);
    EXPECT_THAT(places(kept), testing::ElementsAre(0));
    EXPECT_EQ(kept[0].left_out, 6u);
}

}  // namespace
}  // namespace rt::kept_rays_test
