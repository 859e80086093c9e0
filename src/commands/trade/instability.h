// How much of a picture hangs by the last bits of its numbers: the pixels that move when the processor rounds in another way, or when every
// coordinate is multiplied by 1 + 2^-40, which should not change anything.
#pragma once

#include <array>
#include <vector>

#include "commands/job/render_job.h"
#include "commands/trade/instability_cause.h"

namespace rt {

/// How the scene is rendered again.
enum class Variant : std::uint8_t { downward, upward, toward_zero, scaled };
inline constexpr std::size_t variant_count = 4;
inline constexpr NameTable<Variant, variant_count> variant_names{
    {{"downward", Variant::downward}, {"upward", Variant::upward}, {"toward-zero", Variant::toward_zero}, {"scaled", Variant::scaled}}};

struct UnstablePixel {
    int x = 0, y = 0;  ///< counted from the top left
    UnstableCause cause = UnstableCause::other;
    double moved = 0.0;  ///< the largest change of a channel, 0..1 as displays show it
};

struct Instability {
    std::vector<UnstablePixel> pixels;                    ///< row by row from the top
    std::array<std::size_t, unstable_causes> by_cause{};  ///< how many of them; indexed by UnstableCause
    std::array<std::size_t, variant_count> by_variant{};  ///< how many each rendering moves
    Film picture;          ///< the pixels in the colour of their cause over the dimmed picture; linear light, for the sRGB curve
    bool complete = true;  ///< false after `options.stop`: nothing else is to be used then
};

/// Whether a map says something: not of pictures that take random directions, whose seeds are the rays' own bits (the course's -gi).
bool has_instability(const RenderOptions& options);

/// Builds and renders the scene under each of the processor's four roundings, and once with its coordinates scaled, and compares with the
/// first: a pixel is unstable if a channel, encoded for display and clamped to 0..1, moves by more than 1/255. `job` after read_scene();
/// `options` as render_options() makes them, of which `stop` and `progress` are heeded. The same for any number of threads. Throws what
/// building and rendering throw.
Instability instability(const RenderJob& job, const Scene& scene, const RenderOptions& options);

}  // namespace rt
