// What the lights do at one surface point: POV-Ray's finish, or the general microfacet form.
#pragma once

#include "trace/shadow.h"

namespace rt {

/// One layer of a surface as light meets it.
struct ActiveLayer {
    PigmentColor color;
    const SurfaceFinish* finish = nullptr;
    double opacity = 1.0;
    Rgb above{1.0};  ///< what the layers over it let through
    bool bumped = false;
    Vec3 normal{0.0};  ///< unit; of a bumped layer, else the surface's counts
};

/// Radiance towards the viewer, kept apart by kind.
struct LocalLight {
    Rgb ambient{0.0}, diffuse{0.0}, specular{0.0};
    Rgb sum() const { return ambient + diffuse + specular; }
};

/// `--shading general`: per light (1-s) diffuse pigment (n.l)^brilliance rd + s (n.l) D G F / (4 n.l n.v), s the finish's specular in 0..1,
/// or what else the finish chose of the catalogue. `metallic m` tints the reflectance at normal incidence, F0 (1 + m (pigment - 1)), so
/// that the tint fades towards grazing as it does in POV-Ray. Phong highlights by `phong` and everything else are POV-Ray's in all models.
class Lighting {
public:
    Lighting(const World& world, const TraceOptions& options, const DistanceRules& rules);

    /// Adds what every light contributes to `result`. `inside`: interiors that the viewing ray is in. `log` may be null.
    void direct(const SurfacePoint& at, std::span<const ActiveLayer> layers, std::span<const std::uint32_t> inside, LocalLight& result,
                RayNode* log);

    /// Whether this finish has its ambient light from every lamp, and direct() adds it.
    bool ambient_per_light(const SurfaceFinish& finish) const { return general_ && finish.model.ambient_per_light; }

    std::uint64_t shadow_rays() const { return shadows_.rays; }

private:
    /// What all lights share at one point.
    struct View {
        const SurfacePoint& at;
        std::span<const ActiveLayer> layers;
        std::span<const std::uint32_t> inside;
        bool both_sides = false;  ///< double_illuminate
        bool back_diffuse = false;
        bool any_diffuse = false;
        bool any_highlight = false;
        bool unshadowed = false;  ///< some layer takes from a lamp whether or not its light arrives
        bool ungated = false;     ///< some highlight does not ask on which side the lamp is
        Vec3 mirrored{0.0};
        ViewedPoint seen{};  ///< where a term of the catalogue asks for it
        RayNode* log = nullptr;
    };
    void light_bumped(const SurfacePoint& at, std::span<const ActiveLayer> layers, std::span<const std::uint32_t> inside,
                      LocalLight& result, RayNode* log);
    void light_layers(const SurfacePoint& at, std::span<const ActiveLayer> layers, std::span<const std::uint32_t> inside,
                      LocalLight& result, RayNode* log);
    View view(const SurfacePoint& at, std::span<const ActiveLayer> layers, std::span<const std::uint32_t> inside, RayNode* log) const;
    bool is_seen(const View& view, double n_dot_l, bool shadowless) const;
    void one_light(const LightSource& source, std::uint32_t index, const View& view, LocalLight& result);
    Rgb transmitted(std::uint32_t index, const View& view, const LightRay& ray);
    void area_illumination(const LightSource& source, const Rgb& light, const View& view, LocalLight& result) const;
    void add(const View& view, const LightSource& source, const LightRay& ray, double n_dot_l, const Rgb& light, LocalLight& result) const;
    Rgb povray_highlights(const View& view, const ActiveLayer& layer, const Vec3& l, double n_dot_l) const;
    Rgb catalogue_highlight(const View& view, const ActiveLayer& layer, const Vec3& l, double n_dot_l) const;
    Rgb widened_highlight(const View& view, const ActiveLayer& layer, const LightSource& source, const LightRay& ray) const;
    void add_unshadowed(const LightSource& source, const View& view, const LightRay& ray, double n_dot_l, LocalLight& result) const;

    const World& world_;
    bool general_;
    double facing_;  ///< cosines from here on face the light
    bool cast_shadows_;
    std::vector<LightSource> sources_;
    Shadows shadows_;
};

}  // namespace rt
