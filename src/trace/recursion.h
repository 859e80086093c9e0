// The recursion of one worker: a ray to the light that comes back along it.
#pragma once

#include "trace/atmosphere.h"
#include "trace/footprint.h"
#include "trace/interior_list.h"
#include "trace/lighting.h"
#include "trace/tracer.h"

namespace rt {

/// A ray on its way, with everything that its past decides. Transmitted rays continue the same path; only mirrored ones start another.
struct Path {
    Ray ray;
    double weight = 1.0;  ///< how much its light can matter to the pixel
    int level = 0;        ///< rays entered before it
    int mixtures = 0;     ///< of textures on the way
    RayKind kind = RayKind::image;
    bool straight = false;       ///< goes on unbent: not a new level
    std::uint8_t nested = 0;     ///< mixtures of which the path is not the main way
    Rgb filter{1.0};             ///< on light found from here on
    double transmittance = 1.0;  ///< share of the background that shows, for alpha
};

class Recursion {
public:
    Recursion(const World& world, const TraceOptions& options);

    Radiance camera_ray(const Ray& ray, RayLog* log);
    /// The same light for each, one by one or together.
    void camera_rays(std::span<const Ray> rays, std::span<Radiance> light);

    RayCounts counts;
    std::uint64_t shadow_rays() const { return lighting_.shadow_rays(); }

private:
    /// A layer's mirror, remembered until it is known that the surface does not reflect totally.
    struct Mirror {
        Rgb reflectivity;
        double weight = 0.0;
        double exponent = 1.0;
        Vec3 normal{0.0};
    };
    /// A surface with its layers resolved; ranges of the scratch vectors.
    struct Surface {
        SurfacePoint at;
        const CompiledObject* object = nullptr;
        std::size_t first_layer = 0, first_mirror = 0;
        Rgb filter{1.0};     ///< of all layers together
        double trans = 1.0;  ///< its grey value, at most 1
        Crossing crossing{};
        std::uint32_t node = RayNode::none;
        Vec3 top_normal{0.0};  ///< of the top layer
        double share = 1.0;    ///< of the light of several textures that are mixed
    };

    /// The first surface on a path, where it was searched for beforehand.
    struct FirstHit {
        const Hit* hit;  ///< null: there is none
    };
    void start(const Ray& ray, const FirstHit* first, Radiance& result);
    void trace(Path path, std::size_t first_interior, std::uint32_t first_node, const FirstHit* first, Radiance& result);
    bool step(Path& path, Radiance& result, std::uint32_t& at_node, const FirstHit* known);
    SurfacePoint surface_point(const Ray& ray, const Hit& hit) const;
    bool shade(Surface& surface, std::span<const LayerSample> layers, const Hit& hit, Path& path, Radiance& result, std::uint32_t& at_node);
    /// How a mixture goes on: all of its textures together, or the one with the largest share.
    struct OneWay {
        Path path;
        std::uint32_t node = RayNode::none;
        std::vector<std::uint32_t> inside;  ///< its interiors
        RayCounts counts;
    };
    /// A mixture of textures: each as if it were alone, to the end of its paths, with its share of the light. Where they all go on in one
    /// direction the path goes on once, with what they let through together, or their number would grow with each surface; else behind the
    /// largest share, or the stack would grow. True if it goes on.
    bool mix(const Surface& surface, const SampledTexture& texture, const Hit& hit, Path& path, Radiance& result, std::uint32_t& at_node);
    void join(std::optional<OneWay>& way, const Path& branch, std::uint32_t branch_node);
    // Parts of shade(), which every surface goes through.
    [[gnu::always_inline]] inline void resolve_layers(Surface& surface, std::span<const LayerSample> layers, double weight);
    Rgb local_light(const Surface& surface);
    Rgb film_on_total(const Surface& surface) const;
    [[gnu::always_inline]] inline bool pass(const Surface& surface, Path& path, Radiance& result, std::uint32_t& at_node);
    void reflect_layers(const Surface& surface, const Path& path, Radiance& result);
    std::uint32_t start_node(std::uint32_t parent, RayNode::Kind kind, const Path& path, const Rgb& factor, double exponent);
    RayNode* node(std::uint32_t index);
    void veil(Path& path, double length, Radiance& result, RayNode* record) const;
    void leave_scene(const Path& path, Radiance& result, RayNode* record) const;
    void log_surface(RayNode& record, const Surface& surface, const Hit& hit) const;
    std::span<const std::uint32_t> inside() const { return std::span(interiors_).subspan(first_interior_); }

    const World& world_;
    Quality quality_;
    DistanceRules rules_;
    Lighting lighting_;
    SurfaceLayers layers_at_;
    std::optional<Footprints> footprints_;
    std::shared_ptr<const Environment> environment_;
    Atmosphere atmosphere_;
    int max_level_;
    double adc_bailout_;

    // Scratch, used as stacks: a ray leaves them as it found them.
    std::vector<std::uint32_t> interiors_;
    std::size_t first_interior_ = 0;  ///< of the path in hand
    std::vector<ActiveLayer> layers_;
    std::vector<Mirror> mirrors_;
    RayLog* log_ = nullptr;
};

}  // namespace rt
