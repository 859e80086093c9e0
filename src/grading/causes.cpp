#include "grading/causes.h"

#include <iterator>

namespace rt {

namespace {

struct Words {
    std::string_view name, meaning;
};

/// In the order of the enumeration.
constexpr Words words[] = {
    {"no usual cause", "None of the usual mistakes has this look."},
    {"another pixel", "The two records are not of the same pixel of the same picture."},
    {"another number of samples", "The pixel has more or fewer camera rays in B: anti-aliasing is missing, or of another size."},
    {"another camera", "B's camera ray is another one: look at the camera's location, at the lengths of right and up, at the aspect."},
    {"mirrored", "B's ray is the mirror image: handedness, or right taken with the other sign."},
    {"upside down", "B counts rows from the other end, or takes up with the other sign."},
    {"half a pixel off",
     "B's ray goes through a corner or an edge of the pixel, or of its part of it, instead of the centre: the 0.5 is missing."},
    {"missing normalisation", "B's vector points the same way but is not of the same length: it was not made unit, or made so too early."},
    {"missed object", "B does not find the object: look at its intersection, its transform, and the least distance that counts."},
    {"wrong object", "B finds another object first: look at how the nearest hit is kept, and in which space distances are compared."},
    {"far intersection", "B takes a farther intersection with the same object: the smaller positive root, or an inner side, is left out."},
    {"distance in object space", "B's distances are those of the object's own space: it normalises the direction there."},
    {"placement", "The same object is met elsewhere: look at the order of its transforms, the sense of rotation, its size."},
    {"wrong normal side", "B's normal points to the other side: it is turned (or not) towards the viewer, or the winding is reversed."},
    {"wrong normal", "B's normal is another one: inverse transpose of the transform, the shape's own formula, smoothed vertices."},
    {"offset", "B's ray begins at another distance from the surface, or on its other side, and may meet that surface again."},
    {"missing or wrong filter",
     "B lacks what a transparent surface lets through: the filter's share, or the colour that it puts on the light."},
    {"missing or wrong Fresnel reflectance",
     "Mirrored and transmitted light share otherwise than by Schlick's or Fresnel's law, or by the wrong side's cosine or index."},
    {"missing reflection", "B has no mirrored light here: the finish's reflection is left out."},
    {"total reflection",
     "In one record the light is totally reflected, in the other it passes: look at the ratio of the indices and the sign "
     "of the root."},
    {"depth", "One record stops following rays where the other goes on: another recursion depth or bailout."},
    {"wrong refraction ratio", "B bends by another ratio of indices: ior against 1/ior when entering and leaving, or no ior at all."},
    {"wrong mirror direction", "B mirrors in another way: d - 2 (d.n) n with the unit normal on the viewer's side."},
    {"missing shadow", "Light arrives in B that something hides in A: no shadow ray, or one that ends too early."},
    {"false shadow", "B hides light that arrives in A: the surface shadows itself (offset), or what lies beyond the lamp counts."},
    {"missing light", "B does not ask a lamp that A asks, or leaves its light out."},
    {"missing or wrong ambient", "B has no ambient light, or other: ambient times pigment, once for all lamps."},
    {"wrong diffuse light",
     "B's diffuse light is another one: n.l with both unit and at least 0, finish, pigment, lamp colour, attenuation."},
    {"missing highlight", "B has no highlight, or one where A has none: specular left out, or the wrong side of a threshold."},
    {"wrong exponent", "The highlight has another strength: the exponent or roughness, or r.v in place of n.h, or the finish's factor."},
    {"wrong pigment", "B has another colour here: the pigment is left out, put on twice, or another cell of a pattern."},
    {"wrong share",
     "Local, mirrored and transmitted light share otherwise: what the filter, the reflection and Fresnel's law move is taken off "
     "twice, or not at all."},
    {"background", "Rays that leave the scene bring another light."},
    {"clamp", "B cuts light to 0..1 before it is summed: only the finished pixel is cut."},
    {"missing part of the sum", "B's parts agree and their sum does not: one of them is not added, or added twice."},
    {"gamma", "The light agrees and the bytes differ by a power: gamma is put on in one of them alone, or twice."},
    {"rounding", "The light agrees and the bytes are one off: 255 c is cut off, not rounded."},
};
static_assert(std::size(words) == static_cast<std::size_t>(Cause::rounding) + 1);

const Words& words_of(Cause cause) { return words[static_cast<std::size_t>(cause)]; }

}  // namespace

std::string_view name_of(Cause cause) { return words_of(cause).name; }

std::string_view meaning_of(Cause cause) { return words_of(cause).meaning; }

}  // namespace rt
