// Mistakes that break a rule of where rays go.
#include "commands/causes/broken_paths.h"
#include "commands/causes/scene_causes.h"

namespace rt {

namespace {

struct Mistake {
    const char *cause, *words;  ///< the words stand behind "our own picture"
    PathRules rules;
};

const Mistake mistakes[] = {
    {"wrong normals", "with the normals of triangles on the other side", {.normal = Reshading::Normal::triangles_turned}},
    {"wrong normals", "with normals transformed as directions are, not by the inverse transpose", {.normal = Reshading::Normal::by_matrix}},
    {"wrong normals", "with normals left in the object's own space", {.normal = Reshading::Normal::in_object_space}},
    {"normals not normalised", "with normals as long as transforms and edges make them", {.normal = Reshading::Normal::not_unit}},
    {"normals not normalised", "with normals as long as shapes and transforms make them", {.raw_normals = true}},
    {"wrong normal side", "with normals that are not turned to the viewer inside of bodies", {.side_ignored = true}},
    {"shadow acne", "with rays that begin on the surface itself", {.offset = 0.0}},
    {"false shadows", "with rays that begin behind the surface", {.offset = -CourseRules::offset}},
    {"false shadows", "with shadows of what lies behind a lamp", {.shadows_from_behind = true}},
    {"reflection wrong", "with mirrored rays in the opposite direction", {.mirror_reversed = true}},
    {"distances in object space", "with distances counted in the objects' own spaces", {.distances_in_object_space = true}},
};

/// Distances are asked of every object by itself.
constexpr std::size_t most_objects_one_by_one = 100;

}  // namespace

std::vector<Finding> path_findings(const SceneSamples& samples) {
    std::vector<Finding> findings;
    const ShadedScene shaded{samples.scene(), samples.world(), samples.rules()};
    for (const Mistake& mistake : mistakes) {
        if (mistake.rules.distances_in_object_space && samples.scene().objects.size() > most_objects_one_by_one) continue;
        std::vector<Rgb> light;
        for (const PixelSample& sample : samples.samples()) {
            Rgb sum(0.0);
            for (const Ray& ray : samples.rays_of(sample)) sum += reshaded(shaded, follow_broken(shaded, mistake.rules, ray), {});
            light.push_back(sum / static_cast<double>(sample.rays.size()));
        }
        const Misfit left = misfit(samples, light);
        findings.push_back({mistake.cause, what_is_left(samples, mistake.words, left), share_left(left, samples.whole())});
    }
    return findings;
}

}  // namespace rt
