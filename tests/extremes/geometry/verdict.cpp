#include "tests/extremes/geometry/verdict.h"

#include <algorithm>
#include <filesystem>

#include "tests/extremes/geometry/exact_shapes.h"
#include "tests/extremes/geometry/reference.h"
#include "tests/extremes/geometry/textbook_shapes.h"
#include "tests/extremes/program.h"

namespace rt::extremes {

namespace {

namespace fs = std::filesystem;

/// 64 units in the last place of a double: about what the coordinates of a hit point have lost in any tracing in doubles.
constexpr double shift = 0x1p-46;
/// Surfaces that are nearer than a double can tell.
constexpr double touching = 0x1p-52;

template <typename T>
Bytes textbook(const std::string& scene) {
    const Solids solids = read_solids(scene);
    return encode(Reference<T, TextbookShapes>(solids).picture(geometry_width, geometry_height));
}

bool is_wrong(const Bytes& picture, const Truth& truth, std::size_t pixel) {
    return truth.stable[pixel] && steps_apart(picture, truth.picture, pixel) > 1;
}

bool is_speckle(const Bytes& picture, const Truth& truth, int x, int y) {
    int around = 0, right = 0;
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, truth.picture.height - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, truth.picture.width - 1); ++i) {
            if (i == x && j == y) continue;
            ++around;
            right += !is_wrong(picture, truth, static_cast<std::size_t>(j) * truth.picture.width + i);
        }
    return 2 * right > around;
}

}  // namespace

std::vector<std::string> geometry_scenes() {
    std::vector<std::string> paths;
    for (const auto& entry : fs::directory_iterator(fs::path(PROJECT_ROOT) / "pov/extremes/geometry"))
        if (entry.path().extension() == ".pov") paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    return paths;
}

Truth truth_of(const std::string& scene) {
    const Solids solids = read_solids(scene);
    const Reference<Quad, ExactShapes> reference(solids);
    Truth truth{fs::path(scene).stem(), encode(reference.picture(geometry_width, geometry_height)), {}, 0, {}, solids.objects};
    truth.objects = reference.objects(geometry_width, geometry_height);
    truth.stable.assign(truth.objects.size(), true);
    for (const double sign : {-1.0, 1.0}) {
        const Reference<long double, ExactShapes> other(solids, sign * touching);
        const Bytes moved = encode(other.picture(geometry_width, geometry_height, sign * shift, shift));
        for (std::size_t i = 0; i < truth.stable.size(); ++i)
            if (steps_apart(moved, truth.picture, i) > 1) truth.stable[i] = false;
    }
    truth.unstable = static_cast<int>(std::count(truth.stable.begin(), truth.stable.end(), false));
    return truth;
}

Count count(const Bytes& picture, const Truth& truth) {
    Count result;
    result.non_finite = picture.non_finite;
    std::vector<int> seen(truth.object_count + 1), missing(truth.object_count + 1);
    for (std::size_t i = 0; i < truth.stable.size(); ++i) {
        if (!truth.stable[i]) {
            result.unstable += steps_apart(picture, truth.picture, i) > 1;
            continue;
        }
        ++seen[truth.objects[i]];
        if (!is_wrong(picture, truth, i)) continue;
        ++missing[truth.objects[i]];
        ++result.wrong;
        result.steps = std::max(result.steps, steps_apart(picture, truth.picture, i));
        result.speckles += is_speckle(picture, truth, static_cast<int>(i) % truth.picture.width, static_cast<int>(i) / truth.picture.width);
    }
    for (std::size_t i = 0; i < truth.object_count; ++i) result.lost += 2 * missing[i] > seen[i];
    return result;
}

int known_wrong(const std::string& name, std::size_t setting) {
    struct Known {
        std::string_view name;
        std::size_t setting;
        int wrong;
    };
    // Rays start as far from a surface as the worst shape's equation asks, 2^-33 of its size: that is more than 1e-12. And single
    // precision places corners to 1e-7 of the scene, which reaches as far as the longest needle.
    constexpr std::array<Known, 6> all{{{"sheets_1e-12", exact_scaled, 290},
                                        {"sheets_1e-12", fast_scaled, 290},
                                        {"shells_1e-12", exact_scaled, 1155},
                                        {"shells_1e-12", fast_scaled, 1155},
                                        {"needles_1e6", fast_scaled, 4},
                                        {"needles_1e9", fast_scaled, 1099}}};
    for (const Known& known : all)
        if (known.name == name && known.setting == setting) return known.wrong;
    return 0;
}

bool right(const Verdict& verdict) {
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const Count c = count(verdict.ours[i], verdict.truth);
        const bool judged = i == exact_scaled || i == fast_scaled;
        if (c.non_finite > 0 || (judged && c.wrong > known_wrong(verdict.truth.name, i))) return false;
    }
    return true;
}

Verdict verdict_of_ours(const std::string& scene) {
    Verdict result;
    result.truth = truth_of(scene);
    for (std::size_t i = 0; i < settings.size(); ++i) result.ours[i] = render(scene, settings[i].options, geometry_width, geometry_height);
    return result;
}

Bytes textbook_double(const std::string& scene) { return textbook<double>(scene); }

Verdict verdict(const std::string& scene) {
    Verdict result = verdict_of_ours(scene);
    result.textbook_single = textbook<float>(scene);
    result.textbook_double = textbook_double(scene);
    if (has_povray()) {
        result.povray = render_with_povray(scene, geometry_width, geometry_height);
        result.povray_refuses = !result.povray;
    }
    return result;
}

}  // namespace rt::extremes
