#include "syntax/function_source.h"

#include <fmt/format.h>

#include "scene/function_source.h"
#include "syntax/blocks.h"
#include "syntax/parse_pattern.h"
#include "syntax/reader_state.h"
#include "syntax/texture_layers.h"

namespace rt {

namespace {

PigmentFunction pigment_function(Reader& reader) {
    const Pigment pigment = parse_pigment(reader, default_pigment(reader));
    const TreeSize size = tree_size(pigment);
    return {std::make_shared<const StatedSource>(pigment), size.nodes, size.depth};
}

std::shared_ptr<const Function> function_of_pattern(Reader& reader, const Span& place, StatedPattern stated) {
    Function function;
    function.parameters = 3;
    for (std::uint32_t i = 0; i < 3; ++i) function.steps.push_back({.op = Function::Op::argument, .index = i});
    function.steps.push_back({.op = Function::Op::source});
    function.stack = 3;
    PatternPigment whole;
    whole.pattern = stated;
    const TreeSize size = tree_size(Pigment{Shared<PatternPigment>(std::move(whole)), {}, {}});
    limit_size(reader, place, size);
    function.source_nodes = size.nodes, function.source_depth = size.depth;
    function.sources.push_back(std::make_shared<const StatedSource>(std::move(stated)));
    return std::make_shared<const Function>(std::move(function));
}

std::shared_ptr<const Function> pattern_function(Reader& reader) {
    const Span place = reader.last_place();
    reader.begin_block("pattern");
    StatedPattern stated;
    for (const Word unknown : {Word::aoi, Word::average, Word::slope})  // what asks for a surface or a map is not known here
        if (reader.peek().is(unknown)) reader.end_block();
    if (!accept_pattern(reader, stated, PatternUse::pigment)) reader.fail_expected("pattern");
    end_list(reader, stated.pattern.kind);
    while (accept_pattern_modifier(reader, stated, PatternUse::pigment)) {
    }
    reader.end_block();
    return function_of_pattern(reader, place, std::move(stated));
}

class MovedPoint final : public FunctionSource {
public:
    explicit MovedPoint(const Transform& transform) : transform_(transform) {}

    std::array<double, 6> values(const Vec3& point) const override {
        const Vec3 moved = transform_.point(point);
        return {moved.x, moved.y, moved.z};
    }

private:
    Transform transform_;
};

}  // namespace

PigmentFunction moved_point(const Transform& transform) { return {std::make_shared<const MovedPoint>(transform), 0, 0}; }

std::shared_ptr<const Function> noise_function(Reader& reader, const Span& place) {
    StatedPattern noise;
    noise.pattern = make_pattern(PatternKind::bozo);
    return function_of_pattern(reader, place, std::move(noise));
}

std::shared_ptr<const Function> grey_of(const PigmentFunction& pigment) {
    constexpr std::uint32_t grey = 5;
    Function function;
    function.parameters = function.stack = 3;
    for (std::uint32_t i = 0; i < 3; ++i) function.steps.push_back({.op = Function::Op::argument, .index = i});
    function.steps.push_back({.op = Function::Op::source, .count = grey});
    function.source_nodes = pigment.nodes, function.source_depth = pigment.depth;
    function.sources.push_back(pigment.source);
    return std::make_shared<const Function>(std::move(function));
}

FunctionValue function_of_source(Reader& reader, Word word) {
    if (word == Word::pigment) return pigment_function(reader);
    return pattern_function(reader);
}

std::shared_ptr<const Function> Reader::parse_pattern_function() {
    const Span place = last_place();
    const Value value = state_->parse_function(place);
    const auto* function = std::get_if<FunctionValue>(&value);
    if (const auto* pigment = function ? std::get_if<PigmentFunction>(function) : nullptr) return grey_of(*pigment);
    const auto* of_floats = function ? std::get_if<std::shared_ptr<const Function>>(function) : nullptr;
    if (!of_floats) {
        if (!std::holds_alternative<UnmodelledValue>(value))
            fail(place, "A pattern's function is one of x, y and z with a number as value.");
        return nullptr;
    }
    if ((*of_floats)->parameters != 3)
        fail(place, fmt::format("Function has {} parameters, a pattern has 3: x, y and z.", (*of_floats)->parameters));
    return *of_floats;
}

}  // namespace rt
