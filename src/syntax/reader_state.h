// What a Reader holds, shared by the files that carry out directives and evaluate expressions. Not for blocks.
#pragma once

#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "syntax/lexer.h"
#include "syntax/reader.h"

namespace rt {

struct NameHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view name) const { return std::hash<std::string_view>{}(name); }
};
/// What is looked up by its name, without a string of its own for it.
template <typename T>
using ByName = std::unordered_map<std::string, T, NameHash, std::equal_to<>>;

struct Reader::State : Reader::Cursor {
    /// An `#if` that waits for its `#end`.
    struct Conditional {
        Span place;
        bool taken = false;  ///< one of its branches has been read
        bool else_seen = false;
    };

    /// A file being read. `conditionals` is how many were open when it began: it may close no others.
    struct Frame {
        Lexer lexer;
        std::size_t conditionals = 0;
        ByName<Value> locals;  ///< unused by the main file, whose local names are global ones
    };

    struct Deprecation {
        std::string message;
        bool once = false;
    };

    State(Reader& owner, const ParseOptions& parse_options, Scene& target, const MessageSink& sink)
        : reader(owner), options(parse_options), scene(target), messages(sink) {}
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    // --- input (input.cpp)
    void fill();  ///< makes `ahead` the next token, directives carried out
    void next_raw(Token& token) { frames.back().lexer.next(token); }
    void push_file(std::uint32_t file);
    void warn_of_near_choice(const Span& place);
    void include(const Span& place, const std::string& name);
    /// The file that `name` means here: beside the including one, in the current folder, in the library paths, among those installed.
    std::optional<std::uint32_t> find_include(const std::string& name);
    std::optional<std::uint32_t> load(const std::string& path);
    bool leave_frame();  ///< at the end of a file; false if it was the main one
    Token take_name();   ///< the next token, and a macro's name is only a name
    /// `ahead`, at `place`, is a name while macros or deprecated names exist: true if a macro call was read in its stead.
    bool replace_name(const Span& place);

    // --- conditionals.cpp
    void begin_conditional(const Span& place, Word w);
    bool condition(Word w);
    void else_branch(Word w, const Span& place);
    void end_conditional(const Span& place);
    void skip_branches();
    /// Skips from here past the next `#end` (or, if wanted, `#else` or `#elseif`) of this level and says which it was; `open` is the
    /// place of the directive that it ends, `hash` becomes the place of its '#'.
    Word skip_until(const Span& open, bool stop_at_else, Span& hash);

    // --- directives.cpp
    void directive(const Span& hash);
    void include_directive(const Span& place);
    void message_directive(Word w, const Span& place);
    void set_version(const Span& place);
    void skip_loop(Word w, const Span& place);
    void skip_file_directive(Word w, const Span& place);

    // --- declarations.cpp
    void declare(bool local);
    void declare_macro(const Span& place);
    void undefine(const Span& place);
    Value parse_declared_value();
    std::optional<Number> parse_declared_number();
    bool skip_unmodelled_value();
    void end_of_declaration(const Value& value);
    void accept_semicolon();
    std::optional<Deprecation> parse_deprecation();

    // --- fast paths (reader_values.cpp)
    /// Plain literals: the size of the number that was read, 0 if nothing was.
    std::size_t scan_plain(std::span<double> v, bool condition = false);
    /// Takes from `begin` to where the lexer is now as if it were one token that is no word.
    void step_over(std::uint32_t begin);

    // --- nesting
    void enter(const Span& place);
    void leave() { --depth; }

    Span since(const Span& first) const;  ///< from `first` to the token taken last

    Reader& reader;
    const ParseOptions& options;
    Scene& scene;
    const MessageSink& messages;

    const Lexer::NearChoice near_choice = [this](const Span& place) { warn_of_near_choice(place); };
    std::set<std::pair<std::uint32_t, std::uint32_t>> near_choices;  ///< those that were told; a file may be read several times
    std::vector<Frame> frames;
    std::vector<Conditional> conditionals;
    ByName<std::uint32_t> files;  ///< path to index in the scene's sources
    std::size_t includes = 0;

    bool names_only = false;

    std::vector<std::string_view> blocks;  ///< names of those that are open
    int depth = 0;

    ByName<Value> globals;
    ByName<Deprecation> deprecated;
    bool any_macro = false;
    bool any_deprecated = false;

    double version = 3.7;
    bool version_stated = false;
    bool version_late = false;
    TextureLayers default_texture;
    std::size_t scene_nodes = 0;
    CountedLayers counted_layers;
    std::unordered_set<const void*> placed_textures;  ///< the scene's objects keep them alive
    std::vector<std::uint32_t> random_streams;
};

/// Counts one level of nesting while it lives.
class NestingGuard {
public:
    NestingGuard(Reader::State& state, const Span& place) : state_(state) { state_.enter(place); }
    ~NestingGuard() { state_.leave(); }
    NestingGuard(const NestingGuard&) = delete;
    NestingGuard& operator=(const NestingGuard&) = delete;

private:
    Reader::State& state_;
};

}  // namespace rt
