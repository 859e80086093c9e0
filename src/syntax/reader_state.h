// What a Reader holds, shared by the files that carry out directives and evaluate expressions. Not for blocks.
#pragma once

#include <map>
#include <set>
#include <unordered_set>
#include <utility>
#include <vector>

#include "syntax/lexer.h"
#include "syntax/names.h"
#include "syntax/reader.h"

namespace rt {

struct Reader::State : Reader::Cursor {
    /// What waits for its `#end`.
    struct Conditional {
        enum class Kind : std::uint8_t { branch, while_loop, for_loop, choice };
        Span place;
        Kind kind = Kind::branch;
        bool taken = false;  ///< one of its branches has been read
        bool else_seen = false;
        std::uint32_t again = 0;     ///< where a loop goes back to: a while loop to its condition
        double value = 0.0;          ///< of `#switch`
        double last = 0.0;           ///< of `#for`
        double step = 0.0;           ///< likewise
        std::string_view counter{};  ///< likewise
        std::size_t scope = 0;       ///< likewise, its counter's
    };

    /// A file or the body of a macro being read. `conditionals` is how many were open when it began: it may close no others. Each but the
    /// main file has a scope of its own.
    struct Frame {
        Lexer lexer;
        std::size_t conditionals = 0;
        bool macro = false;
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
    void push_frame(const Lexer& lexer, bool macro);
    void warn_of_near_choice(const Span& place);
    void include(const Span& place, const std::string& name);
    void include_header();  ///< the file that is read before the scene
    /// The file that `name` means here: beside the including one, in the current folder, in the library paths, among those installed.
    std::optional<std::uint32_t> find_include(const std::string& name);
    /// Whether there is a file of just that name where included files are looked for; it is not read.
    bool has_file(const std::string& name) const;
    std::vector<std::string> search_folders() const;  ///< in which a file is looked for that the current one names
    std::optional<std::uint32_t> load(const std::string& path);
    bool leave_frame();  ///< at the end of a file or macro; false if it was the main file
    /// Leaves what has ended as long as it is nested deeper than `frame_count` frames.
    void leave_ended_frames(std::size_t frame_count);
    Token take_name();  ///< the next token, and a macro's name is only a name
    /// `ahead` is a name: finds what it stands for. True if it was a macro's, whose body is what comes next.
    bool resolve_name();
    void warn_if_deprecated(std::string_view name, const Span& place);
    /// True if `symbol` is what the innermost text goes on with; nothing is taken.
    bool raw_next_is(char symbol);
    /// True where a directive ends what a declaration waits for, and so has to wait for the declaration; `ahead` then stands for it.
    bool ends_declaration();
    bool operand_taken();
    /// The directive that ended a value is carried out now.
    void resume_directive();

    // --- conditionals.cpp
    void begin_conditional(const Span& place, Word w);
    bool condition(Word w);
    bool is_declared(const Token& name);
    void else_branch(Word w, const Span& place);
    void end_conditional(const Span& place);
    void skip_branches();
    bool may_close() const { return conditionals.size() > frames.back().conditionals; }
    /// What a skipped level may end at besides `#end`.
    enum class Stops : std::uint8_t { end_only, branches, cases };
    /// Skips from here past the next `#end` (or another stop that is asked for) of this level and says which it was; `open` is the place
    /// of the directive that it ends, `hash` becomes the place of its '#'.
    Word skip_until(const Span& open, Stops stops, Span& hash);

    // --- loops.cpp
    void begin_while(const Span& place);
    void begin_for(const Span& place);
    void repeat_while();
    void repeat_for();
    void leave_loop(const Span& place);  ///< `#break`
    /// Fails if what was read in parentheses did not end in the text it began in.
    void require_same_text(const Span& place, std::size_t frame_count, std::size_t conditional_count);
    /// Counts text that is read again; throws LimitError where it is too much or memory runs out.
    void count_replay(const Span& place, std::size_t bytes);
    void check_memory(const Span& place);
    [[noreturn]] void fail_memory(const Span& place);
    /// A copy that shares nothing with `value`; what it costs is counted.
    Value copy_of(const Span& place, const Value& value);
    /// Fails where arrays lie too deep in each other, counting those `around` this one.
    ArrayExtent extent_of(const Span& place, const ArrayValue& array, std::size_t around = 0);

    // --- switch.cpp
    void begin_switch(const Span& place);
    void find_case(Word first);
    bool case_holds(Word w);
    void pass_case(Word w, const Span& place);

    // --- directives.cpp
    void directive(const Span& hash);
    void include_directive(const Span& place);
    void message_directive(Word w, const Span& place);
    void set_version(const Span& place);

    // --- declarations.cpp
    void declare(bool local);
    /// The value and what may follow it; features that it lacks are kept with it.
    void parse_declaration(Variable& into);
    void require_redeclarable(const Token& name, const Value& before);
    void undefine(const Span& place);
    /// The value is new: features that it lacks are put into `missing`.
    Value parse_declared_value(std::vector<Unmodelled>& missing);
    std::optional<Number> parse_declared_number();
    void end_of_declaration(const Value& value, std::size_t frame_count);
    void accept_semicolon(std::size_t frame_count);
    std::optional<Deprecation> parse_deprecation();

    // --- macros.cpp
    void declare_macro(const Span& place);
    void call_macro(const VariablePtr& called);
    bool is_no_macro(const Token& name) const;
    std::vector<VariablePtr> parse_arguments(const MacroValue& macro, const Span& place);
    VariablePtr parse_argument(std::size_t frame_count);

    // --- arrays.cpp
    ArrayValue parse_array();
    void parse_elements(ArrayValue& array, std::size_t dimension, std::size_t& next);
    /// Reads `[i][j]`... as long as what comes next is a subscript of an array: the element, null if it was never set.
    VariablePtr parse_subscripts(VariablePtr variable);
    std::size_t parse_index(const Variable& variable);
    void set_element(const Span& place, ArrayValue& array, std::size_t index, VariablePtr value);
    void declare_element(const Token& name, VariablePtr variable);

    // --- parse_function.cpp, parse_spline.cpp
    Value parse_function(const Span& place);
    Value parse_built_in(const Span& place);
    std::vector<std::string_view> parse_parameters();
    std::shared_ptr<const Spline> parse_spline();
    /// The function itself, or one in its place that can answer.
    std::shared_ptr<const Function> answering_function(const std::shared_ptr<const Function>& stated, const Span& place);

    // --- user_files.cpp
    void file_directive(Word w, const Span& place);
    void open_file(const Span& place);
    void close_file();
    void read_file(const Span& place);
    void write_file(const Span& place);
    std::shared_ptr<OpenFile> parse_handle(Token& handle);
    void begin_writing(const Span& place, const std::string& name, const std::string& path, bool append);
    std::string written_path(const std::string& name) const;
    std::optional<std::uint32_t> find_written(const Span& place, const std::string& name);
    std::optional<std::uint32_t> find_user_file(const Span& place, const std::string& name);
    void count_written(const Span& place, std::size_t bytes);

    // --- fast paths (reader_values.cpp)
    /// Plain literals: the size of the number that was read, 0 if nothing was.
    std::size_t scan_plain(std::span<double> v, bool condition = false);
    /// Takes from `begin` to where the lexer is now as if it were one token that is no word.
    void step_over(std::uint32_t begin);

    // --- nesting
    void enter(const Span& place);
    void leave() { --depth; }
    void enter_directive(const Span& place);
    void require_stack(const Span& place);

    /// Reports what the variable's value lacks.
    void report_missing(const VariablePtr& used);

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

    Names names;
    ByName<Deprecation> deprecated;
    bool any_deprecated = false;
    bool any_spline = false;
    std::vector<Unmodelled>* missing = nullptr;                  ///< of the value that is being declared; reported at once where it is null
    std::set<std::pair<std::uint32_t, std::uint32_t>> reported;  ///< places of what is not modelled: text may be read several times
    VariablePtr used;                                            ///< whose value was taken last

    /// What a declaration that waits for its end had open when its value began.
    struct Waiting {
        bool active = false;
        std::size_t conditionals = 0;
        int depth = 0;
    };
    Waiting waiting;
    int directives = 0;          ///< how deep directives are nested in each other
    std::size_t macros = 0;      ///< likewise macro calls
    std::size_t files_open = 0;  ///< likewise files
    std::uint64_t replayed = 0;
    std::uint32_t replays = 0;
    ByName<std::string> written;  ///< what `#write` made of files, by path
    std::size_t written_bytes = 0;

    double version = 3.7;
    bool version_stated = false;
    bool version_late = false;
    TextureLayers default_texture;
    std::size_t scene_nodes = 0;
    std::size_t set_parts = 0;
    std::uint32_t placed_media = 0;
    CountedLayers counted_layers;
    std::unordered_set<const void*> placed_textures;  ///< the scene's objects keep them alive
    /// Functions that ask patterns, with those that can answer; of pigments, by what they ask, a function whose first source it is.
    std::map<std::shared_ptr<const Function>, std::shared_ptr<const Function>> answering;
    std::map<std::shared_ptr<const FunctionSource>, std::shared_ptr<const Function>> answering_pigments;
    std::vector<std::uint32_t> random_streams;
};

/// Counts one level of blocks and parentheses while it lives.
class NestingGuard {
public:
    NestingGuard(Reader::State& state, const Span& place) : state_(state) { state_.enter(place); }
    ~NestingGuard() { state_.leave(); }
    NestingGuard(const NestingGuard&) = delete;
    NestingGuard& operator=(const NestingGuard&) = delete;

private:
    Reader::State& state_;
};

/// Counts one directive inside another while it lives. What a declaration waits for is none of the inner one's business.
class DirectiveGuard {
public:
    DirectiveGuard(Reader::State& state, const Span& place) : state_(state), waiting_(std::exchange(state.waiting, {})) {
        state_.enter_directive(place);
    }
    ~DirectiveGuard() {
        --state_.directives;
        state_.waiting = waiting_;
    }
    DirectiveGuard(const DirectiveGuard&) = delete;
    DirectiveGuard& operator=(const DirectiveGuard&) = delete;

private:
    Reader::State& state_;
    Reader::State::Waiting waiting_;
};

/// Keeps a value that is set while it lives.
template <typename T>
class Restore {
public:
    Restore(T& value, T meanwhile) : value_(value), before_(std::exchange(value, std::move(meanwhile))) {}
    ~Restore() { value_ = std::move(before_); }
    Restore(const Restore&) = delete;
    Restore& operator=(const Restore&) = delete;

private:
    T& value_;
    T before_;
};

}  // namespace rt
