// What the differing pixels have in common, where no one mistake explains how they differ: lamps that are hidden or shown pixel by pixel,
// and terms that alone can be wrong there.
#include <fmt/format.h>

#include "commands/causes/scene_causes.h"

namespace rt {

namespace {

/// A point that shows its own light alone: for a lamp more or less at it nothing else changes.
bool is_plain(const PixelSample& sample) {
    for (const RayLog& log : sample.rays)
        if (log.nodes.size() != 1) return false;
    return true;
}

/// Plain samples, each beside the nearest of its light with any one of its lamps, or all, hidden or shown.
struct Lamps {
    Misfit whole, left;
};

Lamps with_lamps_changed(const SceneSamples& samples, bool hide) {
    const ShadedScene shaded{samples.scene(), samples.world(), samples.rules()};
    const std::size_t count = std::min<std::size_t>(samples.world().lights.size(), 16);
    Lamps lamps;
    for (const PixelSample& sample : samples.samples()) {
        if (!is_plain(sample)) continue;
        const float before = apart(shown(sample.light), sample.actual);
        float least = before;
        std::vector<std::uint32_t> choices{~0u};
        for (std::size_t i = 0; i < count; ++i) choices.push_back(1u << i);
        if (count > 2)
            for (std::size_t i = 0; i < count; ++i) choices.push_back(~(1u << i));
        for (const std::uint32_t choice : choices) {
            Rgb light(0.0);
            const Reshading how = hide ? Reshading{.hidden_lamps = choice} : Reshading{.shown_lamps = choice};
            for (const RayLog& log : sample.rays) light += reshaded(shaded, log, how) / static_cast<double>(sample.rays.size());
            least = std::min(least, apart(shown(light), sample.actual));
        }
        lamps.whole.add(before, sample.weight), lamps.left.add(least, sample.weight);
    }
    return lamps;
}

Finding lamp_finding(const SceneSamples& samples, bool hide, bool specks) {
    const Lamps lamps = with_lamps_changed(samples, hide);
    const char* cause = specks ? "shadow acne" : hide ? "false shadows" : "missing shadows";
    // Of what is seen through glass and in mirrors nothing is known: it must not be most of what differs.
    const double known = samples.whole().differing > 0.0 ? lamps.whole.differing / samples.whole().differing : 0.0;
    const double left = known < 0.2 ? 1.0 : share_left(lamps.left, lamps.whole);
    return {
        cause,
        fmt::format("{} lamps {} {} in our own picture would make {:.0f} % of the differing pixels that neither mirror nor transmit what "
                    "they are ({:.0f} of {:.0f})",
                    hide ? "hiding" : "showing", specks ? "from pixel to pixel" : "in places", hide ? "that shine" : "that are hidden",
                    100.0 * (1.0 - left), lamps.whole.differing - lamps.left.differing, lamps.whole.differing),
        left, specks ? 0.04 : 0.1};
}

struct Locus {
    const char *cause, *words;
    Reshading without;  ///< what changes where the term is seen
};
const Locus loci[] = {
    {"specular wrong", "show a highlight", {.specular = 0.0}},
    {"refraction wrong", "show light that was transmitted", {.refraction = 0.0}},
    {"reflection wrong", "show light that was mirrored", {.reflection = 0.0}},
};

/// Nearly all that differs shows the term, and the term is not everywhere.
std::optional<Finding> at_locus(const SceneSamples& samples, const Locus& locus) {
    const std::vector<Rgb> other = reshaded(samples, locus.without);
    double within = 0.0, elsewhere = 0.0;  // pixels with the term
    Misfit outside;
    for (std::size_t i = 0; i < other.size(); ++i) {
        const PixelSample& sample = samples.samples()[i];
        const float difference = apart(shown(sample.light), sample.actual);
        const bool shows = apart(shown(sample.light), shown(other[i])) >= Misfit::visible;
        if (shows) (difference >= Misfit::visible ? within : elsewhere) += sample.weight;
        outside.add(shows ? 0.0f : difference, sample.weight);
    }
    const double share = (within + elsewhere) / samples.picture_pixels();
    if (within < elsewhere || share > 0.6) return std::nullopt;
    return Finding{locus.cause,
                   fmt::format("{:.0f} of about {:.0f} differing pixels {}, {:.1f} % of the picture's do", within,
                               samples.whole().differing, locus.words, 100.0 * share),
                   share_left(outside, samples.whole()), 0.12 + 0.1 * share};
}

}  // namespace

std::vector<Finding> shadow_findings(const SceneSamples& samples, double roughness) {
    return {lamp_finding(samples, true, roughness >= 0.25), lamp_finding(samples, false, false)};
}

std::vector<Finding> locus_findings(const SceneSamples& samples) {
    std::vector<Finding> findings;
    for (const Locus& locus : loci)
        if (std::optional<Finding> found = at_locus(samples, locus)) findings.push_back(std::move(*found));
    return findings;
}

}  // namespace rt
