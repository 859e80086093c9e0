#include "syntax/parse_pattern.h"

#include <fmt/format.h>

#include <algorithm>

#include "syntax/parameters.h"
#include "syntax/texture_layers.h"

namespace rt {

namespace {

template <typename Numbers>
Numbers* numbers_of(StatedPattern& stated) {
    return std::get_if<Numbers>(&stated.pattern.numbers);
}

/// `numbers`, or the error that the keyword says where the pattern is another one.
template <typename Numbers>
Numbers& require(Reader& reader, const Token& word, StatedPattern& stated, std::string_view refusal) {
    if (Numbers* numbers = numbers_of<Numbers>(stated)) return *numbers;
    reader.fail(word.span, fmt::format("Keyword '{}' {}.", text(word.word), refusal));
}

/// Each costs at every point of the set, so there is an end.
int parse_iterations(Reader& reader) {
    constexpr int most_iterations = 1'000'000;
    const int iterations = parse_int(reader);
    if (iterations > most_iterations)
        reader.fail(reader.last_place(), fmt::format("A fractal pattern has at most {} iterations.", most_iterations));
    return std::max(iterations, 1);
}

/// `mandel n`, `julia c, n`, `magnet 1 mandel n` and so on, after the kind's word.
void parse_fractal(Reader& reader, PatternKind kind, FractalNumbers& numbers) {
    if (kind == PatternKind::magnet) {
        const Span place = reader.peek().span;
        const int formula = parse_int(reader);
        numbers.julia = reader.accept(Word::julia);
        if (!numbers.julia && !reader.accept(Word::mandel)) reader.fail_expected("julia or mandel");
        if (formula != 1 && formula != 2)
            reader.fail(place,
                        fmt::format("Invalid magnet-{} pattern type found. Valid types are 1 and 2.", numbers.julia ? "julia" : "mandel"));
        numbers.magnet = formula;
    } else {
        numbers.julia = kind == PatternKind::julia;
    }
    if (numbers.julia) {
        numbers.c = reader.parse_vector2();
        reader.accept_comma();
    }
    numbers.iterations = parse_iterations(reader);
}

void parse_slope_part(Reader& reader, Vec3& direction, Vec2& range) {
    direction = reader.parse_vector();
    reader.accept_comma();
    if (!reader.at_expression()) return;
    range.x = reader.parse_float();
    reader.accept_comma();
    range.y = reader.parse_float();
    reader.accept_comma();
}

void parse_slope(Reader& reader, SlopeNumbers& numbers) {
    if (!reader.peek().is('{')) {
        numbers.slope = reader.parse_vector();
        return;
    }
    reader.begin_block("slope");
    parse_slope_part(reader, numbers.slope, numbers.slope_range);
    if (reader.accept(Word::altitude)) parse_slope_part(reader, numbers.altitude, numbers.altitude_range);
    reader.end_block();
}

/// What stands right behind the kind's word.
void parse_numbers(Reader& reader, StatedPattern& stated) {
    const PatternKind kind = stated.pattern.kind;
    if (auto* gradient = numbers_of<GradientNumbers>(stated)) {
        gradient->direction = reader.parse_vector();
        if (gradient->direction == Vec3(0.0)) gradient->direction = Vec3(1.0, 0.0, 0.0);
    } else if (auto* spiral = numbers_of<SpiralNumbers>(stated)) {
        spiral->arms = parse_int(reader);
    } else if (auto* fractal = numbers_of<FractalNumbers>(stated)) {
        parse_fractal(reader, kind, *fractal);
    } else if (auto* slope = numbers_of<SlopeNumbers>(stated)) {
        parse_slope(reader, *slope);
    } else if (auto* density = numbers_of<DensityNumbers>(stated)) {
        density->grid = parse_density_file(reader);
    } else if (kind == PatternKind::image_pattern) {
        stated.pattern.numbers = parse_value_image(reader, nullptr);
    } else if (kind == PatternKind::pigment_pattern) {
        stated.source = Shared<Pigment>(parse_pigment(reader, default_pigment(reader)));
    } else if (kind == PatternKind::function) {
        stated.source = reader.parse_pattern_function();
    } else if (kind == PatternKind::object) {
        stated.source = Shared<Bodies>(parse_bodies_of_pattern(reader));
    }
}

void parse_exponent(Reader& reader, FractalNumbers& numbers, PatternKind kind) {
    const int exponent = parse_int(reader);
    numbers.exponent = exponent;
    if (exponent >= 2 && exponent <= 33) return;
    reader.warn(reader.peek().span,
                fmt::format("Invalid {} pattern exponent found. Supported exponents are 2 to 33. Using default exponent 2.", name(kind)));
    numbers.exponent = 2;
}

void parse_coloring(Reader& reader, int& way, double& factor) {
    way = std::clamp(parse_int(reader), 0, 6);
    reader.accept_comma();
    factor = reader.parse_float();
}

/// Keywords that only some kinds have.
bool accept_own_number(Reader& reader, StatedPattern& stated) {
    const Token next = reader.peek();
    if (reader.accept(Word::agate_turb)) {
        require<AgateNumbers>(reader, next, stated, "cannot be used with non-agate").turbulence = static_cast<float>(reader.parse_float());
    } else if (reader.accept(Word::brick_size)) {
        require<BrickNumbers>(reader, next, stated, "cannot be used with non-brick").size = reader.parse_vector();
    } else if (reader.accept(Word::mortar)) {
        require<BrickNumbers>(reader, next, stated, "cannot be used with non-brick").mortar = reader.parse_float();
    } else if (reader.accept(Word::control0)) {
        require<QuiltedNumbers>(reader, next, stated, "cannot be used with this pattern").control0 =
            static_cast<float>(reader.parse_float());
    } else if (reader.accept(Word::control1)) {
        require<QuiltedNumbers>(reader, next, stated, "cannot be used with this pattern").control1 =
            static_cast<float>(reader.parse_float());
    } else if (reader.accept(Word::form)) {
        require<CrackleNumbers>(reader, next, stated, "can only be used in a crackle or pavement statement").form = reader.parse_vector();
    } else if (reader.accept(Word::offset)) {
        require<CrackleNumbers>(reader, next, stated, "can only be used in a crackle statement").offset = reader.parse_float();
    } else if (reader.accept(Word::solid)) {
        require<CrackleNumbers>(reader, next, stated, "can only be used in a crackle statement").solid = reader.parse_bool_or(true);
    } else if (reader.accept(Word::metric)) {
        auto* facets = numbers_of<FacetsNumbers>(stated);
        double& metric = facets ? facets->metric
                                : require<CrackleNumbers>(reader, next, stated, "can only be used in a facets or crackle statement").metric;
        metric = reader.parse_float();
    } else if (reader.accept(Word::coords)) {
        require<FacetsNumbers>(reader, next, stated, "can only be used in a facets statement").coords =
            static_cast<float>(reader.parse_float());
    } else if (reader.accept(Word::size)) {
        require<FacetsNumbers>(reader, next, stated, "can only be used in a facets statement").size =
            static_cast<float>(reader.parse_float());
    } else if (reader.accept(Word::interpolate)) {
        require<DensityNumbers>(reader, next, stated, "cannot be used with non-density_file").interpolate =
            std::clamp(parse_int(reader), 0, 2);
    } else {
        return false;
    }
    return true;
}

bool accept_fractal_number(Reader& reader, StatedPattern& stated) {
    const Token next = reader.peek();
    constexpr std::string_view refusal = "can only be used in a mandel, julia, magnet or pavement statement";
    if (reader.accept(Word::exponent)) {
        parse_exponent(reader, require<FractalNumbers>(reader, next, stated, "can only be used in a mandel or julia statement"),
                       stated.pattern.kind);
    } else if (reader.accept(Word::exterior)) {
        auto& numbers = require<FractalNumbers>(reader, next, stated, refusal);
        parse_coloring(reader, numbers.exterior, numbers.exterior_factor);
    } else if (reader.accept(Word::interior)) {
        auto& numbers = require<FractalNumbers>(reader, next, stated, refusal);
        parse_coloring(reader, numbers.interior, numbers.interior_factor);
    } else {
        return false;
    }
    return true;
}

bool accept_wave(Reader& reader, Pattern& pattern) {
    const Token next = reader.peek();
    if (reader.accept(Word::frequency)) {
        pattern.frequency = static_cast<float>(reader.parse_float());
    } else if (reader.accept(Word::phase)) {
        pattern.phase = static_cast<float>(reader.parse_float());
    } else if (const std::optional<WaveType> wave = wave_type(text(next.word))) {
        reader.take();
        pattern.wave = *wave;
        if (*wave == WaveType::poly && reader.at_expression()) pattern.wave_exponent = static_cast<float>(reader.parse_float());
    } else {
        return false;
    }
    return true;
}

void parse_noise_generator(Reader& reader, StatedPattern& stated) {
    const Span place = reader.peek().span;
    const int generator = parse_int(reader);
    if (generator < 0 || generator > 3) reader.fail(place, "Value for noise_generator must be 0, 1, 2, or 3.");
    stated.own_noise = generator != 0;
    if (stated.own_noise) stated.pattern.noise = static_cast<NoiseGenerator>(generator);
}

}  // namespace

void become(StatedPattern& stated, PatternKind kind) {
    const Pattern made = make_pattern(kind);
    stated.pattern.kind = kind;
    stated.pattern.numbers = made.numbers;
    if (has_cells(kind)) stated.pattern.frequency = made.frequency;
    if (made.wave != WaveType::ramp) stated.pattern.wave = made.wave;
    stated.source = {};
}

bool takes_map(PatternKind kind) { return list_size(kind) == 0; }

void end_list(Reader& reader, PatternKind kind) {
    if (kind == PatternKind::object) reader.end_block();
}

bool accept_pattern(Reader& reader, StatedPattern& stated, PatternUse use) {
    const Token next = reader.peek();
    if (next.kind != Token::Kind::word) return false;
    const std::optional<PatternKind> kind = pattern_kind(text(next.word));
    if (!kind) return false;
    if ((*kind == PatternKind::facets || *kind == PatternKind::bump_map) && use != PatternUse::normal)
        reader.fail(next.span, fmt::format("Keyword '{}' can only be used in a normal statement.", text(next.word)));
    if (*kind == PatternKind::bump_map) return false;
    reader.take();
    become(stated, *kind);
    parse_numbers(reader, stated);
    return true;
}

bool accept_turbulence_item(Reader& reader, std::optional<Turbulence>& turbulence) {
    const auto edit = [&]() -> Turbulence& { return turbulence ? *turbulence : turbulence.emplace(); };
    if (reader.accept(Word::turbulence)) {
        edit().amount = reader.parse_vector();
    } else if (reader.accept(Word::octaves)) {
        edit().octaves = std::clamp(parse_int(reader), 1, 10);
    } else if (reader.accept(Word::omega)) {
        edit().omega = static_cast<float>(reader.parse_float());
    } else if (reader.accept(Word::lambda)) {
        edit().lambda = static_cast<float>(reader.parse_float());
    } else {
        return false;
    }
    return true;
}

bool accept_pattern_modifier(Reader& reader, StatedPattern& stated, PatternUse use) {
    const Token next = reader.peek();
    if (next.kind != Token::Kind::word) return false;
    Pattern& pattern = stated.pattern;
    if (const std::optional<Transform> t = accept_transform(reader)) {
        append(pattern, *t);
        require_finite(reader, next.span, std::get<Transform>(pattern.warps.back()));
    } else if (reader.accept(Word::warp)) {
        pattern.warps.push_back(parse_warp(reader));
        reader.count_scene_nodes(next.span, 1);
    } else if (reader.accept(Word::noise_generator)) {
        parse_noise_generator(reader, stated);
    } else if (!accept_turbulence_item(reader, pattern.turbulence) && !accept_wave(reader, pattern) && !accept_own_number(reader, stated) &&
               !accept_fractal_number(reader, stated)) {
        if (next.is(Word::accuracy) && use != PatternUse::normal) reader.fail(next.span, "accuracy can only be used with normal patterns.");
        return false;
    }
    return true;
}

}  // namespace rt
