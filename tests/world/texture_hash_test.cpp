// Textures that differ in one number have hashes of their own, or a scene with many of them compares all with all.
#include "world/texture_hash.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "tests/scene/checkers.h"

namespace rt::texture_hash_test {
namespace {

std::vector<Texture> with(const StatedPattern& pattern, const std::vector<double>& values, const Bump& bump) {
    PatternPigment patterned;
    patterned.pattern = pattern;
    patterned.map = Shared<ColorMap>(ColorMap{values, {{}, {}}});
    PlainTexture plain;
    plain.pigment.content = Shared<PatternPigment>(patterned);
    plain.normal = Shared<Normal>(Normal{pattern, bump, {}});
    Texture texture;
    texture.content = plain;
    return {texture};
}

TEST(TextureHash, EveryNumberCounts) {
    StatedPattern wood;
    wood.pattern = make_pattern(PatternKind::wood);
    const std::vector<std::function<void(StatedPattern&)>> changes{
        [](StatedPattern&) {},
        [](StatedPattern& p) { p.pattern.frequency = 2.0F; },
        [](StatedPattern& p) { p.pattern.phase = 0.25F; },
        [](StatedPattern& p) { p.pattern.wave = WaveType::sine; },
        [](StatedPattern& p) { p.pattern.wave_exponent = 3.0F; },
        [](StatedPattern& p) { p.pattern.turbulence = Turbulence{Vec3(0.5)}; },
        [](StatedPattern& p) { p.pattern.turbulence = Turbulence{Vec3(0.6)}; },
        [](StatedPattern& p) {
            p.pattern.turbulence = Turbulence{Vec3(0.5), 3};
        },
        [](StatedPattern& p) { p.pattern.warps = {Turbulence{Vec3(0.5)}}; },
        [](StatedPattern& p) { p.pattern.warps = {RepeatWarp{}}; },
        [](StatedPattern& p) { p.pattern.warps = {BlackHoleWarp{}}; },
        [](StatedPattern& p) { p.pattern.warps = {BlackHoleWarp{Vec3(1.0)}}; },
        [](StatedPattern& p) { p.pattern.warps = {MappingWarp{}}; },
        [](StatedPattern& p) { p.pattern.numbers = AgateNumbers{0.5F}; },
        [](StatedPattern& p) { p.pattern.numbers = SpiralNumbers{3}; },
        [](StatedPattern& p) { p.pattern.numbers = GradientNumbers{Vec3(1.0)}; },
        [](StatedPattern& p) { p.uv_mapping = true; },
    };
    std::set<std::size_t> hashes;
    for (const auto& change : changes) {
        StatedPattern changed = wood;
        change(changed);
        hashes.insert(content_hash(with(changed, {0.0, 1.0}, {})));
        EXPECT_EQ(content_hash(with(changed, {0.0, 1.0}, {})), content_hash(with(changed, {0.0, 1.0}, {})));
    }
    hashes.insert(content_hash(with(wood, {0.0, 0.5}, {})));
    Bump low, fine;
    low.amount = 0.25F, fine.accuracy = 0.01F;
    hashes.insert(content_hash(with(wood, {0.0, 1.0}, low)));
    hashes.insert(content_hash(with(wood, {0.0, 1.0}, fine)));
    EXPECT_EQ(hashes.size(), changes.size() + 3);
}

}  // namespace
}  // namespace rt::texture_hash_test
