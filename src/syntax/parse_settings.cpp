// global_settings { }
#include <fmt/format.h>

#include <algorithm>

#include "syntax/blocks.h"
#include "syntax/parameters.h"
#include "syntax/unmodelled.h"

namespace rt {

namespace {

/// The first stated value wins. Within 1 % of 1 it is 1.
void parse_assumed_gamma(Reader& reader, const Span& word, Gamma& gamma) {
    const Span place = reader.peek().span;
    Gamma stated{Gamma::Kind::srgb, 1.0};
    if (!reader.accept(Word::srgb)) {
        stated = {Gamma::Kind::power, reader.parse_float()};
        if (stated.power <= 0.0) reader.fail(place, "gamma value must be positive.");
    }
    if (gamma.kind != Gamma::Kind::legacy) {
        reader.warn(word, "New instance of assumed_gamma ignored");
        return;
    }
    if (stated.power < 1.0)
        reader.warn_possible(reader.peek().span, fmt::format("Suspicious value {:g} specified for gamma. Did you mean {:g}?", stated.power,
                                                             1.0 / stated.power));
    if (std::fabs(stated.power - 1.0) <= 0.01) stated.power = 1.0;
    gamma = stated;
}

void parse_max_trace_level(Reader& reader, GlobalSettings& settings) {
    constexpr int highest_trace_level = GlobalSettings::highest_trace_level;
    const int level = parse_int(reader);
    if (level > highest_trace_level)
        reader.warn(reader.peek().span,
                    fmt::format("Maximum max_trace_level is {0} but {1} was specified. Going to use max_trace_level {0}.",
                                highest_trace_level, level));
    settings.max_trace_level = std::clamp(level, 1, highest_trace_level);
}

/// Each wave costs at every point, so there is an end.
int parse_number_of_waves(Reader& reader) {
    constexpr int most_waves = 10'000;
    const int waves = parse_int(reader);
    if (waves < 1) reader.warn(reader.peek().span, "Illegal Value: number_of_waves must be greater than 0. Changed to 1.");
    if (waves > most_waves) reader.fail(reader.last_place(), fmt::format("number_of_waves is at most {}.", most_waves));
    return std::max(waves, 1);
}

bool accept_modelled(Reader& reader, GlobalSettings& settings) {
    const Token next = reader.peek();
    if (reader.accept(Word::assumed_gamma)) {
        parse_assumed_gamma(reader, next.span, settings.gamma);
    } else if (reader.accept(Word::ambient_light)) {
        settings.ambient_light = parse_rgb(reader);
    } else if (reader.accept(Word::max_trace_level)) {
        parse_max_trace_level(reader, settings);
    } else if (reader.accept(Word::adc_bailout)) {
        settings.adc_bailout = reader.parse_float();
    } else if (reader.accept(Word::irid_wavelength)) {
        settings.irid_wavelength = parse_rgb(reader);
    } else if (reader.accept(Word::number_of_waves)) {
        settings.number_of_waves = parse_number_of_waves(reader);
    } else if (reader.accept(Word::noise_generator)) {
        const int generator = parse_int(reader);
        if (generator < 1 || generator > 3)
            reader.fail(reader.peek().span, "Value for noise_generator in global_settings must be 1, 2, or 3.");
        settings.noise_generator = static_cast<NoiseGenerator>(generator);
    } else {
        return false;
    }
    return true;
}

void parse_charset(Reader& reader) {
    if (!reader.accept(Word::ascii) && !reader.accept(Word::utf8) && !reader.accept(Word::sys)) reader.fail_expected("charset type");
}

/// Settings that change nothing of what is modelled: read, with POV-Ray's remarks.
bool accept_without_effect(Reader& reader) {
    const Token next = reader.peek();
    if (reader.accept(Word::charset)) {
        parse_charset(reader);
    } else if (reader.accept(Word::mm_per_unit)) {
        reader.parse_float();
    } else if (reader.accept(Word::max_intersections)) {
        reader.parse_float();
        reader.warn(reader.peek().span, "'max_intersections' is no longer needed and has no effect in POV-Ray 3.7 or later.");
    } else if (reader.accept(Word::hf_gray_16)) {
        reader.parse_bool_or(true);
        reader.warn_possible(
            next.span,
            "In POV-Ray 3.7 and later 'hf_gray_16' has to be specified as an option on the command-line (e.g. '+FNg'), in an "
            "INI file (e.g. 'Grayscale_Output=true'), or (on some platforms) in a dialog. The 'hf_gray_16' setting here is "
            "ignored. See the documentation for more details.");
    } else {
        return false;
    }
    return true;
}

bool accept_unmodelled(Reader& reader) {
    const Token next = reader.peek();
    if (!next.is(Word::radiosity) && !next.is(Word::photons) && !next.is(Word::subsurface)) return false;
    reader.take();
    skip_unmodelled_block(reader, next);
    return true;
}

}  // namespace

void parse_global_settings(Reader& reader) {
    reader.begin_block("global_settings");
    GlobalSettings& settings = reader.scene().settings;
    while (accept_modelled(reader, settings) || accept_without_effect(reader) || accept_unmodelled(reader)) continue;
    reader.end_block();
}

}  // namespace rt
