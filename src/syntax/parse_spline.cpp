// spline { }, and calls of what a scene declares as functions.
#include <fmt/format.h>

#include "core/function.h"
#include "core/spline.h"
#include "syntax/expression.h"

namespace rt {

namespace {

std::optional<Spline::Kind> spline_kind(Word w) {
    switch (w) {
        case Word::linear_spline:
            return Spline::Kind::linear;
        case Word::quadratic_spline:
            return Spline::Kind::quadratic;
        case Word::cubic_spline:
            return Spline::Kind::cubic;
        case Word::natural_spline:
            return Spline::Kind::natural;
        default:
            return std::nullopt;
    }
}

std::optional<Spline::Kind> accept_kind(Reader& reader) {
    const std::optional<Spline::Kind> kind = spline_kind(reader.peek().word);
    if (kind) reader.take();
    return kind;
}

}  // namespace

/// What follows the word `spline`.
std::shared_ptr<const Spline> Reader::State::parse_spline() {
    reader.begin_block("spline");
    Spline spline;
    if (const auto* const declared = reader.accept_declared<FunctionValue>()) {
        const auto* const base = std::get_if<std::shared_ptr<const Spline>>(declared);
        if (!base) reader.fail(last, "Expected 'spline identifier', function identifier found instead");
        spline = **base;
        reader.accept_comma();
    }
    if (const auto kind = accept_kind(reader)) spline.kind = *kind;
    reader.accept_comma();
    while (reader.at_expression()) {
        Spline::Point point;
        const Span place = reader.peek().span;
        point.t = reader.parse_float();
        reader.accept_comma();
        Number value = Expression(*this).sum();
        if (value.size == 1) value.v[1] = value.v[0];
        point.value = value.v;
        spline.size = std::max(spline.size, value.size == 1 ? 2 : value.size);
        spline.points.push_back(point);
        count_replay(place, 0);
        reader.accept_comma();
    }
    if (spline.points.empty()) reader.fail(reader.peek().span, "Spline must have at least one entry.");
    reader.end_block();
    spline.arrange();
    any_spline = true;
    return std::make_shared<const Spline>(std::move(spline));
}

/// A call of a declared function or spline, whose name comes next.
Number Expression::call() {
    const Span place = reader_.peek().span;
    const FunctionValue* const declared = reader_.accept_declared<FunctionValue>();
    if (!declared) return unmodelled_call();
    const NestingGuard guard(state_, place);
    const FunctionValue value = *declared;
    reader_.expect('(');
    Number result;
    if (const auto* const spline = std::get_if<std::shared_ptr<const Spline>>(&value)) {
        result = spline_value(**spline, place);
    } else if (const auto* const transform = std::get_if<Transform>(&value)) {
        const double x = sum_float(), y = next_float(), z = next_float();
        const Vec3 moved = transform->point({x, y, z});
        result = {{moved.x, moved.y, moved.z}, 3, false};
    } else if (const auto* const pigment = std::get_if<PigmentFunction>(&value)) {
        result = pigment_color(*pigment, place);
    } else {
        result = function_value(std::get<std::shared_ptr<const Function>>(value), place);
    }
    reader_.expect(')');
    return result;
}

Number Expression::function_value(const std::shared_ptr<const Function>& function, const Span& place) {
    std::vector<double> arguments;
    while (arguments.size() < function->parameters) arguments.push_back(arguments.empty() ? sum_float() : next_float());
    return {{reader_.evaluate(function, arguments, place)}, 1, false};
}

/// Red, green, blue, filter and transmit of a pigment at (x, y, z).
Number Expression::pigment_color(const PigmentFunction& pigment, const Span& place) {
    const double x = sum_float(), y = next_float(), z = next_float();
    std::shared_ptr<const Function>& asked = state_.answering_pigments[pigment.source];
    if (!asked) {
        Function function;
        function.sources.push_back(pigment.source);
        function.source_nodes = pigment.nodes;
        asked = state_.answering_function(std::make_shared<const Function>(std::move(function)), place);
    }
    state_.count_replay(place, pigment.nodes);
    const std::array<double, 6> values = asked->sources.front()->values({x, y, z});
    return {{values[0], values[1], values[2], values[3], values[4]}, 5, false};
}

std::shared_ptr<const Function> Reader::State::answering_function(const std::shared_ptr<const Function>& stated, const Span& place) {
    if (stated->source_nodes == 0) return stated;
    std::shared_ptr<const Function>& known = answering[stated];
    if (known) return known;
    if (!options.compile_function) {
        reader.unmodelled(place, "a pattern's value while reading");
        return stated;
    }
    return known = options.compile_function(stated, scene);
}

double Reader::evaluate(const std::shared_ptr<const Function>& function, std::span<const double> arguments, const Span& place) {
    const std::uint64_t most = state_->options.max_replayed_bytes / 8;  // a step takes longer than a byte
    std::uint64_t left = most;
    const std::optional<double> value = rt::evaluate(*state_->answering_function(function, place), arguments, left);
    if (!value) fail_limit(place, fmt::format("A call of a function takes more than {} steps.", most), "reread");
    state_->count_replay(place, most - left + function->source_nodes);
    return *value;
}

/// spline(t [, kind])
Number Expression::spline_value(const Spline& spline, const Span& place) {
    const double t = sum_float();
    reader_.accept_comma();
    const Spline::Kind kind = accept_kind(reader_).value_or(spline.kind);
    if (kind == Spline::Kind::natural) state_.count_replay(place, spline.points.size());
    return {rt::evaluate(spline, t, kind), spline.size, false};
}

}  // namespace rt
