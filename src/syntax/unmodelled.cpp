#include "syntax/unmodelled.h"

#include <algorithm>
#include <initializer_list>

namespace rt {

namespace {

constexpr std::initializer_list<Word> unmodelled_shapes{Word::julia_fractal, Word::ovus, Word::parametric};

constexpr std::initializer_list<Word> patterns{Word::pavement, Word::tiling};

constexpr std::initializer_list<Word> items{Word::media};

/// Features that are worth a line of their own where they stand inside something that is skipped as a whole.
constexpr std::initializer_list<Word> inner_features{Word::density, Word::dispersion, Word::material_map, Word::media};

bool contains(std::initializer_list<Word> words, Word w) { return std::find(words.begin(), words.end(), w) != words.end(); }

void report_inner(Reader& reader, const Token& token) {
    if (token.kind != Token::Kind::word) return;
    if (contains(unmodelled_shapes, token.word) || contains(patterns, token.word) || contains(inner_features, token.word))
        reader.unmodelled(token.span, text(token.word));
}

}  // namespace

bool is_unmodelled_shape(Word w) { return contains(unmodelled_shapes, w); }
bool is_unmodelled_pattern(Word w) { return contains(patterns, w); }
bool is_unmodelled_item(Word w) { return contains(items, w); }

void skip_unmodelled_block(Reader& reader, const Token& word) {
    reader.unmodelled(word.span, text(word.word));
    reader.begin_block(text(word.word));
    skip_to_block_end(reader);
    reader.end_block();
}

void skip_inner_block(Reader& reader) {
    reader.begin_block("{");
    skip_to_block_end(reader);
    reader.end_block();
}

void skip_to_block_end(Reader& reader) {
    for (std::size_t depth = 0;;) {
        const Token& next = reader.peek();
        if (next.kind == Token::Kind::end || (next.is('}') && depth == 0)) return;
        if (next.is('{')) ++depth;
        if (next.is('}')) --depth;
        report_inner(reader, reader.take());
    }
}

void skip_arguments(Reader& reader) {
    for (std::size_t depth = 1; depth != 0;) {
        const Token token = reader.take();
        if (token.is('(')) ++depth;
        if (token.is(')')) --depth;
        if (token.kind == Token::Kind::end) reader.fail(token.span, "Expected ')', End of File found instead");
    }
}

}  // namespace rt
