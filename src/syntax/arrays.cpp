// Arrays: array[2][3] { ... }, their elements, and setting one.
#include <fmt/format.h>

#include "syntax/expression.h"
#include "syntax/reader_state.h"

namespace rt {

namespace {

constexpr std::size_t max_dimensions = 5;
constexpr std::size_t max_depth = 100;     ///< of arrays inside arrays
constexpr double index_tolerance = 1e-10;  ///< what subscripts and sizes may lie below a whole number

/// Goes no deeper than one array beyond what is allowed: whoever set an array's element through a macro's parameter was not stopped.
void measure(const ArrayValue& array, std::size_t level, ArrayExtent& extent) {
    extent.depth = std::max(extent.depth, level);
    extent.elements += array.elements.size();
    if (level > max_depth) return;
    for (const VariablePtr& element : array.elements)
        if (const auto* inner = element ? std::get_if<ArrayValue>(&element->value) : nullptr) measure(*inner, level + 1, extent);
}

VariablePtr copy_of(const VariablePtr& variable) {
    if (!variable) return nullptr;
    auto copy = std::make_shared<Variable>(*variable);
    own_elements(copy->value);
    return copy;
}

}  // namespace

ArrayExtent Reader::State::extent_of(const Span& place, const ArrayValue& array, std::size_t around) {
    ArrayExtent extent;
    measure(array, 1 + around, extent);
    if (extent.depth > max_depth) reader.fail_limit(place, fmt::format("Arrays hold arrays more than {} deep.", max_depth), "");
    return extent;
}

void own_elements(Value& value) {
    if (auto* array = std::get_if<ArrayValue>(&value))
        for (VariablePtr& element : array->elements) element = copy_of(element);
}

/// What follows the word `array`.
ArrayValue Reader::State::parse_array() {
    ArrayValue array;
    std::size_t count = 1;
    while (raw_next_is('[')) {
        reader.expect('[');
        if (array.sizes.size() == max_dimensions) reader.fail(last, "Too many array dimensions");
        const Span place = reader.peek().span;
        const double size = std::trunc(Expression(*this).sum_float() + index_tolerance);
        if (!(size >= 1.0 && size <= 2147483647.0)) reader.fail(since(place), "Invalid dimension size for an array");
        array.sizes.push_back(static_cast<std::size_t>(size));
        if (array.sizes.back() > options.max_array_elements / count)
            reader.fail_limit(since(place), fmt::format("An array has more than {} elements.", options.max_array_elements), "array");
        count *= array.sizes.back();
        reader.expect(']');
    }
    if (array.sizes.empty()) reader.fail(reader.peek().span, "An array declaration must have at least one dimension");
    array.elements.resize(count);
    std::size_t next = 0;
    if (raw_next_is('{')) parse_elements(array, 0, next);
    return array;
}

/// `{ value, ... }`, with one level of braces for each dimension.
void Reader::State::parse_elements(ArrayValue& array, std::size_t dimension, std::size_t& next) {
    reader.begin_block("{");
    for (std::size_t i = 0; i < array.sizes[dimension]; ++i) {
        if (dimension + 1 < array.sizes.size()) {
            parse_elements(array, dimension + 1, next);
        } else {
            const Span place = reader.peek().span;
            const auto element = std::make_shared<Variable>();
            element->value = parse_declared_value(element->missing);
            set_element(since(place), array, next++, element);
        }
        reader.accept_comma();
    }
    reader.end_block();
}

void Reader::State::set_element(const Span& place, ArrayValue& array, std::size_t index, VariablePtr value) {
    if (const auto* inner = std::get_if<ArrayValue>(&value->value)) extent_of(place, *inner, 1);
    const std::string_view kind = kind_of(value->value);
    if (array.kind.empty()) array.kind = kind;
    if (array.kind != kind) reader.fail(place, fmt::format("Attempted to redefine {} as {}.", array.kind, kind));
    VariablePtr& element = array.elements[index];
    if (element)
        *element = std::move(*value);
    else
        element = std::move(value);
}

/// One subscript in brackets for each dimension. Reading one may set another array in this one's place.
std::size_t Reader::State::parse_index(const Variable& variable) {
    std::size_t index = 0;
    for (std::size_t dimension = 0;; ++dimension) {
        reader.expect('[');
        const Span first = reader.peek().span;
        const NestingGuard guard(*this, first);
        const double i = Expression(*this).sum_float() + index_tolerance;
        const Span place = since(first);
        reader.expect(']');
        const auto* const array = std::get_if<ArrayValue>(&variable.value);
        if (i < 0.0) reader.fail(place, "Negative subscript");
        if (!array || dimension >= array->sizes.size() || !(i < static_cast<double>(array->sizes[dimension])))
            reader.fail(place, "Array subscript out of range");
        index = index * array->sizes[dimension] + static_cast<std::size_t>(i);
        if (dimension + 1 < array->sizes.size()) continue;
        if (index >= array->elements.size()) reader.fail(place, "Array subscript out of range");
        return index;
    }
}

VariablePtr Reader::State::parse_subscripts(VariablePtr variable) {
    while (variable && std::holds_alternative<ArrayValue>(variable->value) && raw_next_is('[')) {
        const std::size_t index = parse_index(*variable);
        variable = VariablePtr(std::get<ArrayValue>(variable->value).elements[index]);
    }
    return variable;
}

/// The rest of `#declare NAME` where a subscript of the array `variable` comes next.
void Reader::State::declare_element(const Token& name, VariablePtr variable) {
    std::size_t index = parse_index(*variable);
    while (raw_next_is('[')) {
        const VariablePtr element = std::get<ArrayValue>(variable->value).elements[index];
        if (!element || !std::holds_alternative<ArrayValue>(element->value)) break;
        variable = element;
        index = parse_index(*variable);
    }
    const Span place = since(name.span);
    reader.expect('=');
    const VariablePtr value = std::make_shared<Variable>();
    parse_declaration(*value);
    auto* const array = std::get_if<ArrayValue>(&variable->value);
    if (!array || index >= array->elements.size()) reader.fail(place, "Array subscript out of range");
    set_element(place, *array, index, value);
}

}  // namespace rt
