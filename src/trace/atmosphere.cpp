#include "trace/atmosphere.h"

#include <algorithm>

#include "shading/povray_finish.h"

namespace rt {

namespace {

constexpr double length_of_nothing = 2e10;  ///< of a ray that meets nothing
constexpr double degree = pi / 180.0;

/// Share of fog at a height above its full part, in units of its altitude, on the mean between two heights:
/// the density is 1 below 0 and 1 / (h^2 + 1) above.
double mean_density(double h0, double h1) {
    if (h0 <= 0.0 && h1 <= 0.0) return 1.0;
    if (h0 > 0.0 && h1 > 0.0) return h0 == h1 ? 1.0 / (h0 * h0 + 1.0) : (std::atan(h0) - std::atan(h1)) / (h0 - h1);
    const double above = std::fmax(h0, h1), below = std::fmin(h0, h1);
    return (std::atan(above) - below) / (above - below);
}

double fog_depth(const Fog& fog, const Ray& ray, double length, NoiseGenerator noise) {
    double s = length;
    if (fog.turbulence) {
        const Vec3 middle = fog.turbulence->amount * ray.at(0.5 * length);
        const double t = std::fmin(1.0, scalar_turbulence(noise, *fog.turbulence, middle) * static_cast<double>(fog.turbulence_depth));
        s *= 1.0 - std::exp(-length / fog.distance) * t;
    }
    if (fog.type == Fog::Type::constant) return s / fog.distance;
    const double height = dot(ray.origin, fog.up), rise = dot(ray.direction, fog.up);
    const double h0 = (height - fog.offset) / fog.altitude, h1 = (height + length * rise - fog.offset) / fog.altitude;
    return s * mean_density(h0, h1) / fog.distance;
}

PigmentColor color_in(const ColorMap& map, double value) {
    const MapPlace place = find_in_map(map.values, value);
    const PigmentColor &a = map.colors[place.lower], &b = map.colors[place.upper];
    const double w = place.weight;
    return {a.rgb + w * (b.rgb - a.rgb), a.filter + w * (b.filter - a.filter), a.transmit + w * (b.transmit - a.transmit)};
}

}  // namespace

Atmosphere::Atmosphere(const World& world) : world_(world) {
    for (const Rainbow& stated : world.rainbows) {
        const Vec3 axis = unit(stated.direction);
        const Vec3 right = unit(cross(axis, stated.up));
        bows_.push_back({&stated, axis, cross(right, axis), right});
    }
}

/// Bodies that are not hollow keep the fog out.
bool Atmosphere::is_open(std::span<const std::uint32_t> inside) const {
    return std::all_of(inside.begin(), inside.end(), [&](std::uint32_t interior) { return world_.interiors[interior].hollow; });
}

Rgb Atmosphere::dimmed(const Ray& ray, double length, std::span<const std::uint32_t> inside) const {
    return is_open(inside) ? fog(ray, length).left : Rgb(1.0);
}

Veil Atmosphere::along(const Ray& ray, double length, std::span<const std::uint32_t> inside) const {
    if (!is_open(inside)) return {};
    const double s = std::fmin(length, length_of_nothing);
    Veil veil = fog(ray, s);
    if (!bows_.empty()) arch(ray, s, veil);
    return veil;
}

Veil Atmosphere::fog(const Ray& ray, double length) const {
    Veil veil;
    for (const Fog& fog : world_.fogs) {
        const double a = std::fmax(std::exp(-fog_depth(fog, ray, length, world_.noise)), fog.color.transmit);
        veil.light += (1.0 - a) * fog.color.rgb;
        veil.left *= a * (Rgb(1.0 - fog.color.filter) + fog.color.filter * fog.color.rgb);
        veil.transmittance *= a;
    }
    return veil;
}

/// Behind the fog.
void Atmosphere::arch(const Ray& ray, double length, Veil& veil) const {
    int count = 0;
    Rgb light(0.0), left(0.0);
    for (const Bow& bow : bows_) {
        const Rainbow& r = *bow.stated;
        const double along = dot(ray.direction, bow.axis);
        const double index = (std::acos(std::clamp(along, -1.0, 1.0)) / degree - (r.angle - 0.5 * r.width)) / r.width;
        if (!(along >= 0.0 && index >= 0.0 && index < 1.0)) continue;
        const double x = dot(ray.direction, bow.right), y = dot(ray.direction, bow.up);
        const double across = std::sqrt(x * x + y * y);
        const double arc = across == 0.0 ? 0.0 : std::acos(std::clamp(y / across, -1.0, 1.0)) / degree;
        if (!(arc <= r.arc_angle)) continue;
        const PigmentColor c = color_in(*r.colors, index);
        const double fade = arc > r.falloff_angle ? cubic_step(r.falloff_angle, r.arc_angle, arc) : 0.0;
        const double k = std::fmax(std::exp(-length / r.distance), fade * (1.0 - c.transmit) + c.transmit);
        light += (1.0 - k) * c.rgb;
        left += k * (Rgb(1.0 - c.filter * (1.0 - k)) + c.filter * (1.0 - k) * c.rgb);
        ++count;
    }
    if (count == 0) return;
    veil.light += veil.left * light / static_cast<double>(count);
    veil.left *= left / static_cast<double>(count);
}

Rgb Atmosphere::sky(const Vec3& direction, double& transmittance) const {
    TexturePoint seen;
    seen.point = direction;
    Rgb light(0.0), filter(1.0);
    if (world_.legacy_opacity) {
        PigmentColor product{Rgb(1.0), 1.0, 1.0};
        double left = 1.0;
        for (std::size_t i = world_.sky.size(); i-- > 0;) {
            const PigmentColor c = color_at(world_.sky[i], seen, false);
            light += left * (1.0 - c.filter - c.transmit) * c.rgb;
            product = {product.rgb * c.rgb, product.filter * c.filter, product.transmit * c.transmit};
            left = std::fabs(product.filter) + std::fabs(product.transmit);
        }
        light *= world_.sky_emission;
        filter = product.filter * product.rgb + Rgb(product.transmit);
    } else {
        for (std::size_t i = world_.sky.size(); i-- > 0;) {
            const PigmentColor c = color_at(world_.sky[i], seen, false);
            light += filter * (1.0 - c.filter - c.transmit) * c.rgb * world_.sky_emission;
            filter *= c.filter * c.rgb + Rgb(c.transmit);
        }
    }
    transmittance = std::fabs(grey(filter));
    return light + filter * world_.background;
}

}  // namespace rt
