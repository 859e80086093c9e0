"""The faults: what each gets wrong, and where in src/.

A change is (file, before, after). `before` is text that occurs once in the file, with [[ ]] around the expression that the fault replaces
by `after`. Several faults may replace the same expression.
"""

COURSE = "trace/course_recursion.cpp"
COURSE_POINT = "trace/course_recursion.h"
POVRAY = "trace/recursion.cpp"
LIGHTING = "trace/lighting.cpp"
SHADOW = "trace/shadow.cpp"
DISTANCES = "trace/distances.h"
CAMERA = "trace/camera.h"
SURFACES = "world/surfaces.cpp"
SAMPLING = "trace/sampling.cpp"
ENCODING = "commands/job/encoding.cpp"

U = (CAMERA, "u = [[x / width - 0.5]];")
V = (CAMERA, "v = [[0.5 - y / height]];")
MIRROR_DIRECTION = (COURSE, "unit([[reflect(path.ray.direction, point.side)]])")
POVRAY_MIRROR_DIRECTION = (POVRAY, "const Vec3 direction = [[reflect_bumped(surface.at.direction, mirror.normal, surface.at.normal)]];")
RATIO = (COURSE, "ratio = [[point.inside() ? surface.ior : 1.0 / surface.ior]];")
POVRAY_RATIO = (POVRAY, "surface.at.direction), [[surface.crossing.ratio]]);")
FURTHER_OFFSET = (COURSE, "point.at + [[CourseRules::offset]] * direction, direction},\n              .kind = mirror ?")
SHADOW_OFFSET = (COURSE, "start = point.at + [[CourseRules::offset]] * point.side;")
LEAVE = (DISTANCES, "return [[at.point + (dot(at.side, direction) < 0.0 ? -at.error : at.error) * at.side]];")
PLACED_NORMAL = (SURFACES, "return [[placed.to_world.normal(normal(placed.shape, own_point, hit))]];")
COURSE_LOBE = (COURSE, ": [[course::blinn_phong(dot(point.normal, course::half_vector(l, point.to_viewer)), surface.roughness)]];")
POVRAY_N_DOT_H = (LIGHTING, "specular_lobe([[dot(half, view.at.normal) / size]], ")
DEPTH = (COURSE, "path.level < [[rules_.further_rays]]")
POVRAY_DEPTH = (POVRAY, "max_level_([[std::clamp(options.max_trace_level.value_or(world.max_trace_level), 1, GlobalSettings::highest_trace_level)]]),")
TRANSMISSION = (COURSE, "if ([[shares.transmission > 0.0]])")
THROUGH = (POVRAY, "if ([[!through]]) return false;")
SHADOW_LIT = (COURSE, "way != Vec3(0.0) && [[lit(point, light)]];")
TRANSMITTED_SHADOW = (LIGHTING, "return [[shadows_.transmitted(index, view.at, ray, view.inside, nullptr)]];")
LOGGED_SHADOW = (LIGHTING, "const Rgb light = [[shadows_.transmitted(index, view.at, ray, view.inside, &answer)]];")
PIGMENT_ON_ENTRY = (COURSE, "CourseRules::beer_density) : [[point.surface.pigment]];")
# A shadow ray that meets the surface it starts on would do so ten thousand times before it is dark.
CROSSINGS = (SHADOW, "i < [[most_shadow_crossings]]; ++i) {")
AREA_SHADOW = (SHADOW, "color * [[transmitted(index, at, ray, inside, log != nullptr ? &answer : nullptr)]];")

# name: (what is wrong, changes)
FAULTS = {
    "mirrored": ("the picture's left is its right", [(*U, "0.5 - x / width")]),
    "upside_down": ("the picture's top is its bottom", [(*V, "y / height - 0.5")]),
    "half_pixel": ("camera rays go through the pixels' corners", [(*U, "(x - 0.5) / width - 0.5"), (*V, "0.5 - (y - 0.5) / height")]),
    "normal_side": (
        "the normal is not turned to the viewer inside of a body",
        [
            (COURSE, "-ray.direction, [[inside ? -normal : normal]],", "normal"),
            (COURSE_POINT, "return [[dot(normal, to_viewer) < 0.0]];", "false"),
            (POVRAY, ".normal = [[away ? -normal : normal]],", "normal"),
        ],
    ),
    "triangle_side": (
        "the normals of triangles are those of the other order of corners",
        [(SURFACES, "return [[s.mirrored ? -n : n]];", "s.mirrored ? n : -n")],
    ),
    "normal_by_matrix": (
        "normals are transformed like directions, not by the inverse transpose",
        [(*PLACED_NORMAL, "placed.to_world.direction(normal(placed.shape, own_point, hit))")],
    ),
    "normal_in_object_space": (
        "normals stay in the object's own space",
        [(*PLACED_NORMAL, "normal(placed.shape, own_point, hit)")],
    ),
    "normal_unnormalised": (
        "the normals of transformed objects and triangles have any length",
        [(SURFACES, "n = [[in_range_unit(n)]];", "n")],
    ),
    "half_unnormalised": (
        "the half vector is l + v",
        [
            (*COURSE_LOBE, "course::blinn_phong(dot(point.normal, l + point.to_viewer), surface.roughness)"),
            (*POVRAY_N_DOT_H, "dot(half, view.at.normal)"),
        ],
    ),
    "light_unnormalised": (
        "the direction to the light has the light's distance as its length",
        [
            (COURSE, "const Vec3 l = [[unit(way)]];", "way"),
            (LIGHTING, "const Vec3& l = [[ray.direction]];", "ray.direction * ray.distance"),
            (LIGHTING, "} else {\n        add(view, source, ray, [[n_dot_l]], arriving, result);", "n_dot_l * ray.distance"),
        ],
    ),
    "object_space_distance": (
        "distances are those of the object's own space, with the ray's direction normalised there",
        [
            (
                SURFACES,
                "return intersect(placed.shape, [[placed.to_world.inverse_ray(query.ray)]],",
                "Ray{placed.to_world.inverse_point(query.ray.origin), unit(placed.to_world.inverse_direction(query.ray.direction))}",
            )
        ],
    ),
    "offset_missing": (
        "further rays begin on the surface itself",
        [
            (*FURTHER_OFFSET, "0.0"),
            (*SHADOW_OFFSET, "0.0"),
            (*LEAVE, "at.point"),
            (*CROSSINGS, "10"),
            (DISTANCES, "Interval{[[1e-4]], 1e7}", "0.0"),
            (DISTANCES, "return {[[1e-3]], std::min", "0.0"),
        ],
    ),
    "offset_reversed": (
        "further rays begin behind the surface that they leave",
        [
            (*FURTHER_OFFSET, "-CourseRules::offset"),
            (*SHADOW_OFFSET, "-CourseRules::offset"),
            (*LEAVE, "at.point - (dot(at.side, direction) < 0.0 ? -1e-3 : 1e-3) * at.side"),
            (*CROSSINGS, "10"),
        ],
    ),
    "no_shadows": ("nothing casts shadows", [(*SHADOW_LIT, "true"), (*TRANSMITTED_SHADOW, "Rgb(1.0)"), (*LOGGED_SHADOW, "Rgb(1.0)"), (*AREA_SHADOW, "Rgb(1.0)")]),
    "opaque_shadows": (
        "transparent objects cast the shadows of opaque ones",
        [(SHADOW, "if ([[!world_.materials[object.material].can_transmit]]) return", "true")],
    ),
    "glass_without_shadow": (
        "transparent objects cast no shadows",
        [
            (COURSE, "return [[!world_.features.transmits || !world_.nearest(ray, between, RayKind::shadow, hit)]];", "true"),
            (SHADOW, "light *= [[filtered(hit, point, ray.direction, facing)]];", "Rgb(1.0)"),
        ],
    ),
    "shadow_from_behind": (
        "objects behind the light cast shadows",
        [
            (COURSE, "between{0.0, [[distance]]};", "infinity"),
            (DISTANCES, "return {1e-3, [[std::min(distance - 1e-3, 1e7)]]};", "1e7"),
            (DISTANCES, "return {0.0, [[distance * (1.0 - relative) - 2.0 * error]]};", "infinity"),
        ],
    ),
    "unfiltered": (
        "the colour of a transparent object is not put on what is seen through it",
        [
            (*PIGMENT_ON_ENTRY, "Rgb(1.0)"),
            (POVRAY, "surface.filter *= [[c.filter * c.rgb + Rgb(c.transmit)]];", "Rgb(c.filter + c.transmit)"),
        ],
    ),
    "mirror_untinted": (
        "the colour of a mirror is not put on what is seen in it",
        [
            (COURSE, "factor = share * [[point.surface.pigment]];", "Rgb(1.0)"),
            (POVRAY, "r.rgb *= [[metallic_tint(pigment, mirror.metallic, cos)]];", "Rgb(1.0)"),
        ],
    ),
    "depth_short": (
        "recursion ends one level early",
        [
            (*DEPTH, "rules_.further_rays - 1"),
            (*POVRAY_DEPTH, "std::clamp(options.max_trace_level.value_or(world.max_trace_level) - 1, 1, 256)"),
        ],
    ),
    "depth_long": (
        "recursion ends one level late",
        [
            (*DEPTH, "rules_.further_rays + 1"),
            (*POVRAY_DEPTH, "std::clamp(options.max_trace_level.value_or(world.max_trace_level) + 1, 1, 256)"),
        ],
    ),
    "ior_inverted": (
        "the ratio of the indices of refraction is upside down",
        [(*RATIO, "point.inside() ? 1.0 / surface.ior : surface.ior"), (*POVRAY_RATIO, "1.0 / surface.crossing.ratio")],
    ),
    "unbent": ("transmitted rays go straight on", [(*RATIO, "1.0"), (*POVRAY_RATIO, "1.0")]),
    "no_fresnel": (
        "reflectance does not follow Fresnel",
        [(COURSE, "F = [[rules_.fresnel]] ?", "false"), (POVRAY, "if ([[mirror.fresnel]]) {", "false")],
    ),
    "fresnel_sides": (
        "reflectance is wrong inside: the cosine has its sign there, or the index is that of the other side",
        [
            (COURSE, "n_dot_v = [[std::fabs(dot(point.normal, point.to_viewer))]];", "dot(point.normal, point.to_viewer)"),
            (POVRAY, "fresnel_reflectance([[fresnel_eta]], cos);", "1.0 / fresnel_eta"),
        ],
    ),
    "no_absorption": (
        "light is not weakened by its way inside of a body (Beer)",
        [
            (COURSE, "rules_.beers ? [[course::beers_law(point.surface.pigment, arrival.t, CourseRules::beer_density)]] :", "Rgb(1.0)"),
            (POVRAY, "factor *= [[distance_fade(surface.at.t, medium.fade_distance, medium.fade_power, medium.fade_color)]];", "Rgb(1.0)"),
        ],
    ),
    "no_total_reflection": (
        "total internal reflection is lost",
        [
            (*TRANSMISSION, "shares.transmission > 0.0 && !bent.total"),
            (COURSE, "shares(surface, F, [[bent.total]]);", "false"),
            (*THROUGH, "!through || bent.total"),
        ],
    ),
    "no_transmission": ("nothing is seen through transparent objects", [(*TRANSMISSION, "false"), (*THROUGH, "true")]),
    "no_reflection": (
        "nothing is seen in mirrors",
        [
            (COURSE, "if ([[shares.reflection > 0.0]])", "false"),
            (POVRAY, "if ([[quality_.reflection && r.rgb != Rgb(0.0)]])", "false"),
        ],
    ),
    "wrong_mirror": (
        "the mirrored direction has the wrong sign",
        [
            (*MIRROR_DIRECTION, "-reflect(path.ray.direction, point.side)"),
            (*POVRAY_MIRROR_DIRECTION, "-reflect_bumped(surface.at.direction, mirror.normal, surface.at.normal)"),
        ],
    ),
    "no_ambient": (
        "there is no ambient light",
        [
            (COURSE, "? [[surface.ambient * surface.pigment]] :", "Rgb(0.0)"),
            (POVRAY, "light.ambient += [[layer.above * layer.color.rgb * layer.opacity * (ambient + finish.emission)]];", "Rgb(0.0)"),
        ],
    ),
    "no_diffuse": (
        "there is no diffuse light",
        [
            (COURSE, "sum.diffuse += [[surface.diffuse]] *", "0.0"),
            (LIGHTING, "double diffuse = [[std::fmax(0.0, front ? finish.diffuse : finish.diffuse_back) * layer.opacity]];", "0.0"),
        ],
    ),
    "no_specular": (
        "there are no highlights",
        [
            (COURSE, "if ([[surface.specular == 0.0]]) continue;", "true"),
            (LIGHTING, "if ([[source.light().shadowless || !view.any_highlight]]) continue;", "true"),
        ],
    ),
    "wrong_exponent": (
        "highlights have another exponent or width",
        [
            (*COURSE_LOBE, "course::blinn_phong(dot(point.normal, course::half_vector(l, point.to_viewer)), std::sqrt(surface.roughness))"),
            (LIGHTING, "/ size, [[layer.finish->specular_exponent]]);", "4.0 * layer.finish->specular_exponent"),
            (LIGHTING, "highlight([[model]], view.seen", "[&] { SurfaceModel m = model; m.alpha = std::sqrt(m.alpha); return m; }()"),
        ],
    ),
    "phong_for_blinn": (
        "highlights follow the mirrored direction (Phong) instead of the half vector (Blinn)",
        [
            (*COURSE_LOBE, "course::blinn_phong(dot(reflect(-l, point.normal), point.to_viewer), surface.roughness)"),
            (*POVRAY_N_DOT_H, "dot(view.mirrored, l)"),
        ],
    ),
    "white_lights": (
        "all lights are white",
        [
            (COURSE, "dot(point.normal, l)) * [[light.color]] *", "Rgb(1.0)"),
            (COURSE, "highlight * [[light.color]] *", "Rgb(1.0)"),
            (LIGHTING, "Rgb arriving = [[light.color]];", "Rgb(1.0)"),
        ],
    ),
    "one_light": (
        "only the first light shines",
        [
            (COURSE, "i < [[world_.lights.size()]]; ++i) {", "std::min<std::size_t>(1, world_.lights.size())"),
            (LIGHTING, "i < [[sources_.size()]]; ++i)\n        if (!grouped", "std::min<std::size_t>(1, sources_.size())"),
        ],
    ),
    "lit_from_behind": (
        "the cosine to the light is not clamped: what looks away from it is lit, or darkened",
        [
            (COURSE, "surface.diffuse * [[std::max(0.0, dot(point.normal, l))]] *", "dot(point.normal, l)"),
            (LIGHTING, "if (!illuminates_by_area && [[!is_seen(view, n_dot_l, light.shadowless)]]) return;", "false"),
            (LIGHTING, "const bool front = [[n_dot_l >= facing_ || view.both_sides]];", "true"),
        ],
    ),
    "local_unscaled": (
        "a surface's own light is not weakened by what it mirrors and lets through",
        [(COURSE, f"light.{part} *= [[shares.local]]", "1.0") for part in ("ambient", "diffuse", "specular")],
    ),
    "no_background": ("rays that leave the scene bring nothing", [(POVRAY, "Rgb light = [[world_.background]];", "Rgb(0.0)")]),
    "gamma_twice": (
        "the picture's values are encoded for a screen once more",
        [
            (ENCODING, "encoding.raw = [[gamma.kind == Gamma::Kind::legacy || job.profile == Profile::csc473]];", "false"),
            (ENCODING, "Curve::Kind::power, [[gamma.power]]};", "job.profile == Profile::csc473 ? 1.0 : gamma.power / 2.2"),
        ],
    ),
    "gamma_missing": (
        "the picture's values are not encoded for a screen",
        [(ENCODING, "encoding.raw = [[gamma.kind == Gamma::Kind::legacy || job.profile == Profile::csc473]];", "true")],
    ),
    "no_antialiasing": (
        "a pixel has one sample",
        [
            (SAMPLING, "switch ([[task.sampling.method]]) {", "Sampling::Method::none"),
            (SAMPLING, "return [[sampling.method == Sampling::Method::grid]] ?", "false"),
        ],
    ),
    "black": (
        "the picture is black",
        [(file, f"[[overflowed({light}.{c})]]", "0.0") for file, light in ((COURSE, "light"), (POVRAY, "result.rgb")) for c in "rgb"],
    ),
}
