#include "tests/causes/scene_maker.h"

#include <fmt/format.h>

#include <random>

namespace rt::test {

namespace {

class Maker {
public:
    explicit Maker(unsigned seed) : random_(seed) {}

    std::string scene() {
        std::string text =
            fmt::format("camera {{ location <{:.2f}, {:.2f}, {:.2f}> up <0, 1, 0> right <1.3333, 0, 0> look_at <{:.2f}, {:.2f}, 0> }}\n",
                        in(-3, 3), in(1.5, 5), in(9, 13), in(-0.7, 0.7), in(0.2, 1.2));
        const int lamps = 1 + static_cast<int>(random_() % 3);
        for (int i = 0; i < lamps; ++i)
            text += fmt::format("light_source {{ <{:.2f}, {:.2f}, {:.2f}> color rgb {} }}\n", in(-12, 12), in(5, 14), in(2, 14),
                                color(0.5 / lamps + 0.2, 1.4 / lamps));
        if (chance(0.8)) text += fmt::format("plane {{ <0, 1, 0>, {:.2f} {} }}\n", in(-1.6, -0.9), opaque(chance(0.25)));
        const int objects = 3 + static_cast<int>(random_() % 6);
        for (int i = 0; i < objects; ++i) text += object(in(-3.5, 3.5), in(-0.5, 2.2), in(-3, 3));
        return text;
    }

private:
    double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    bool chance(double p) { return in(0, 1) < p; }
    std::string color(double low, double high) {
        return fmt::format("<{:.2f}, {:.2f}, {:.2f}>", in(low, high), in(low, high), in(low, high));
    }

    std::string opaque(bool mirror) {
        std::string finish = fmt::format("ambient {:.2f} diffuse {:.2f}", in(0.08, 0.3), in(0.35, 0.75));
        if (chance(0.6)) finish += fmt::format(" specular {:.2f} roughness {:.2f}", in(0.3, 0.9), in(0.1, 0.45));
        if (mirror) finish += fmt::format(" reflection {:.2f}", in(0.25, 0.8));
        return fmt::format("pigment {{ color rgb {} }} finish {{ {} }}", color(0.15, 1.0), finish);
    }
    std::string transparent() {
        return fmt::format(
            "pigment {{ color rgbf <{:.2f}, {:.2f}, {:.2f}, {:.2f}> }} finish {{ ambient {:.2f} diffuse {:.2f} specular 0.5 roughness 0.2 "
            "ior {:.2f} }}",
            in(0.5, 1), in(0.5, 1), in(0.5, 1), in(0.5, 0.9), in(0.05, 0.2), in(0.2, 0.5), in(1.2, 1.8));
    }
    std::string material() { return chance(0.25) ? transparent() : opaque(chance(0.3)); }
    std::string moves(double x, double y, double z) {
        std::string text;
        if (chance(0.6)) text += fmt::format(" scale <{:.2f}, {:.2f}, {:.2f}>", in(0.5, 1.6), in(0.5, 1.6), in(0.5, 1.6));
        if (chance(0.6)) text += fmt::format(" rotate <{:.0f}, {:.0f}, {:.0f}>", in(-60, 60), in(-90, 90), in(-60, 60));
        return text + fmt::format(" translate <{:.2f}, {:.2f}, {:.2f}>", x, y, z);
    }
    std::string object(double x, double y, double z) {
        const bool moved = chance(0.5);
        const std::string surface = material();
        switch (random_() % 4) {
            case 0:
                if (moved) return fmt::format("sphere {{ <0, 0, 0>, {:.2f} {}{} }}\n", in(0.6, 1.2), surface, moves(x, y, z));
                return fmt::format("sphere {{ <{:.2f}, {:.2f}, {:.2f}>, {:.2f} {} }}\n", x, y, z, in(0.6, 1.2), surface);
            case 1:
                if (moved) return fmt::format("box {{ <-0.8, -0.6, -0.7>, <0.8, 0.6, 0.7> {}{} }}\n", surface, moves(x, y, z));
                return fmt::format("box {{ <{:.2f}, {:.2f}, {:.2f}>, <{:.2f}, {:.2f}, {:.2f}> {} }}\n", x, y, z, x + in(0.8, 1.8),
                                   y + in(0.5, 1.6), z + in(0.8, 1.8), surface);
            case 2:
                return fmt::format("cone {{ <0, -0.7, 0>, {:.2f}, <0, 0.9, 0>, {:.2f} {}{} }}\n", in(0.5, 1), in(0.05, 0.4), surface,
                                   moves(x, y, z));
            default:
                return fmt::format("triangle {{ <{:.2f}, {:.2f}, {:.2f}>, <{:.2f}, {:.2f}, {:.2f}>, <{:.2f}, {:.2f}, {:.2f}> {} }}\n",
                                   x - 1.3, y - 0.9, z + in(-1, 1), x + 1.4, y - 0.6, z + in(-1, 1), x + in(-0.6, 0.6), y + 1.7, z,
                                   opaque(chance(0.3)));
        }
    }

    std::mt19937 random_;
};

}  // namespace

std::string random_scene(unsigned seed) { return Maker(seed).scene(); }

}  // namespace rt::test
