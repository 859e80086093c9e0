// The stream of tokens as blocks see it: directives carried out, includes entered, names known.
//
// A token is scanned when it is asked for, from a stack of input frames (file, position, end). A loop is a jump of the top frame back to
// the position of its condition; a macro call pushes a frame over the body's span with a scope of its own; `#switch` is one more kind of
// entry on the stack of open conditionals; arrays are alternatives of `Value`, and an identifier with subscripts is one token that stands
// for the element. Nothing downstream of `peek`/`take` sees any of it.
#pragma once

#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "syntax/parser.h"
#include "syntax/token.h"
#include "syntax/value.h"

namespace rt {

class Reader {
public:
    Reader(const ParseOptions& options, Scene& scene, const MessageSink& messages);
    ~Reader();
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    /// Starts reading `file`. Call once.
    void open(SourceFile file);

    // --- tokens; no directive and no comment is ever seen here
    const Token& peek() {
        if (!cursor_.has_ahead) fill();
        return cursor_.ahead;
    }
    Token take() {
        const Token& token = peek();
        cursor_.step();
        return token;
    }
    Span last_place() const { return cursor_.last; }  ///< of the token taken last
    bool accept(Word w) {
        const bool found = peek().is(w);
        if (found) cursor_.step();
        return found;
    }
    bool accept(char symbol) {
        const bool found = peek().is(symbol);
        if (found) cursor_.step();
        return found;
    }
    /// The same for the very next token of the text: a directive that stands there instead is not carried out yet, since the value that
    /// was just read may have to get its name first.
    bool accept_at_once(Word w);
    /// Takes `symbol` or fails: "No matching } in 'sphere', undeclared identifier 'x' found instead" for '}' inside `open_block`,
    /// "Missing { ..." style texts as POV-Ray words them otherwise.
    void expect(char symbol);

    // --- blocks: begin takes '{' (its word was just taken), end takes '}'; used for error texts and the nesting limit. `name` is a literal
    // or a word's text, which last.
    void begin_block(std::string_view name);
    void end_block();
    /// True if the next token is '}' (not taken).
    bool at_block_end() { return peek().is('}'); }

    // --- values (expression.cpp)
    double parse_float();                  ///< a float factor chain as POV-Ray reads parameters; a vector is an error
    bool parse_bool_or(bool when_absent);  ///< optional bool after a flag keyword: on, off, an expression, or nothing
    bool at_expression();                  ///< could the next token begin a numeric expression?
    Vec3 parse_vector();                   ///< a float promotes to all three
    Vec2 parse_vector2();
    Number parse_condition();  ///< any size; comparisons and choices need no parentheses: what POV-Ray reads where it expects a colour
    std::string parse_string();
    /// `function { }` of x, y and z after its word; none where what it is made of is not modelled.
    std::shared_ptr<const Function> parse_pattern_function();
    /// Its value; what it costs counts towards the limit of what the scene computes, for which `place` is blamed.
    double evaluate(const std::shared_ptr<const Function>& function, std::span<const double> arguments, const Span& place);
    /// A file that the scene names, looked for as included files are; empty if there is none. Throws OptionError for what is no picture.
    /// Where there is no file of that name, the `extensions` are appended one after the other.
    std::optional<PictureFile> find_picture(std::string_view name, std::span<const std::string_view> extensions);
    void accept_comma();  ///< commas between parameters are optional

    /// The bytes of a file that a scene names, found where included files are; the first of `extensions` that fits is appended to the name.
    std::optional<std::string> read_file(const std::string& name, std::initializer_list<const char*> extensions);

    // --- names
    /// The declared value of the identifier that comes next if it holds a T (the token is taken), else null.
    template <typename T>
    const T* accept_declared() {
        const Value* value = next_value();
        const T* held = value ? std::get_if<T>(value) : nullptr;
        if (held) take_declared();
        return held;
    }
    /// A copy of the declared value of the identifier that comes next (the token is taken), whatever it is.
    std::optional<Value> accept_any_declared();
    /// What the next token stands for if it is a name (with subscripts, if it is an array's) that was declared, else null.
    const Value* next_value() {
        const bool named = peek().kind == Token::Kind::identifier && cursor_.ahead_variable;
        return named ? &cursor_.ahead_variable->value : nullptr;
    }
    /// What a name stands for. Of the next token, which may have subscripts, ask `next_value`.
    const Value* find(std::string_view name) const;

    // --- messages
    /// Throws "Parse Error: text" at `span`.
    [[noreturn]] void fail(const Span& span, std::string_view text);
    /// Throws POV-Ray's "Expected '<what>', <description of the next token> found instead".
    [[noreturn]] void fail_expected(std::string_view what);
    /// Throws LimitError: `text` at `span` and how to allow more, where `limit` is one of limits.h; with an empty one nothing does.
    [[noreturn]] void fail_limit(const Span& span, std::string_view text, std::string_view limit);
    void warn(const Span& span, std::string_view text);           ///< "Parse Warning: text"
    void warn_possible(const Span& span, std::string_view text);  ///< "Possible Parse Error: text"
    /// A known feature that is not modelled, met at `span`: error, warning or collected, as the options say. The caller then skips it.
    void unmodelled(const Span& span, std::string_view feature);
    /// Skips a block, nested braces and directives included; the next token is its '{'.
    void skip_block();
    /// POV-Ray's description of a token in messages: "undeclared identifier 'pigmnt'", "float constant", "End of File", ...
    std::string describe(const Token& token);

    const ParseOptions& options() const;
    Scene& scene();
    /// Language version in force here, e.g. 3.7; what `version` reads.
    double version() const;
    bool version_stated() const;     ///< by a directive or an option
    bool has_replayed() const;       ///< has a loop or a macro been read, so that places do not tell how much is left?
    bool any_spline() const;         ///< was a spline declared?
    bool version_came_late() const;  ///< the first #version was not the first thing in the scene
    /// #default: the template of new textures and of objects without one.
    TextureLayers& default_texture();
    /// Counts what textures add up to and throws LimitError at `place` where it is too much.
    void count_scene_nodes(const Span& place, std::size_t nodes);
    /// Throws LimitError at the last token if the program takes too much memory.
    void check_memory();
    [[noreturn]] void fail_memory();  ///< the same in any case
    /// Counts objects that become parts of sets, or are placed as such, and throws LimitError at `place` where they are too many.
    void count_parts(const Span& place, std::size_t parts);
    /// The largest `Object::medium` in the scene.
    std::uint32_t& placed_media();
    /// The layers whose size was counted last, null once they were edited.
    struct CountedLayers {
        const void* identity = nullptr;
        std::size_t nodes = 0;
        std::size_t depth = 0;
    };
    CountedLayers& counted_layers();
    bool is_first_use(const TextureLayers& placed);  ///< has no object in the scene had just these layers?

    struct State;  ///< internals (reader_state.h) for directives and expressions

private:
    /// The token that was looked at, and what is known of the one before it. Part of the state, but every token passes here several times.
    struct Cursor {
        Token ahead;
        bool has_ahead = false;
        VariablePtr ahead_variable;  ///< what `ahead` stands for if it is a name; else of no meaning
        Span last;                   ///< of the token taken last
        Word last_word = Word::none;
        bool anything_read = false;  ///< a token or directive other than `#version` came first

        void step() {
            has_ahead = false;
            last = ahead.span;
            last_word = ahead.word;
            anything_read = true;
        }
    };

    void fill();           ///< makes `ahead` the next token, directives carried out
    void take_declared();  ///< takes a name whose value is used

    std::unique_ptr<State> state_;
    Cursor& cursor_;
};

}  // namespace rt
