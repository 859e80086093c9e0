// The scene's textures and interiors as the compiled lists, equal ones once.
#pragma once

#include <unordered_map>
#include <vector>

#include "world/compile.h"
#include "world/compile_pigment.h"

namespace rt {

/// Collects materials; objects with the same textures and the same index of refraction share one.
class MaterialTable {
public:
    /// Materials with more than `max_nodes` pigments beyond the first of each are a LimitError.
    MaterialTable(const Scene& scene, const CompileOptions& options, const MessageSink& warn, std::size_t max_nodes = 2'000'000)
        : scene_(scene), options_(options), warn_(warn), defaults_(pattern_defaults(scene)), max_nodes_(max_nodes) {}

    /// Index of the object's material.
    std::uint32_t add(const Object& object);
    std::vector<Material> take() { return std::move(materials_); }
    const Material& operator[](std::uint32_t index) const { return materials_[index]; }

private:
    /// What a material was made from. The scene outlives the table.
    struct Origin {
        const TextureLayers* texture;
        const TextureLayers* interior_texture;
        double ior;
        bool uv_mapping;
        const std::vector<TextureLayers>* shape_textures;
        std::uint32_t material;
    };
    std::uint32_t add(Origin origin, const Span& span);
    std::size_t hash(const TextureLayers& layers);
    Material make(const Origin& origin, const Span& span);
    void add_shape_textures(const Origin& origin, const Span& span, Material& material);
    std::vector<LayerNode> make_layers(const std::vector<Texture>& layers, double ior, bool uv, const Span& span);
    LayerNode make_layer(const Texture& texture, double ior, bool uv, const Span& span);
    SurfaceFinish make_finish(const Finish& finish, double ior, const Span& span);
    void warn_of_range(const SurfaceFinish& surface, bool share_stated, const Span& span);
    void choose_mirror(SurfaceFinish& surface, const Span& span);

    /// A table and what it was made from: finishes with equal lobes share it.
    struct KnownAlbedo {
        MicrofacetTerms terms;
        Interface interface[3];
        double alpha;
        std::shared_ptr<const AlbedoTable> table;
    };

    const Scene& scene_;
    const CompileOptions& options_;
    const MessageSink& warn_;
    PatternDefaults defaults_;
    std::vector<Material> materials_;
    std::unordered_multimap<std::size_t, Origin> by_content_;
    std::unordered_map<const void*, std::size_t> hashes_;  ///< of the layers that are more than one pigment
    std::size_t max_nodes_;
    std::size_t nodes_ = 0;
    std::vector<KnownAlbedo> albedos_;
    bool warned_specular_ = false, warned_alpha_ = false, warned_reflection_ = false;
};

/// The interior of an object with the legacy keywords of its finish merged in.
CompiledInterior compile_interior(const Object& object);

/// The finish whose legacy keywords count for the object: the top layer's, unless that is a pattern of textures.
const Finish* legacy_finish(const Object& object);

/// The index of refraction that the file states for the object, in a finish or an interior.
std::optional<double> stated_ior(const Object& object);

}  // namespace rt
