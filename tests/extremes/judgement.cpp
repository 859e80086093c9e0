#include "tests/extremes/judgement.h"

#include <filesystem>

#include "tests/extremes/program.h"
#include "tests/extremes/robust.h"
#include "tests/extremes/textbook.h"

namespace rt::extremes {

namespace {

namespace fs = std::filesystem;

/// Stands in for a width of 0 in 113 bits: so narrow that only the very centre of a highlight would tell it from nothing.
constexpr double narrowest = 1e-40;

template <typename T, template <typename> typename Terms, typename S = T>
Bytes rendered(const Description& description, double least_alpha = 0.0) {
    return encode(Renderer<T, Terms, S>(description, least_alpha).picture(picture_width, picture_height));
}

}  // namespace

bool right(const Judgement& judgement) { return wrong(judgement.ours, judgement.truth).pixels + judgement.ours.non_finite == 0; }

std::vector<std::string> scenes() {
    std::vector<std::string> paths;
    for (const auto& entry : fs::directory_iterator(fs::path(PROJECT_ROOT) / "pov/extremes"))
        if (entry.path().extension() == ".pov") paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    return paths;
}

Judgement judge(const std::string& scene) {
    const Description description = describe(scene);
    Judgement judgement;
    judgement.name = fs::path(scene).stem();
    judgement.ours = render(scene, "", picture_width, picture_height, &judgement.png);
    judgement.truth = rendered<Quad, Robust>(description);
    judgement.textbook = rendered<Quad, Textbook>(description, narrowest);
    judgement.naive_single = rendered<double, Textbook, float>(description);
    judgement.naive_double = rendered<double, Textbook>(description);
    return judgement;
}

}  // namespace rt::extremes
