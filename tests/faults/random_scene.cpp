#include "tests/faults/random_scene.h"

#include <fmt/format.h>

#include <random>

#include "core/vec.h"

namespace rt::test {

namespace {

class Draw {
public:
    Draw(bool course, unsigned seed) : course_(course), engine_(seed) {}

    std::string scene() {
        const double angle = real(0.0, 6.28);
        const Vec3 eye(real(5.5, 7.5) * std::sin(angle), real(1.5, 4.0), real(5.5, 7.5) * std::cos(angle));
        std::string text = course_ ? course_camera(eye) : povray_camera(eye);
        const int lamps = 1 + whole(3);
        for (int i = 0; i < lamps; ++i) text += lamp();
        text += fmt::format("plane {{ <0, 1, 0>, {:.3f} {} }}\n", real(-1.6, -1.2), surface(chance(0.4) ? Kind::mirror : Kind::glossy));
        text += glass_in_glass();
        const int solids = 3 + whole(3);
        for (int i = 0; i < solids; ++i) {
            const double around = 6.28 * i / solids + real(-0.3, 0.3), out = real(1.3, 2.3);
            text += solid(Vec3(out * std::sin(around), real(-0.8, 0.6), out * std::cos(around)));
        }
        return text;
    }

private:
    enum class Kind { glossy, mirror, glass };

    double real(double low, double high) { return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0); }
    int whole(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }
    bool chance(double p) { return real(0.0, 1.0) < p; }
    std::string number(double low, double high) { return fmt::format("{:.3f}", real(low, high)); }
    std::string triple(double low, double high) {
        const std::string x = number(low, high), y = number(low, high), z = number(low, high);
        return fmt::format("<{}, {}, {}>", x, y, z);
    }

    std::string course_camera(const Vec3& eye) {
        const Vec3 right = 4.0 / 3.0 * unit(cross(-eye, Vec3(0, 1, 0))), up = unit(cross(right, -eye));
        return fmt::format(
            "camera {{ location <{:.3f}, {:.3f}, {:.3f}> up <{:.4f}, {:.4f}, {:.4f}> right <{:.4f}, {:.4f}, {:.4f}> look_at 0 }}\n", eye.x,
            eye.y, eye.z, up.x, up.y, up.z, right.x, right.y, right.z);
    }

    std::string povray_camera(const Vec3& eye) {
        return fmt::format(
            "#version 3.7;\nglobal_settings {{ assumed_gamma 1 max_trace_level {} }}\nbackground {{ rgb {} }}\n"
            "camera {{ location <{:.3f}, {:.3f}, {:.3f}> look_at 0 angle 45 }}\n",
            3 + whole(4), triple(0.1, 0.6), eye.x, eye.y, eye.z);
    }

    std::string lamp() {
        const double angle = real(0.0, 6.28);
        return fmt::format("light_source {{ <{:.3f}, {}, {:.3f}> color rgb {} }}\n", 6.0 * std::sin(angle), number(3.0, 8.0),
                           6.0 * std::cos(angle), triple(0.1, 0.8));
    }

    /// Pigment, finish and, in POV-Ray's words, the interior.
    std::string surface(Kind kind) {
        const std::string ior = number(1.2, 1.9);
        const std::string pigment = kind == Kind::glass ? fmt::format("rgbf <{}, {}, {}, {}>", number(0.5, 1.0), number(0.5, 1.0),
                                                                      number(0.5, 1.0), number(0.5, 0.9))
                                                        : fmt::format("rgb {}", triple(0.2, 0.95));
        std::string finish = fmt::format("ambient {} diffuse {} specular {} roughness {}", number(0.05, 0.3), number(0.3, 0.8),
                                         number(0.2, 0.8), course_ ? number(0.1, 0.4) : number(0.02, 0.15));
        if (kind == Kind::mirror) finish += fmt::format(" reflection {}", number(0.15, 0.6));
        if (course_ && kind == Kind::glass) finish += fmt::format(" ior {}", ior);
        std::string text = fmt::format("pigment {{ color {} }} finish {{ {} ", pigment, finish);
        if (course_ || kind != Kind::glass) return text + "}";
        const std::string fade = chance(0.5) ? fmt::format(" fade_distance 2 fade_power 1001 fade_color rgb {}", triple(0.2, 0.9)) : "";
        return text + fmt::format("reflection {{ 0, 1 fresnel }} conserve_energy }} interior {{ ior {}{} }}", ior, fade);
    }

    std::string glass_in_glass() {
        const std::string outer = surface(Kind::glass), inner = surface(Kind::glass);
        return fmt::format("sphere {{ <0, -0.2, 0>, {} {} }}\nsphere {{ <0.1, -0.1, 0.1>, {} {} }}\n", number(0.8, 1.0), outer,
                           number(0.4, 0.6), inner);
    }

    std::string shape() {
        switch (whole(course_ ? 5 : 6)) {
            case 0:
                return "sphere { 0, 0.7";
            case 1:
                return "box { <-0.5, -0.6, -0.5>, <0.6, 0.5, 0.4>";
            case 2:
                return "cone { <0, -0.6, 0>, 0.6, <0, 0.8, 0>, 0.1";
            case 3:
                return "cylinder { <0, -0.6, 0>, <0.1, 0.7, 0>, 0.45";
            case 4:
                return "triangle { <-1, -0.7, 0.2>, <1, -0.6, -0.3>, <0.1, 1.1, 0.1>";
            default:
                return "torus { 0.6, 0.22";
        }
    }

    std::string solid(const Vec3& at) {
        const std::string form = shape();
        const bool flat = form.starts_with("triangle");
        const int kind = whole(3);
        const std::string look = surface(kind == 0 && !flat ? Kind::glass : kind == 1 ? Kind::mirror : Kind::glossy);
        return fmt::format("{} {} scale {} rotate {} translate <{:.3f}, {:.3f}, {:.3f}> }}\n", form, look, triple(0.6, 1.3),
                           triple(-60.0, 60.0), at.x, at.y, at.z);
    }

    bool course_;
    std::mt19937 engine_;
};

}  // namespace

std::string random_scene_text(bool course, unsigned seed) { return Draw(course, seed).scene(); }

}  // namespace rt::test
