#include "world/compile_pigment.h"

#include <algorithm>

#include "scene/function_source.h"
#include "world/body_probe.h"

namespace rt {

namespace {

bool transmits(const PigmentColor& c) { return std::fabs(c.filter) > 1e-10 || std::fabs(c.transmit) > 1e-10; }

/// The colours that a kind shows without a map.
Shared<ColorMap> default_colors(PatternKind kind) {
    ColorMap map;
    if (list_size(kind) > 0) {
        for (const Rgb& color : default_cell_colors(kind)) {
            map.values.push_back(static_cast<double>(map.values.size()));
            map.colors.push_back({color, 0.0, 0.0});
        }
    } else {
        for (const DefaultMapEntry& entry : default_color_map(kind)) {
            map.values.push_back(entry.value);
            map.colors.push_back({entry.color, 0.0, 0.0});
        }
    }
    return map;
}

class TreeMaker {
public:
    TreeMaker(const PatternDefaults& defaults, PigmentTree& tree) : defaults_(defaults), tree_(tree) {}

    void fill(std::size_t at, const Pigment& pigment, bool uv) {
        tree_[at].quick = pigment.quick_color;
        if (const auto* color = std::get_if<PigmentColor>(&pigment.content)) {
            tree_[at].color = *color;
            return;
        }
        const PatternPigment& stated = *std::get<Shared<PatternPigment>>(pigment.content);
        const auto surface = std::make_shared<PigmentSurface>();
        surface->pattern = compile_pattern(stated.pattern, defaults_, uv);
        uv &= !surface->pattern.uv_mapping;  // seen once at (u, v, 0), its entries have their point from it
        if (const auto* image = std::get_if<Shared<ImageMap>>(&stated.map)) {
            surface->image = **image;
        } else if (const auto* pigments = std::get_if<Shared<PigmentMap>>(&stated.map)) {
            surface->pattern.values = (*pigments)->values;
            const std::size_t first = tree_.size();
            tree_[at].first_child = static_cast<std::uint32_t>(first);
            tree_.resize(first + (*pigments)->pigments.size());
            for (std::size_t i = 0; i < (*pigments)->pigments.size(); ++i) fill(first + i, (*pigments)->pigments[i], uv);
        } else {
            const auto* colors = std::get_if<Shared<ColorMap>>(&stated.map);
            surface->colors = colors ? *colors : default_colors(stated.pattern.pattern.kind);
        }
        tree_[at].surface = surface;
    }

private:
    const PatternDefaults& defaults_;
    PigmentTree& tree_;
};

}  // namespace

std::shared_ptr<const ObjectProbe> ProbeTable::at(const Shared<Bodies>& bodies) {
    const auto known = known_.find(bodies.identity());
    if (known != known_.end()) return known->second.probe;
    return known_.emplace(bodies.identity(), Known{bodies, make_body_probe(*bodies)}).first->second.probe;
}

PatternDefaults pattern_defaults(const Scene& scene) {
    PatternDefaults defaults;
    const GlobalSettings& settings = scene.settings;
    const bool old = scene.language_version > 0.0 && scene.language_version < 3.5;
    defaults.noise = settings.noise_generator.value_or(old ? NoiseGenerator::original : NoiseGenerator::range_corrected);
    if (settings.number_of_waves != GlobalSettings{}.number_of_waves) defaults.sources = wave_sources(settings.number_of_waves);
    return defaults;
}

namespace {

/// A pigment or a pattern that answers.
class CompiledSource final : public FunctionSource {
public:
    CompiledSource(const StatedSource& source, const PatternDefaults& defaults) {
        if (const auto* pigment = std::get_if<Pigment>(&source.stated))
            tree_ = compile_pigment(*pigment, defaults, false);
        else
            pattern_ = compile_pattern(std::get<StatedPattern>(source.stated), defaults, false);
    }

    std::array<double, 6> values(const Vec3& point) const override {
        TexturePoint seen;
        seen.point = point;
        if (tree_.empty()) return {value_at(pattern_, enter(pattern_, point, seen), seen)};
        const PigmentColor color = color_at(tree_, seen, false);
        return {color.rgb.r, color.rgb.g, color.rgb.b, color.filter, color.transmit, grey(color.rgb)};
    }

private:
    PigmentTree tree_;  ///< empty: the pattern
    PatternNode pattern_;
};

/// Functions with compiled sources in the place of stated ones, each once however often it is called.
class FunctionCompiler {
public:
    explicit FunctionCompiler(const PatternDefaults& defaults) : defaults_(defaults) {}

    std::shared_ptr<const Function> compile(const std::shared_ptr<const Function>& stated) {
        if (!stated || stated->source_nodes == 0) return stated;
        std::shared_ptr<const Function>& known = done_[stated.get()];
        if (known) return known;
        Function function = *stated;
        for (std::shared_ptr<const Function>& called : function.called) called = compile(called);
        for (std::shared_ptr<const FunctionSource>& source : function.sources)
            if (const auto* const stated_source = dynamic_cast<const StatedSource*>(source.get()))
                source = std::make_shared<const CompiledSource>(*stated_source, defaults_);
        return known = std::make_shared<const Function>(std::move(function));
    }

private:
    const PatternDefaults& defaults_;
    std::map<const Function*, std::shared_ptr<const Function>> done_;
};

}  // namespace

std::shared_ptr<const Function> compile_function(const std::shared_ptr<const Function>& stated, const PatternDefaults& defaults) {
    return FunctionCompiler(defaults).compile(stated);
}

void compile_functions(FurtherShape& shape, const PatternDefaults& defaults) {
    if (auto* isosurface = std::get_if<Isosurface>(&shape)) isosurface->function = compile_function(isosurface->function, defaults);
}

PatternNode compile_pattern(const StatedPattern& stated, const PatternDefaults& defaults, bool uv) {
    PatternNode node;
    node.pattern = stated.pattern;
    node.uv_mapping = uv || stated.uv_mapping;
    if (!stated.own_noise) node.pattern.noise = defaults.noise;
    if (auto* waves = std::get_if<WavesNumbers>(&node.pattern.numbers); waves != nullptr && defaults.sources)
        waves->sources = *defaults.sources;
    if (const auto* function = std::get_if<std::shared_ptr<const Function>>(&stated.source))
        node.function = compile_function(*function, defaults);
    if (const auto* pigment = std::get_if<Shared<Pigment>>(&stated.source)) node.grey = compile_pigment(**pigment, defaults, false);
    if (const auto* bodies = std::get_if<Shared<Bodies>>(&stated.source)) node.bodies = defaults.probes->at(*bodies);
    return node;
}

PigmentTree compile_pigment(const Pigment& pigment, const PatternDefaults& defaults, bool uv) {
    PigmentTree tree(1);
    TreeMaker(defaults, tree).fill(0, pigment, uv);
    return tree;
}

NormalNode compile_normal(const Normal& normal, const PatternDefaults& defaults, bool uv) {
    NormalNode node;
    node.pattern = compile_pattern(normal.pattern, defaults, uv);
    node.bump = normal.bump;
    if (!normal.map) return node;
    node.pattern.values = (*normal.map)->values;
    uv &= !node.pattern.uv_mapping;
    for (const Normal& child : (*normal.map)->normals) node.children.push_back(compile_normal(child, defaults, uv));
    return node;
}

bool uses_uv(const PatternNode& node) { return node.uv_mapping || uses_uv(node.grey); }

bool uses_uv(const PigmentTree& tree) {
    return std::any_of(tree.begin(), tree.end(), [](const PigmentNode& node) { return node.surface && uses_uv(node.surface->pattern); });
}

bool uses_uv(const NormalNode& node) {
    return uses_uv(node.pattern) ||
           std::any_of(node.children.begin(), node.children.end(), [](const NormalNode& child) { return uses_uv(child); });
}

bool can_transmit(const PigmentTree& tree) {
    const auto transparent_texel = [](const std::array<float, 4>& texel) { return texel[3] > 1e-10F; };
    return std::any_of(tree.begin(), tree.end(), [&](const PigmentNode& node) {
        if (!node.surface) return transmits(node.color);
        const PigmentSurface& surface = *node.surface;
        if (surface.image) {
            const ImageMap& map = *surface.image;
            return map.mapping.once || transmits({Rgb(0.0), map.filter, map.transmit}) ||
                   std::any_of(map.image->texels.begin(), map.image->texels.end(), transparent_texel);
        }
        return surface.colors && std::any_of((*surface.colors)->colors.begin(), (*surface.colors)->colors.end(), transmits);
    });
}

}  // namespace rt
