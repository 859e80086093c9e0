#include "commands/causes/scene_causes.h"

#include <fmt/format.h>

#include <iterator>

namespace rt {

namespace {

using R = Reshading;

/// A term of the sum that may be missing, or have a factor.
struct Term {
    const char *name, *what;
    double Reshading::*factor;
};
constexpr Term terms[] = {{"specular", "highlights", &R::specular},
                          {"ambient", "ambient light", &R::ambient},
                          {"diffuse", "diffuse light", &R::diffuse},
                          {"reflection", "light of mirrored rays", &R::reflection},
                          {"refraction", "light of transmitted rays", &R::refraction}};

struct Rule {
    const char *cause, *words;  ///< the words stand behind "our own picture"
    Reshading how;
};
const Rule rules[] = {
    {"missing shadows", "without shadows", {.shadows = R::Shadows::none}},
    {"false shadows", "with every lamp hidden everywhere", {.shadows = R::Shadows::everywhere}},
    {"missing lamps", "with its first lamp alone", {.lamps = R::Lamps::first}},
    {"wrong lamp colour", "with white lamps", {.lamps = R::Lamps::white}},
    {"specular wrong", "with exponents 4 times as high", {.exponent_scale = 4.0}},
    {"specular wrong", "with exponents 2 times as high", {.exponent_scale = 2.0}},
    {"specular wrong", "with half the exponents", {.exponent_scale = 0.5}},
    {"specular wrong", "with a quarter of the exponents", {.exponent_scale = 0.25}},
    {"specular wrong", "with roughness in the place of its square", {.lobe = R::Lobe::roughness_not_squared}},
    {"specular wrong", "with Phong's cosine r.v instead of n.h", {.lobe = R::Lobe::phong}},
    {"specular wrong", "with a half vector that is not normalised", {.lobe = R::Lobe::half_not_unit}},
    {"specular wrong", "with highlights times n.l", {.lobe = R::Lobe::times_n_dot_l}},
    {"wrong reflectance model", "with the other of Blinn-Phong and Cook-Torrance", {.lobe = R::Lobe::other_model}},
    {"diffuse wrong", "with the cosine n.l not clamped at 0", {.cosine = R::Cosine::negative_too}},
    {"diffuse wrong", "with |n.l|", {.cosine = R::Cosine::absolute}},
    {"diffuse wrong", "without the cosine n.l", {.cosine = R::Cosine::none}},
    {"light not normalised", "with a direction to the light as long as its distance", {.cosine = R::Cosine::times_distance}},
    {"fading lamps", "with lamps that fade with the square of the distance", {.lamps = R::Lamps::faded}},
    {"ambient wrong", "with ambient light once for each lamp", {.ambient_for_each_lamp = true}},
    {"wrong pigment", "without the pigment in a surface's own light", {.without_pigment = true}},
    {"wrong normals", "with normals turned to the viewer", {.normal = R::Normal::to_viewer}},
    {"mirror not tinted", "without the mirror's colour on what is seen in it", {.untinted_mirrors = true}},
    {"missing filter", "without the colour of transparent objects on what is seen through them", {.unfiltered = true}},
    {"wrong share", "with a surface's own light not weakened by what it mirrors and lets through", {.local_unscaled = true}},
    {"no total reflection", "without total reflection", {.total_reflection_lost = true}},
    {"wrong depth", "with no further rays", {.deepest = 0}},
    {"wrong depth", "with 1 further ray on a path", {.deepest = 1}},
    {"wrong depth", "with 2 further rays on a path", {.deepest = 2}},
    {"wrong depth", "with 3 further rays on a path", {.deepest = 3}},
    {"wrong depth", "with 4 further rays on a path", {.deepest = 4}},
    {"wrong depth", "with 5 further rays on a path", {.deepest = 5}},
};

std::vector<Rgb> own_light(const SceneSamples& samples) {
    std::vector<Rgb> light;
    for (const PixelSample& sample : samples.samples()) light.push_back(sample.light);
    return light;
}

std::vector<Rgb> changed(const std::vector<Rgb>& own, const std::vector<Rgb>& other, double scale) {
    std::vector<Rgb> light;
    for (std::size_t i = 0; i < own.size(); ++i) light.push_back(own[i] + scale * (other[i] - own[i]));
    return light;
}

/// How much of the change from `own` to `other` is in the picture: least squares over the values that are not cut off, three times.
double fitted_scale(const SceneSamples& samples, const std::vector<Rgb>& own, const std::vector<Rgb>& other) {
    double scale = 1.0;
    for (int round = 0; round < 3; ++round) {
        double dd = 0.0, dp = 0.0;
        for (std::size_t i = 0; i < own.size(); ++i)
            for (int c = 0; c < 3; ++c) {
                const double d = other[i][c] - own[i][c], predicted = own[i][c] + scale * d;
                const double actual = static_cast<double>(samples.samples()[i].actual[static_cast<std::size_t>(c)]);
                if (d == 0.0 || predicted < 0.0 || predicted > 1.0 || actual >= 0.998) continue;
                dd += samples.samples()[i].weight * d * d;
                dp += samples.samples()[i].weight * d * (actual - own[i][c]);
            }
        if (!(dd > 0.0)) return 0.0;
        scale = dp / dd;
    }
    return scale;
}

/// Missing if the fitted factor says so, else wrong by that factor.
Finding term_finding(const SceneSamples& samples, const Term& term, const std::vector<Rgb>& own) {
    Reshading without;
    without.*term.factor = 0.0;
    const std::vector<Rgb> other = reshaded(samples, without);
    const Misfit missing = misfit(samples, other);
    const bool further = term.factor == &R::reflection || term.factor == &R::refraction;
    const Finding gone{further ? fmt::format("no {}", term.name) : fmt::format("{} missing", term.name),
                       what_is_left(samples, fmt::format("without {}", term.what), missing), share_left(missing, samples.whole())};
    const double scale = fitted_scale(samples, own, other), factor = 1.0 - scale;
    if (gone.left <= 0.03 || scale == 0.0 || std::fabs(factor) < 0.05) return gone;
    const Misfit scaled = misfit(samples, changed(own, other, scale));
    return {fmt::format("{} wrong", term.name), what_is_left(samples, fmt::format("with {} times {:.3g}", term.what, factor), scaled),
            share_left(scaled, samples.whole()), 0.02};
}

}  // namespace

Misfit misfit(const SceneSamples& samples, const std::vector<Rgb>& light) {
    Misfit left;
    for (std::size_t i = 0; i < light.size(); ++i)
        left.add(apart(shown(light[i]), samples.samples()[i].actual), samples.samples()[i].weight);
    return left;
}

std::string what_is_left(const SceneSamples& samples, const std::string& words, const Misfit& left) {
    return fmt::format("our own picture {} is this one but for {:.1f} % of the difference (about {:.0f} of {:.0f} pixels)", words,
                       100.0 * share_left(left, samples.whole()), left.differing, samples.whole().differing);
}

std::vector<Rgb> reshaded(const SceneSamples& samples, const Reshading& how) {
    const ShadedScene shaded{samples.scene(), samples.world(), samples.rules()};
    std::vector<Rgb> light;
    for (const PixelSample& sample : samples.samples()) {
        Rgb sum(0.0);
        for (const RayLog& log : sample.rays) sum += reshaded(shaded, log, how);
        light.push_back(sum / static_cast<double>(sample.rays.size()));
    }
    return light;
}

std::vector<Finding> reshading_findings(const SceneSamples& samples) {
    std::vector<Finding> findings;
    const std::vector<Rgb> own = own_light(samples);
    for (const Term& term : terms) findings.push_back(term_finding(samples, term, own));
    for (const Rule& rule : rules) {
        const Misfit left = misfit(samples, reshaded(samples, rule.how));
        findings.push_back({rule.cause, what_is_left(samples, rule.words, left), share_left(left, samples.whole())});
    }
    return findings;
}

std::vector<Finding> scene_findings(const SceneSamples& samples, double roughness) {
    std::vector<Finding> findings;
    const auto add = [&](std::vector<Finding> more) {
        findings.insert(findings.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    };
    const bool is_shaded = samples.rules().show == CourseShow::shaded;
    if (is_shaded) add(reshading_findings(samples));
    if (is_shaded) add(path_findings(samples));
    add(retracing_findings(samples));
    if (is_shaded) add(shadow_findings(samples, roughness)), add(locus_findings(samples));
    std::erase_if(findings, [](const Finding& finding) { return !(finding.left <= 0.9); });
    return findings;
}

}  // namespace rt
