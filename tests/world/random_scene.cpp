#include "tests/world/random_scene.h"

namespace rt {

namespace {

Transform random_transform(Random& random, double extent) {
    Transform t;
    if (random.chance(0.5)) t = t.then(Transform::scale({random.log(0.2, 5.0), random.log(0.2, 5.0), -random.log(0.2, 5.0)}));
    if (random.chance(0.5)) t = t.then(Transform::scale(Vec3(random.log(0.5, 2.0))));
    if (random.chance(0.7)) t = t.then(Transform::rotate(random.in_cube(180.0), Rotation::povray));
    return t.then(Transform::translate(random.in_cube(extent)));
}

Polygon random_polygon(Random& random, double size) {
    const Vec3 u = random.direction(), v = unit(cross(u, random.direction()));
    Polygon polygon;
    for (const double radius : {1.0, 0.4}) {
        const std::size_t first = polygon.points.size();
        for (int i = 0; i < 5; ++i) {
            const double angle = 2.0 * pi * i / 5.0, r = size * radius * random.real(0.8, 1.0);
            polygon.points.push_back(r * std::cos(angle) * u + r * std::sin(angle) * v);
        }
        polygon.points.push_back(polygon.points[first]);
    }
    return polygon;
}

/// Around the origin, about `size` large.
Shape random_shape(Random& random, double size) {
    const double a = size * random.real(0.2, 1.0), b = size * random.real(0.2, 1.0);
    switch (random.whole(10)) {
        case 0:
            return Sphere{random.in_cube(size), a};
        case 1:
            return Box{-Vec3(a, b, a), Vec3(b, a, b)};
        case 2:
            return Cone{random.in_cube(size), a, random.in_cube(size), random.chance(0.5) ? a : b, random.chance(0.3)};
        case 3:
            return Torus{std::fmax(a, b), 0.9 * std::fmin(a, b)};
        case 4:
            return Disc{random.in_cube(size), random.direction(), a, random.chance(0.5) ? 0.3 * a : 0.0};
        case 5:
            return Triangle{random.in_cube(size), random.in_cube(size), random.in_cube(size)};
        case 6: {
            const Vec3 n = random.direction();
            return SmoothTriangle{random.in_cube(size), random.in_cube(size), random.in_cube(size), n, n, n};
        }
        case 7:
            return random_polygon(random, size);
        case 8: {
            MeshData mesh = closed_mesh(60);
            for (Vec3& vertex : mesh.vertices) vertex *= a;
            return Mesh{mesh};
        }
        default:
            return Plane{random.direction(), random.real(-3.0, 3.0) * size};
    }
}

/// A point where tests are most likely to disagree: a corner or a point of an edge of the object's own outline.
Vec3 delicate_point(Random& random, const Object& object) {
    Vec3 p = std::visit(
        [&](const auto& shape) -> Vec3 {
            using S = std::decay_t<decltype(shape)>;
            const double f = random.chance(0.3) ? 0.0 : random.real(0.0, 1.0);
            if constexpr (std::is_same_v<S, Triangle> || std::is_same_v<S, SmoothTriangle>) {
                return shape.a + f * (shape.b - shape.a);
            } else if constexpr (std::is_same_v<S, Mesh>) {
                const auto& face = shape.data->faces[static_cast<std::size_t>(random.whole(static_cast<int>(shape.data->faces.size())))];
                const Vec3& a = shape.data->vertices[face[0]];
                return a + f * (shape.data->vertices[face[1]] - a);
            } else if constexpr (std::is_same_v<S, Polygon>) {
                return shape.points[0] + f * (shape.points[1] - shape.points[0]);
            } else if constexpr (std::is_same_v<S, Plane>) {
                return shape.distance * shape.normal;
            } else {
                const Bounds box = bounds(shape);
                Vec3 corner = box.min;
                const int axis = random.whole(3);
                for (int i = 0; i < 3; ++i)
                    corner[i] = i == axis ? box.min[i] + f * (box.max[i] - box.min[i]) : random.chance(0.5) ? box.min[i] : box.max[i];
                // On a box this is its edge; on round shapes the middle of a side touches the surface.
                if (!std::is_same_v<S, Box> && random.chance(0.7)) corner[axis] = 0.5 * (box.min[axis] + box.max[axis]);
                return corner;
            }
        },
        object.shape);
    if (object.transform) p = object.transform->point(p);
    return p;
}

}  // namespace

Scene random_scene(Random& random, int objects, double extent) {
    Scene scene;
    for (int i = 0; i < objects; ++i) {
        Object object;
        object.shape = random_shape(random, extent * random.log(0.01, 0.4));
        if (random.chance(0.8)) object.transform = random_transform(random, 0.8 * extent);
        object.no_shadow = random.chance(0.1);
        object.no_image = random.chance(0.05);
        object.no_reflection = random.chance(0.05);
        object.inverse = random.chance(0.1);
        scene.objects.push_back(object);
        if (random.chance(0.1)) scene.objects.push_back(object);  // ties
    }
    return scene;
}

Ray random_ray(Random& random, const Scene& scene, double extent) {
    Vec3 origin = random.in_cube(2.0 * extent);
    switch (random.whole(6)) {
        case 0:
            origin *= 1e3;
            break;
        case 1:
            origin *= random.log(1e3, 1e12);
            break;
        case 2:
            origin *= 0.1;
            break;
        default:
            break;
    }
    if (random.chance(0.25)) return {origin, random.direction()};
    if (random.chance(0.05)) return {origin, Vec3(0.0, random.chance(0.5) ? 1.0 : -1.0, 0.0)};
    const Object& object = scene.objects[static_cast<std::size_t>(random.whole(static_cast<int>(scene.objects.size())))];
    const Vec3 target =
        delicate_point(random, object) + (random.chance(0.5) ? Vec3(0.0) : random.in_cube(extent * random.log(1e-14, 1e-6)));
    return {origin, unit(target - origin)};
}

MeshData closed_mesh(int facets) {
    // A globe of rings; rings crowd towards the upper pole, and the lowest ones are so narrow that their faces are needles.
    const int around = std::max(3, static_cast<int>(std::sqrt(facets)));
    const int rings = std::max(2, facets / (2 * around));
    MeshData mesh;
    mesh.vertices.push_back({0.0, 1.0, 0.0});
    for (int ring = 1; ring < rings; ++ring) {
        const double f = static_cast<double>(ring) / rings;
        const double y = std::cos(pi * f * f * f);
        const double r = std::sqrt(1.0 - y * y);
        for (int i = 0; i < around; ++i)
            mesh.vertices.push_back({r * std::cos(2.0 * pi * i / around), y, r * std::sin(2.0 * pi * i / around)});
    }
    mesh.vertices.push_back({0.0, -1.0, 0.0});
    const auto at = [&](int ring, int i) { return static_cast<std::uint32_t>(1 + (ring - 1) * around + i % around); };
    const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    for (int i = 0; i < around; ++i) {
        mesh.faces.push_back({0, at(1, i), at(1, i + 1)});
        for (int ring = 1; ring + 1 < rings; ++ring) {
            mesh.faces.push_back({at(ring, i), at(ring + 1, i), at(ring, i + 1)});
            mesh.faces.push_back({at(ring, i + 1), at(ring + 1, i), at(ring + 1, i + 1)});
        }
        mesh.faces.push_back({last, at(rings - 1, i + 1), at(rings - 1, i)});
    }
    return mesh;
}

}  // namespace rt
