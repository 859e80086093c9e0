// Numeric expressions, evaluated while they are read.
#pragma once

#include "syntax/reader_state.h"

namespace rt {

/// Where POV-Ray asks whether something holds: magnitudes below 1e-10 are false.
bool is_true(double x);

/// Index of a component's name; -1 for the grey value, empty if it is none.
std::optional<int> component_index(Word w);

/// Does a string expression come next?
bool at_string(Reader& reader);
/// The characters of a string literal with its escapes resolved.
std::string unescaped(Reader& reader, const Token& token);

/// One method a level of the grammar:
///     condition = junction [ '?' condition ':' condition ]        only inside parentheses, in #if and in colours
///     junction  = relation { ('&' | '|') relation }               both operators bind alike here, '&' closer in functions
///     relation  = sum { (< <= > >= = !=) sum }
///     sum       = product { (+ | -) product }
///     product   = unary { (* | /) unary }
///     unary     = { + | - | ! } primary [ '.' component ]
/// A float meets a vector as a vector of equal components; a shorter vector is filled up with zeros.
class Expression {
public:
    explicit Expression(Reader::State& state) : state_(state), reader_(state.reader) {}

    Number condition();
    double condition_float();
    Number sum();
    double sum_float();
    Vec3 sum_vector();
    std::string string();
    /// What a word that is a number by itself stands for.
    std::optional<Number> constant(Word w);

private:
    struct Field {
        int width;
        int precision;
    };

    Number junction();
    Number relation();
    Number string_relation();
    Number product();
    Number unary();
    Number primary();
    Number identifier();
    Number vector_literal();
    Number component(const Number& whole, const Span& place);
    Number divide(Number a, const Number& b, const Span& place);
    double to_float(const Number& n, const Span& first);

    // functions.cpp
    Number word(Word w);
    std::optional<double> function_of_float(Word w, const Span& place);
    std::optional<double> function_of_floats(Word w, const Span& place);
    std::optional<double> function_of_vectors(Word w);
    std::optional<Vec3> vector_function(Word w, const Span& place);
    double evaluate(Word w, double x, const Span& place);
    double extreme(Word w);
    Number select();
    double random_number(const Span& place);
    double new_random_stream();
    bool is_defined();
    double array_function(Word w);
    Number unmodelled_function(Word w, const Span& place);
    Number unmodelled_call();
    Number call();
    Number function_value(const std::shared_ptr<const Function>& function, const Span& place);
    Number pigment_color(const PigmentFunction& pigment, const Span& place);
    Number spline_value(const Spline& spline, const Span& place);
    double next_float();
    Vec3 next_vector();

    // object_functions.cpp
    std::optional<Number> function_of_object(Word w, const Span& place);
    Number trace(const ObjectProbe& probe);

    // strings.cpp
    std::optional<double> function_of_strings(Word w);
    std::string string_function(Word w, const Span& place);
    std::string concatenation(const Span& place);
    Field field(const Span& place);
    std::string formatted_float(double x, const Span& place);
    std::string formatted_vector(const Span& place);
    std::string substring(const Span& place);

    Reader::State& state_;
    Reader& reader_;
};

}  // namespace rt
