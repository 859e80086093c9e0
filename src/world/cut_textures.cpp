// What shows on surfaces that cut a set: POV-Ray's `cutaway_textures`.

#include "world/surfaces.h"

namespace rt {

bool Surfaces::cut_weights(std::uint32_t object, const Vec3& point, double least, std::vector<TextureWeight>& out) const {
    const Surface& s = objects[object];
    if (s.kind != SurfaceKind::part && s.kind != SurfaceKind::part_triangles) return false;
    const std::uint32_t own = parts[s.part].body;
    if (!bodies[own].cuts) return false;
    // As POV-Ray has it: unions do not pass on what they are in, every intersection around does.
    std::uint32_t whole = own;
    for (std::uint32_t body = bodies[own].parent; body != Body::none; body = bodies[body].parent)
        if (bodies[body].kind == SetNode::Kind::all && !bodies[body].clips) whole = body;
    const std::size_t first = out.size();
    for (std::uint32_t part = whole + 1; part < bodies[whole].end; part = bodies[part].end) add_shown(part, own, point, out);
    const auto count = static_cast<double>(out.size() - first);
    if (1.0 / count < least) out.resize(first);
    join_textures(out, first);
    for (std::size_t i = first; i < out.size(); ++i) out[i].weight /= count;
    return true;
}

/// Appends the textures that the body shows at a point on the surface of the body `own`, and whether the point is in it. On its own surface
/// it is, where POV-Ray leaves that to rounding for all but planes. Clips and bounds are not asked for.
bool Surfaces::add_shown(std::uint32_t body, std::uint32_t own, const Vec3& point, std::vector<TextureWeight>& out) const {
    const Body& b = bodies[body];
    if (b.kind == SetNode::Kind::surface || b.kind == SetNode::Kind::solid) {
        if (body != own && !holds(body, point)) return false;
        if (b.texture != TextureWeight::of_object) out.push_back({b.texture, 1.0});
        return true;
    }
    if (b.clips || b.kind == SetNode::Kind::bounded) return add_shown(body + 1, own, point, out);
    const std::size_t first = out.size();
    bool any = false;
    for (std::uint32_t part = body + 1; part < b.end; part = bodies[part].end) {
        if (add_shown(part, own, point, out)) {
            any = true;
        } else if (b.kind == SetNode::Kind::all) {
            out.resize(first);
            return false;
        }
    }
    return any || b.kind == SetNode::Kind::all;
}

}  // namespace rt
