// The Reader as blocks see it: tokens, blocks, names and messages.
#include "syntax/reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "syntax/limits.h"
#include "syntax/reader_state.h"
#include "syntax/word_groups.h"

namespace rt {

namespace {

constexpr std::size_t many_objects = 1000;  ///< whose copies may take so much memory that it is looked at
constexpr std::size_t max_missing = 1000;   ///< places in one declared value; what is met in the same loop again is one place

Value float_value(double x) { return Number{{x}, 1, false}; }

void predeclare(Reader::State& state) {
    const auto set = [&state](std::string_view name, double x) { state.names.bind(0, name, make_variable(float_value(x))); };
    const FrameValues& frame = state.options.frame;
    set("clock_delta", frame.clock_delta);
    set("final_clock", frame.final_clock);
    set("final_frame", frame.final_frame);
    set("frame_number", frame.number);
    set("initial_clock", frame.initial_clock);
    set("initial_frame", frame.initial_frame);
    set("image_width", state.options.image_width);
    set("image_height", state.options.image_height);
    for (const auto& [name, text] : state.options.declares) {
        char* end = nullptr;
        const double x = std::strtod(text.c_str(), &end);
        const bool is_number = !text.empty() && *end == '\0';
        state.names.bind(0, name, make_variable(is_number ? float_value(x) : Value(text)));
    }
}

}  // namespace

Reader::Reader(const ParseOptions& options, Scene& scene, const MessageSink& messages)
    : state_(std::make_unique<State>(*this, options, scene, messages)), cursor_(*state_) {
    state_->default_texture = std::vector<Texture>{{PlainTexture{{}, options.default_finish}}};
    if (options.version > 0.0) {
        state_->version = options.version;
        state_->version_stated = true;
        scene.language_version = options.version;
    }
    predeclare(*state_);
}

Reader::~Reader() = default;

void Reader::open(SourceFile file) {
    state_->names.bind(0, "input_file_name", make_variable(file.name));
    if (file.text.size() > state_->options.max_file_bytes)
        throw LimitError(
            fmt::format("File '{}' is larger than {} bytes.{}", file.name, state_->options.max_file_bytes, allow_more("file")));
    const std::uint32_t index = state_->scene.sources.add(std::move(file));
    state_->push_frame(Lexer(state_->scene.sources, index, 0, Span::none, &state_->near_choice), false);
    if (!state_->options.header.empty()) state_->include_header();
}

// --- tokens

void Reader::fill() { state_->fill(); }

bool Reader::accept_at_once(Word w) {
    if (state_->has_ahead) return accept(w);
    state_->leave_ended_frames(1);
    Lexer& lexer = state_->frames.back().lexer;
    const std::uint32_t position = lexer.position();
    Token token;
    lexer.next(token);
    lexer.seek(position);
    return token.is(w) && accept(w);
}

void Reader::expect(char symbol) {
    const Token& token = peek();
    if (token.is(symbol)) {
        take();
    } else if (symbol == '}' && !state_->blocks.empty()) {
        fail(token.span, fmt::format("No matching }} in '{}', {} found instead", state_->blocks.back(), describe(token)));
    } else if (symbol == '{' && state_->last_word != Word::none) {
        fail(token.span, fmt::format("Missing {{ after '{}', {} found instead", message_name(state_->last_word), describe(token)));
    } else {
        fail_expected(std::string_view(&symbol, 1));
    }
}

// --- blocks

void Reader::begin_block(std::string_view name) {
    const Token& token = peek();
    if (!token.is('{')) fail(token.span, fmt::format("Missing {{ after '{}', {} found instead", name, describe(token)));
    state_->enter(token.span);
    take();
    state_->blocks.push_back(name);
}

void Reader::end_block() {
    expect('}');
    state_->blocks.pop_back();
    state_->leave();
}

void Reader::State::enter(const Span& place) {
    if (++depth > options.max_nesting)
        reader.fail_limit(place, fmt::format("Blocks and parentheses are nested more than {} deep.", options.max_nesting), "nesting");
    require_stack(place);
}

void Reader::State::enter_directive(const Span& place) {
    if (++directives > options.max_directive_nesting)
        reader.fail_limit(place, fmt::format("Directives stand inside each other more than {} deep.", options.max_directive_nesting),
                          "directive-nesting");
    require_stack(place);
}

void Reader::State::require_stack(const Span& place) {
    if (!stack_is_low()) return;
    const std::string text =
        fmt::format("The stack is too small for {} directives and {} blocks inside each other. A larger one (ulimit -s) allows more.",
                    directives, depth);
    reader.fail_limit(place, text, "");
}

void Reader::skip_block() {
    const Span open = peek().span;
    expect('{');
    for (std::size_t depth = 1; depth != 0;) {
        const Token token = take();
        if (token.is('{')) ++depth;
        if (token.is('}')) --depth;
        if (token.kind == Token::Kind::end) fail(open, "No matching } for this {, End of File found instead");
    }
}

// --- names

const Value* Reader::find(std::string_view name) const {
    if (cursor_.has_ahead && cursor_.ahead.text.data() == name.data())  // its subscripts are part of it
        return cursor_.ahead_variable ? &cursor_.ahead_variable->value : nullptr;
    const VariablePtr& variable = state_->names.find(name);
    return variable ? &variable->value : nullptr;
}

std::optional<Value> Reader::accept_any_declared() {
    if (!next_value()) return std::nullopt;
    const Span place = peek().span;
    take_declared();
    return state_->copy_of(place, state_->used->value);
}

Value Reader::State::copy_of(const Span& place, const Value& value) {
    if (const auto* array = std::get_if<ArrayValue>(&value)) {
        const ArrayExtent extent = extent_of(place, *array);
        count_replay(place, (extent.depth == 1 ? 16 : 128) * extent.elements);
    }
    Value copy = value;
    own_elements(copy);
    return copy;
}

void Reader::take_declared() {
    state_->used = cursor_.ahead_variable;
    cursor_.step();
    const auto* const object = std::get_if<ObjectValue>(&state_->used->value);
    if (object && object->set && (*object->set)->parts.objects.size() > many_objects) state_->check_memory(cursor_.last);
    if (!state_->used->missing.empty()) state_->report_missing(VariablePtr(state_->used));
}

void Reader::State::report_missing(const VariablePtr& variable) {
    for (const Unmodelled& feature : variable->missing) reader.unmodelled(feature.span, feature.feature);
    if (!missing) variable->missing.clear();  // told once
}

// --- messages

void Reader::fail(const Span& span, std::string_view text) { throw SceneError(state_->scene.sources.describe(span, "Parse Error", text)); }

void Reader::fail_limit(const Span& span, std::string_view text, std::string_view limit) {
    const std::string more = limit.empty() ? "" : allow_more(limit);
    throw LimitError(state_->scene.sources.describe(span, "Parse Error", fmt::format("{}{}", text, more)));
}

void Reader::fail_expected(std::string_view what) {
    const Token& token = peek();
    fail(token.span, fmt::format("Expected '{}', {} found instead", what, describe(token)));
}

void Reader::warn(const Span& span, std::string_view text) {
    state_->messages(state_->scene.sources.describe(span, "Parse Warning", text));
}

void Reader::warn_possible(const Span& span, std::string_view text) {
    state_->messages(state_->scene.sources.describe(span, "Possible Parse Error", text));
}

void Reader::unmodelled(const Span& span, std::string_view feature) {
    if (state_->missing) {
        std::vector<Unmodelled>& lacking = *state_->missing;
        const auto known = [&](const Unmodelled& u) { return u.span == span && u.feature == feature; };
        if (lacking.size() < max_missing && std::none_of(lacking.begin(), lacking.end(), known))
            lacking.push_back({std::string(feature), span});
        return;
    }
    if ((state_->options.collect_unmodelled || state_->options.lenient) && !state_->reported.insert({span.file, span.begin}).second) return;
    if (state_->options.collect_unmodelled) {
        state_->scene.unmodelled.push_back({std::string(feature), span});
    } else if (state_->options.lenient) {
        warn(span, fmt::format("'{}' is not modelled and is ignored.", feature));
    } else {
        fail(span, fmt::format("'{}' is not modelled.", feature));
    }
}

// --- state

const ParseOptions& Reader::options() const { return state_->options; }
Scene& Reader::scene() { return state_->scene; }
double Reader::version() const { return state_->version; }
bool Reader::version_stated() const { return state_->version_stated; }
bool Reader::has_replayed() const { return state_->replayed != 0; }
bool Reader::any_spline() const { return state_->any_spline; }
bool Reader::version_came_late() const { return state_->version_late; }
TextureLayers& Reader::default_texture() { return state_->default_texture; }

void Reader::count_scene_nodes(const Span& place, std::size_t nodes) {
    const std::size_t most = options().max_scene_nodes;
    state_->scene_nodes += nodes;
    if (state_->scene_nodes > most)
        fail_limit(place, fmt::format("The textures of the scene have more than {} pigments beyond the first of each.", most), "textures");
}

void Reader::check_memory() { state_->check_memory(last_place()); }
void Reader::fail_memory() { state_->fail_memory(last_place()); }

void Reader::count_parts(const Span& place, std::size_t parts) {
    const std::size_t most = options().max_set_parts;
    state_->set_parts += parts;
    if (state_->set_parts > most) fail_limit(place, fmt::format("The sets of objects have more than {} parts in all.", most), "parts");
}

std::uint32_t& Reader::placed_media() { return state_->placed_media; }

Reader::CountedLayers& Reader::counted_layers() { return state_->counted_layers; }

bool Reader::is_first_use(const TextureLayers& placed) { return state_->placed_textures.insert(placed.identity()).second; }

Span Reader::State::since(const Span& first) const {
    Span whole = first;
    if (last.file == first.file && last.end > first.end) whole.end = last.end;
    return whole;
}

}  // namespace rt
