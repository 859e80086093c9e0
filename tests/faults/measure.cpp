#include "tests/faults/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "grading/explain.h"

namespace rt::test {

std::span<const Cause> right_names(Fault fault) {
    using enum Fault;
    static const std::map<Fault, std::vector<Cause>> names{
        {mirrored, {Cause::mirrored}},
        {upside_down, {Cause::upside_down}},
        {half_pixel, {Cause::half_pixel}},
        {normal_side, {Cause::wrong_normal_side}},
        {triangle_side, {Cause::wrong_normal_side}},
        {normal_by_matrix, {Cause::wrong_normal}},
        {normal_in_object_space, {Cause::wrong_normal}},
        {normal_unnormalised, {Cause::missing_normalisation}},
        {half_unnormalised, {Cause::missing_normalisation, Cause::wrong_exponent}},
        {light_unnormalised, {Cause::missing_normalisation, Cause::wrong_diffuse}},
        {object_space_distance, {Cause::object_space_distance}},
        {offset_missing, {Cause::offset}},
        {offset_reversed, {Cause::offset}},
        {no_shadows, {Cause::missing_shadow}},
        {opaque_shadows, {Cause::false_shadow, Cause::missing_filter}},
        {glass_without_shadow, {Cause::missing_shadow, Cause::missing_filter}},
        {shadow_from_behind, {Cause::false_shadow}},
        {unfiltered, {Cause::missing_filter}},
        {mirror_untinted, {Cause::wrong_pigment, Cause::missing_filter}},
        {depth_short, {Cause::depth}},
        {depth_long, {Cause::depth}},
        {ior_inverted, {Cause::wrong_refraction_ratio, Cause::total_reflection}},  // where one of both reflects totally
        {unbent, {Cause::wrong_refraction_ratio, Cause::total_reflection}},
        {no_fresnel, {Cause::missing_fresnel}},
        {fresnel_sides, {Cause::missing_fresnel}},
        {no_absorption, {Cause::missing_filter}},
        {no_total_reflection, {Cause::total_reflection}},
        {no_transmission, {Cause::missing_filter}},
        {no_reflection, {Cause::missing_reflection}},
        {wrong_mirror, {Cause::wrong_mirror_direction}},
        {no_ambient, {Cause::missing_ambient}},
        {no_diffuse, {Cause::wrong_diffuse}},
        {no_specular, {Cause::missing_highlight}},
        {wrong_exponent, {Cause::wrong_exponent}},
        {phong_for_blinn, {Cause::wrong_exponent}},
        {white_lights, {Cause::wrong_diffuse}},
        {one_light, {Cause::missing_light}},
        {lit_from_behind, {Cause::wrong_diffuse}},
        {local_unscaled, {Cause::wrong_share}},
        {no_background, {Cause::background}},
        {gamma_twice, {Cause::gamma}},
        {gamma_missing, {Cause::gamma}},
        {no_antialiasing, {Cause::sampling}},
    };
    const auto found = names.find(fault);
    return found == names.end() ? std::span<const Cause>() : found->second;
}

namespace {

/// The largest difference of a channel, of every pixel.
std::vector<int> differences(const std::vector<std::uint16_t>& a, const std::vector<std::uint16_t>& b) {
    std::vector<int> all(a.size() / 3);
    for (std::size_t i = 0; i < a.size(); ++i) all[i / 3] = std::max(all[i / 3], std::abs(int{a[i]} - int{b[i]}));
    return all;
}

std::vector<std::size_t> chosen(const std::vector<int>& difference, int more, unsigned seed) {
    const auto most = static_cast<std::size_t>(std::max_element(difference.begin(), difference.end()) - difference.begin());
    if (difference[most] == 0) return {};
    std::vector<std::size_t> pixels{most}, others;
    for (std::size_t i = 0; i < difference.size(); ++i)
        if (difference[i] > 0 && i != most) others.push_back(i);
    std::mt19937 engine(seed);
    for (int i = 0; i < more && !others.empty(); ++i) {
        const std::size_t k = engine() % others.size();
        pixels.push_back(others[k]);
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    }
    return pixels;
}

void count(const std::array<ToldPixel, 3>& right, const std::array<ToldPixel, 3>& wrong, Fault fault, Tally& tally) {
    const std::span<const Cause> names = right_names(fault);
    for (std::size_t f = 0; f < forms.size(); ++f) {
        const auto [a, b] = records_of(forms[f]);
        const std::optional<Divergence> found = first_divergence(right[a], wrong[b], 1e-4);
        if (!found) continue;  // the fault does not change these records
        Count& by_form = tally.by_form[f];
        ++by_form.cases;
        ++by_form.named[found->cause];
        by_form.right += std::find(names.begin(), names.end(), found->cause) != names.end() ? 1 : 0;
    }
}

}  // namespace

void measure(const Subject& subject, const std::vector<std::uint16_t>& healthy, Fault fault, int more, unsigned seed, Tally& tally) {
    select_faults({&fault, 1});
    const std::vector<std::size_t> pixels = chosen(differences(healthy, subject.picture()), more, seed);
    tally.pictures += pixels.empty() ? 0 : 1;
    for (const std::size_t pixel : pixels) {
        const int x = static_cast<int>(pixel) % subject.width(), y = static_cast<int>(pixel) / subject.width();
        select_faults({});
        const std::array<ToldPixel, 3> right = subject.told(x, y);
        select_faults({&fault, 1});
        count(right, subject.told(x, y), fault, tally);
    }
    select_faults({});
}

std::string table(std::span<const Tally> tallies) {
    std::string text = fmt::format("{:24}{:>8}{:>7}{:>8}{:>12}{:>8}{:>8}  causes named (json; json and printrays)\n", "fault", "pictures",
                                   "cases", "json", "json+rays", "+tree", "text");
    for (std::size_t i = 0; i < tallies.size(); ++i) {
        const auto& by_form = tallies[i].by_form;
        text += fmt::format("{:24}{:8}{:7}{:8.2f}{:12.2f}{:8.2f}{:8.2f} ", all_faults()[i].name, tallies[i].pictures, by_form[0].cases,
                            by_form[0].rate(), by_form[1].rate(), by_form[2].rate(), by_form[3].rate());
        for (const std::size_t f : {0, 1}) {
            for (const auto& [cause, times] : by_form[f].named) text += fmt::format(" {} {},", times, name_of(cause));
            text.back() = ';';
        }
        text.back() = '\n';
    }
    return text;
}

}  // namespace rt::test
