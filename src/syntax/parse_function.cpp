// function { }: the expression is read once, into the steps of a Function.
#include <fmt/format.h>

#include <algorithm>

#include "core/function.h"
#include "syntax/blocks.h"
#include "syntax/expression.h"
#include "syntax/function_source.h"
#include "syntax/texture_layers.h"
#include "syntax/unmodelled.h"

namespace rt {

namespace {

using Op = Function::Op;

constexpr std::size_t max_parameters = 56;
constexpr std::size_t max_call_depth = 100;  ///< of functions that call functions

struct Named {
    Word word;
    Op op;
};
constexpr Named of_one[] = {{Word::abs, Op::abs},         {Word::acos, Op::acos},    {Word::acosh, Op::acosh}, {Word::asin, Op::asin},
                            {Word::asinh, Op::asinh},     {Word::atan, Op::atan},    {Word::atanh, Op::atanh}, {Word::ceil, Op::ceil},
                            {Word::cos, Op::cos},         {Word::cosh, Op::cosh},    {Word::exp, Op::exp},     {Word::floor, Op::floor},
                            {Word::degrees, Op::degrees}, {Word::int_, Op::integer}, {Word::ln, Op::ln},       {Word::log, Op::log},
                            {Word::radians, Op::radians}, {Word::sin, Op::sin},      {Word::sinh, Op::sinh},   {Word::sqrt, Op::sqrt},
                            {Word::tan, Op::tan},         {Word::tanh, Op::tanh}};
constexpr Named of_two[] = {{Word::atan2, Op::atan2}, {Word::div, Op::div}, {Word::mod, Op::mod}, {Word::pow, Op::pow}};

template <std::size_t N>
const Named* find_named(const Named (&table)[N], Word w) {
    const auto found = std::find_if(table, table + N, [w](const Named& n) { return n.word == w; });
    return found == table + N ? nullptr : found;
}

/// The same levels as those of Expression, but that '&' binds closer than '|'.
class FunctionParser {
public:
    FunctionParser(Reader::State& state, std::vector<std::string_view> names)
        : state_(state), reader_(state.reader), names_(std::move(names)) {
        function_.parameters = names_.size();
    }

    Function parse() {
        either();
        return std::move(function_);
    }

private:
    void either() {
        both();
        while (reader_.accept('|')) {
            both();
            emit(Op::either);
        }
    }

    void both() {
        relation();
        while (reader_.accept('&')) {
            relation();
            emit(Op::both);
        }
    }

    void relation() {
        sum();
        for (;;) {
            constexpr std::string_view symbols = "<>LG=N";
            constexpr Op ops[] = {Op::less, Op::greater, Op::not_greater, Op::not_less, Op::equal, Op::unequal};
            const std::size_t found = reader_.peek().symbol == 0 ? symbols.npos : symbols.find(reader_.peek().symbol);
            if (found == symbols.npos) return;
            reader_.take();
            sum();
            emit(ops[found]);
        }
    }

    void sum() {
        product();
        while (reader_.peek().is('+') || reader_.peek().is('-')) {
            const Op op = reader_.take().is('+') ? Op::add : Op::subtract;
            product();
            emit(op);
        }
    }

    void product() {
        unary();
        while (reader_.peek().is('*') || reader_.peek().is('/')) {
            const Op op = reader_.take().is('*') ? Op::multiply : Op::divide;
            unary();
            emit(op);
        }
    }

    void unary() {
        const NestingGuard guard(state_, reader_.peek().span);
        if (reader_.accept('-')) {
            unary();
            emit(Op::negate);
        } else if (reader_.accept('+')) {
            unary();
        } else {
            primary();
        }
    }

    void primary() {
        const Token token = reader_.peek();
        if (token.kind == Token::Kind::number) {
            constant(reader_.take().number);
        } else if (token.is('(')) {
            reader_.take();
            either();
            reader_.expect(')');
        } else if (const std::optional<std::size_t> index = argument(token)) {
            reader_.take();
            push({.op = Op::argument, .index = static_cast<std::uint32_t>(*index)});
        } else if (token.kind == Token::Kind::identifier) {
            identifier();
        } else if (token.kind == Token::Kind::word) {
            word(token);
        } else {
            fail_operand();
        }
    }

    /// The innermost counter or the first parameter of that name. The names that every function knows are 0 where they are no parameters.
    std::optional<std::size_t> argument(const Token& token) const {
        if (token.kind != Token::Kind::identifier && token.kind != Token::Kind::word) return std::nullopt;
        const auto parameters = names_.begin() + static_cast<std::ptrdiff_t>(function_.parameters);
        const auto counter = std::find(names_.rbegin(), std::make_reverse_iterator(parameters), token.text);
        if (counter.base() != parameters) return static_cast<std::size_t>(counter.base() - names_.begin()) - 1;
        const auto parameter = std::find(names_.begin(), parameters, token.text);
        if (parameter == parameters) return std::nullopt;
        return static_cast<std::size_t>(parameter - names_.begin());
    }

    void identifier() {
        if (const Number* declared = reader_.accept_declared<Number>()) {
            if (declared->size != 1)
                reader_.fail(reader_.last_place(), "Expected 'operand', vector function 'vector identifier' found instead");
            constant(declared->v[0]);
        } else if (const FunctionValue* value = reader_.accept_declared<FunctionValue>()) {
            if (const auto* const pigment = std::get_if<PigmentFunction>(value)) {
                color_component(PigmentFunction(*pigment));
                return;
            }
            if (const auto* const transform = std::get_if<Transform>(value)) {
                coordinate(moved_point(*transform));
                return;
            }
            const auto* const program = std::get_if<std::shared_ptr<const Function>>(value);
            if (!program) reader_.fail(reader_.last_place(), "A function of floats cannot call one whose values are vectors.");
            call(std::shared_ptr<const Function>(*program));
        } else if (reader_.accept_declared<UnmodelledValue>()) {
            reader_.expect('(');
            skip_arguments(reader_);
            constant(0.0);
        } else {
            fail_operand();
        }
    }

    void call(const std::shared_ptr<const Function>& called) {
        function_.depth = std::max(function_.depth, called->depth + 1);
        if (function_.depth > max_call_depth)
            reader_.fail_limit(reader_.last_place(), fmt::format("Functions call each other more than {} deep.", max_call_depth), "");
        arguments(called->parameters);
        push({.op = Op::call, .index = static_cast<std::uint32_t>(function_.called.size())});
        held_ -= called->parameters;
        function_.called.push_back(called);
        add_sources(called->source_nodes, called->source_depth);
    }

    /// `(x, y, z).red`: one number of a pigment's colour.
    void color_component(const PigmentFunction& pigment) {
        arguments(3);
        reader_.expect('.');
        const Token& member = reader_.peek();
        std::optional<int> index = member.text == "grey" ? std::optional(-1) : std::nullopt;
        if (member.kind == Token::Kind::word) index = component_index(member.word);
        if (!index) reader_.fail_expected("x, y, z or color component");
        reader_.take();
        constexpr std::uint32_t grey = 5;
        ask(pigment, *index < 0 ? grey : static_cast<std::uint32_t>(*index));
    }

    /// `(x, y, z).x`: one coordinate of a point that was moved.
    void coordinate(const PigmentFunction& moved) {
        arguments(3);
        reader_.expect('.');
        const std::optional<int> index = component_index(reader_.peek().word);  // none of Word::none
        if (!index || *index < 0 || *index > 2) reader_.fail_expected("x, y or z");
        reader_.take();
        ask(moved, static_cast<std::uint32_t>(*index));
    }

    /// Value `count` of a source at the point that is on the stack.
    void ask(const PigmentFunction& asked, std::uint32_t count) {
        push({.op = Op::source, .count = count, .index = static_cast<std::uint32_t>(function_.sources.size())});
        held_ -= 3;
        function_.sources.push_back(asked.source);
        add_sources(asked.nodes, asked.depth);
    }

    void add_sources(std::size_t nodes, std::size_t depth) {
        function_.source_nodes += nodes;
        function_.source_depth = std::max(function_.source_depth, depth);
        limit_size(reader_, reader_.last_place(), {function_.source_nodes, function_.source_depth});
    }

    /// `(a, b, ...)`: as many as that.
    void arguments(std::size_t count) {
        reader_.expect('(');
        for (std::size_t i = 0; i < count; ++i) {
            if (i > 0) reader_.accept_comma();
            either();
        }
        reader_.expect(')');
    }

    void word(const Token& token) {
        if (token.is(Word::x) || token.is(Word::y) || token.is(Word::z) || token.is(Word::u) || token.is(Word::v) || token.is(Word::t)) {
            reader_.take();
            constant(0.0);
        } else if (token.is(Word::pi) || token.is(Word::clock)) {
            reader_.take();
            constant(token.is(Word::pi) ? pi : state_.options.clock);
        } else if (const Named* one = find_named(of_one, token.word)) {
            reader_.take();
            arguments(1);
            emit(one->op);
        } else if (const Named* two = find_named(of_two, token.word)) {
            reader_.take();
            arguments(2);
            emit(two->op);
        } else if (token.is(Word::min) || token.is(Word::max)) {
            reader_.take();
            extreme(token.is(Word::min) ? Op::min : Op::max);
        } else if (token.is(Word::select)) {
            reader_.take();
            select();
        } else if (token.is(Word::sum) || token.is(Word::prod)) {
            reader_.take();
            series(token.is(Word::sum) ? Op::sum : Op::product);
        } else {
            fail_operand();
        }
    }

    void extreme(Op op) {
        reader_.expect('(');
        either();
        while (reader_.accept(',')) {
            either();
            emit(op);
        }
        reader_.expect(')');
    }

    void select() {
        reader_.expect('(');
        for (int i = 0; i < 3; ++i) {
            if (i > 0) reader_.accept_comma();
            either();
        }
        const bool four = reader_.accept(',');
        if (four) either();
        reader_.expect(')');
        emit(four ? Op::select4 : Op::select3);
    }

    /// sum(i, first, last, expression), prod(...).
    void series(Op op) {
        reader_.expect('(');
        const Token counter = state_.take_name();
        if (counter.kind != Token::Kind::identifier && counter.kind != Token::Kind::word)
            reader_.fail(counter.span, fmt::format("Expected 'identifier', {} found instead", reader_.describe(counter)));
        reader_.accept_comma();
        either();
        reader_.accept_comma();
        either();
        reader_.accept_comma();
        const std::size_t at = function_.steps.size();
        function_.counters = std::max(function_.counters, names_.size() + 1 - function_.parameters);
        push({.op = op, .count = static_cast<std::uint32_t>(names_.size())});
        names_.push_back(counter.text);
        either();
        names_.pop_back();
        held_ -= 3;  // the bounds became one value, as the terms do
        ++held_;
        function_.steps[at].index = static_cast<std::uint32_t>(function_.steps.size());
        reader_.expect(')');
    }

    void constant(double x) { push({.op = Op::constant, .value = x}); }

    /// An operation of operands that are there.
    void emit(Op op) {
        held_ -= op >= Op::select4 ? 4 : op >= Op::select3 ? 3 : op >= Op::negate ? 1 : 2;
        push({.op = op});
    }

    void push(const Function::Step& step) {
        function_.steps.push_back(step);
        function_.stack = std::max(function_.stack, ++held_);
    }

    [[noreturn]] void fail_operand() { reader_.fail_expected("operand"); }

    Reader::State& state_;
    Reader& reader_;
    std::vector<std::string_view> names_;  ///< parameters, then the counters that are in force
    Function function_;
    std::size_t held_ = 0;  ///< values on the stack
};

bool is_parameter_name(const Token& token) {
    return token.kind == Token::Kind::identifier || token.is(Word::x) || token.is(Word::y) || token.is(Word::z) || token.is(Word::u) ||
           token.is(Word::v) || token.is(Word::t);
}

}  // namespace

std::vector<std::string_view> Reader::State::parse_parameters() {
    if (!raw_next_is('(')) return {"x", "y", "z"};
    reader.expect('(');
    std::vector<std::string_view> parameters;
    for (;;) {
        const Token name = take_name();
        if (name.is(')') && !parameters.empty()) return parameters;
        if (!is_parameter_name(name) || parameters.size() == max_parameters)
            reader.fail(name.span, fmt::format("Expected 'parameter identifier', {} found instead", reader.describe(name)));
        parameters.push_back(name.text);
        names_only = true;
        reader.accept_comma();
    }
}

/// What follows the word `function`.
Value Reader::State::parse_function(const Span& place) {
    const bool parameters_follow = raw_next_is('(');
    const std::vector<std::string_view> parameters = parse_parameters();
    reader.begin_block("function");
    const Token next = reader.peek();
    Value value = UnmodelledValue{Word::function};
    if (next.is(Word::pattern) || next.is(Word::pigment)) {
        if (parameters_follow) reader.fail(place, "Function parameters for pigment functions are not allowed.");
        reader.take();
        value = function_of_source(reader, next.word);
    } else if (next.is(Word::internal)) {
        value = parse_built_in(place);
    } else if (const std::optional<Transform> transform = accept_transform(reader)) {
        value = FunctionValue(*transform);
    } else if (reader.accept(Word::spline)) {
        value = FunctionValue(parse_spline());
    } else {
        value = FunctionValue(std::make_shared<const Function>(FunctionParser(*this, parameters).parse()));
    }
    reader.end_block();
    return value;
}

/// internal(number)
Value Reader::State::parse_built_in(const Span& place) {
    reader.take();
    reader.expect('(');
    const double number = Expression(*this).sum_float();
    reader.expect(')');
    const int n = number >= 0.0 && number < 1000.0 ? static_cast<int>(number) : -1;
    if (n == 76) return FunctionValue(noise_function(reader, place));
    Function function;
    function.parameters = built_in_parameters(n);
    if (function.parameters == 0) {
        reader.unmodelled(place, fmt::format("function {{ internal({:g}) }}", number));
        return UnmodelledValue{Word::function};
    }
    function.steps.push_back({.op = Op::built_in, .index = static_cast<std::uint32_t>(n)});
    function.stack = 1;
    return FunctionValue(std::make_shared<const Function>(std::move(function)));
}

}  // namespace rt
