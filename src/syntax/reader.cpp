// The Reader as blocks see it: tokens, blocks, names and messages.
#include "syntax/reader.h"

#include <fmt/format.h>

#include "syntax/reader_state.h"
#include "syntax/word_groups.h"

namespace rt {

namespace {

Value number(double x) { return Number{{x}, 1, false}; }

void predeclare(Reader::State& state) {
    const FrameValues& frame = state.options.frame;
    state.globals.emplace("clock_delta", number(frame.clock_delta));
    state.globals.emplace("final_clock", number(frame.final_clock));
    state.globals.emplace("final_frame", number(frame.final_frame));
    state.globals.emplace("frame_number", number(frame.number));
    state.globals.emplace("initial_clock", number(frame.initial_clock));
    state.globals.emplace("initial_frame", number(frame.initial_frame));
    state.globals.emplace("image_width", number(state.options.image_width));
    state.globals.emplace("image_height", number(state.options.image_height));
    for (const auto& [name, text] : state.options.declares) {
        char* end = nullptr;
        const double x = std::strtod(text.c_str(), &end);
        const bool is_number = !text.empty() && *end == '\0';
        state.globals.insert_or_assign(name, is_number ? number(x) : Value(text));
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
    state_->globals.insert_or_assign("input_file_name", file.name);
    if (file.text.size() > state_->options.max_file_bytes)
        throw LimitError(fmt::format("File '{}' is larger than {} bytes.", file.name, state_->options.max_file_bytes));
    state_->push_file(state_->scene.sources.add(std::move(file)));
}

// --- tokens

void Reader::fill() { state_->fill(); }

bool Reader::accept_at_once(Word w) {
    if (state_->has_ahead) return accept(w);
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
        throw LimitError(scene.sources.describe(place, "Parse Error",
                                                fmt::format("Blocks and parentheses are nested more than {} deep.", options.max_nesting)));
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
    if (!state_->frames.empty()) {
        const ByName<Value>& locals = state_->frames.back().locals;
        if (!locals.empty())
            if (const auto found = locals.find(name); found != locals.end()) return &found->second;
    }
    const auto found = state_->globals.find(name);
    return found == state_->globals.end() ? nullptr : &found->second;
}

// --- messages

void Reader::fail(const Span& span, std::string_view text) { throw SceneError(state_->scene.sources.describe(span, "Parse Error", text)); }

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
bool Reader::version_came_late() const { return state_->version_late; }
TextureLayers& Reader::default_texture() { return state_->default_texture; }

void Reader::count_scene_nodes(const Span& place, std::size_t nodes) {
    const std::size_t most = options().max_scene_nodes;
    state_->scene_nodes += nodes;
    if (state_->scene_nodes > most)
        throw LimitError(scene().sources.describe(
            place, "Parse Error", fmt::format("The textures of the scene have more than {} pigments beyond the first of each.", most)));
}

Reader::CountedLayers& Reader::counted_layers() { return state_->counted_layers; }

bool Reader::is_first_use(const TextureLayers& placed) { return state_->placed_textures.insert(placed.identity()).second; }

Span Reader::State::since(const Span& first) const {
    Span whole = first;
    if (last.file == first.file && last.end > first.end) whole.end = last.end;
    return whole;
}

}  // namespace rt
