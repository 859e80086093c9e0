// inside, trace, min_extent and max_extent of declared objects.
#include "syntax/expression.h"
#include "syntax/set_value.h"

namespace rt {

namespace {

/// What a question to a union of that many objects counts for among what is read again.
constexpr std::size_t bytes_per_object = 4;

std::size_t count_of(const ObjectValue& object) { return object.set ? (*object.set)->parts.objects.size() : object.objects.size(); }

/// What answers for the object, made when it is first asked. Not a reference: what stands in the parentheses may declare the name anew.
ProbeSlot asked(Reader::State& state, const ObjectValue& object, const Span& place) {
    ProbeSlot& slot = object.asked;
    const std::size_t count = count_of(object);
    state.count_replay(place, bytes_per_object * count);
    if (slot.probe) return slot;
    state.reader.count_parts(place, count);
    Parts parts = resolved(object);
    slot.solid = !has_patch(parts);
    slot.probe = state.options.make_probe(bodies_of(std::move(parts)));
    return slot;
}

Extent box_of(const ObjectValue& object) { return object.exists() ? extent_of(object) : Extent{}; }

}  // namespace

/// The object has a name; a light is one as well, without a surface and without end. The '(' is taken.
std::optional<Number> Expression::function_of_object(Word w, const Span& place) {
    if (w != Word::inside && w != Word::trace && w != Word::min_extent && w != Word::max_extent) return std::nullopt;
    const Span named = reader_.peek().span;
    const ObjectValue none;
    const ObjectValue* object = reader_.accept_declared<ObjectValue>();
    const bool light = !object && reader_.accept_declared<Light>();
    if (light) object = &none;
    if (!object) reader_.fail(named, "Object identifier expected.");
    if (w == Word::min_extent) return vector_of(box_of(*object).min());
    if (w == Word::max_extent) return vector_of(box_of(*object).max());
    if (!state_.options.make_probe) return std::nullopt;
    const ProbeSlot slot = asked(state_, *object, place);
    if (w == Word::trace) return trace(*slot.probe);
    if (light || !slot.solid) reader_.fail(named, "Solid object identifier expected.");
    return Number{{slot.probe->contains(next_vector()) ? 1.0 : 0.0}, 1, false};
}

/// trace(Object, from, direction [, Normal]) after the object: zeros where nothing is met.
Number Expression::trace(const ObjectProbe& probe) {
    const Vec3 from = next_vector(), direction = next_vector();
    const ObjectProbe::Met met = probe.trace(from, direction).value_or(ObjectProbe::Met{});
    reader_.accept_comma();
    const Value* const next = reader_.next_value();
    const Number* const normal = next ? std::get_if<Number>(next) : nullptr;
    if (normal && normal->size == 3 && !normal->color) {
        const VariablePtr variable = state_.ahead_variable;
        reader_.accept_declared<Number>();
        variable->value = vector_of(met.normal);
    }
    return vector_of(met.point);
}

}  // namespace rt
