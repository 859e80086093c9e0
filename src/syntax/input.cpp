// Where tokens come from: the stack of files, and what is done before a token is seen.
#include <fmt/format.h>

#include <array>
#include <cctype>
#include <filesystem>
#include <tuple>
#include <utility>

#include "syntax/choice_prefix.h"
#include "syntax/expression.h"
#include "syntax/file_text.h"
#include "syntax/reader_state.h"

namespace rt {

namespace {

constexpr std::array installed_includes{"/usr/local/share/povray-3.7/include", "/usr/share/povray-3.7/include"};

std::string folder_of(const std::string& file) { return std::filesystem::path(file).parent_path().string(); }

}  // namespace

void Reader::State::fill() {
    const bool name_only = std::exchange(names_only, false);
    for (;;) {
        next_raw(ahead);
        if (ahead.is('#')) {
            const Span hash = ahead.span;
            if (waiting.active && ends_declaration()) break;
            const auto before = std::pair(last, last_word);
            directive(hash);
            if (has_ahead) return;                                   // the directive looked one token too far
            if (waiting.active) std::tie(last, last_word) = before;  // its tokens are none of the value's
        } else if (ahead.kind == Token::Kind::end) {
            if (leave_frame()) continue;
            ahead.span = last;  // what is missing is missing after the last token, not after the blank lines below it
            break;
        } else if (ahead.kind != Token::Kind::identifier || name_only || !resolve_name()) {
            break;
        }
    }
    has_ahead = true;
}

bool Reader::State::ends_declaration() {
    if (depth != waiting.depth) return false;
    Lexer& lexer = frames.back().lexer;
    const std::uint32_t position = lexer.position();
    Token word;
    lexer.next(word);
    lexer.seek(position);
    switch (word.word) {
        case Word::end:
        case Word::else_:
        case Word::elseif:
        case Word::case_:
        case Word::range:
        case Word::break_:
            return conditionals.size() == waiting.conditionals;
        default:
            return word.kind == Token::Kind::word && conditionals.size() == waiting.conditionals && operand_taken();
    }
}

/// Whether the token that was taken last ends a float, vector, colour or string: then no directive is a part of the value any more.
bool Reader::State::operand_taken() {
    const std::string_view text = scene.sources.file(last.file).text;
    const char end = last.end == 0 ? '\0' : text[last.end - 1];
    if (last_word == Word::none)
        return std::isalnum(static_cast<unsigned char>(end)) || std::string_view("_)>].\"").find(end) != std::string_view::npos;
    return Expression(*this).constant(last_word) || (last.begin > 0 && text[last.begin - 1] == '.');
}

bool Reader::State::raw_next_is(char symbol) {
    Lexer& lexer = frames.back().lexer;
    const std::uint32_t position = lexer.position();
    Token token;
    lexer.next(token);
    lexer.seek(position);
    return token.is(symbol);
}

bool Reader::State::leave_frame() {
    if (may_close()) reader.fail(conditionals.back().place, "End of file reached but #end expected.");
    if (frames.size() == 1) return false;
    --(frames.back().macro ? macros : files_open);
    frames.pop_back();
    names.close_scope();
    return true;
}

void Reader::State::leave_ended_frames(std::size_t frame_count) {
    Token token;
    while (frames.size() > frame_count) {
        Lexer& lexer = frames.back().lexer;
        const std::uint32_t position = lexer.position();
        lexer.next(token);
        if (token.kind != Token::Kind::end) return lexer.seek(position);
        leave_frame();
    }
}

Token Reader::State::take_name() {
    names_only = true;
    const Token name = reader.take();
    names_only = false;  // the token may have been looked at before
    return name;
}

bool Reader::State::resolve_name() {
    if (any_deprecated) warn_if_deprecated(ahead.text, ahead.span);
    ahead_variable = names.find(ahead.text);
    if (!ahead_variable) return false;
    if (std::holds_alternative<MacroValue>(ahead_variable->value)) {
        call_macro(VariablePtr(ahead_variable));
        return true;
    }
    if (!std::holds_alternative<ArrayValue>(ahead_variable->value) || !raw_next_is('[')) return false;
    Token name = ahead;
    const Span before = last;
    const Word word_before = last_word;
    VariablePtr element = parse_subscripts(ahead_variable);
    name.span = since(name.span);
    if (!element) reader.fail(name.span, "Attempt to access uninitialized array element.");
    ahead = name;
    ahead_variable = std::move(element);
    last = before;
    last_word = word_before;
    return false;
}

void Reader::State::warn_if_deprecated(std::string_view name, const Span& place) {
    const auto found = deprecated.find(name);
    if (found == deprecated.end()) return;
    reader.warn(place, found->second.message);
    if (found->second.once) deprecated.erase(found);
}

void Reader::State::push_frame(const Lexer& lexer, bool macro) {
    if (!frames.empty()) {
        names.open_scope();
        ++(macro ? macros : files_open);
    }
    frames.push_back({lexer, conditionals.size(), macro});
}

void Reader::State::warn_of_near_choice(const Span& place) {
    if (!near_choices.insert({place.file, place.begin}).second) return;
    const std::string_view found = std::string_view(scene.sources.file(place.file).text).substr(place.begin, place.end - place.begin);
    reader.warn(place, fmt::format("'{}' begins a plain comment, which chooses nothing; expected '{} key=value'.", found, choice_prefix));
}

void Reader::State::include(const Span& place, const std::string& name) {
    if (files_open >= static_cast<std::size_t>(options.max_include_depth))
        reader.fail_limit(place, fmt::format("Too many nested include files. More than {} are open.", options.max_include_depth),
                          "include-depth");
    if (++includes > options.max_includes)
        reader.fail_limit(place, fmt::format("More than {} files are included.", options.max_includes), "includes");

    std::optional<std::uint32_t> file = find_written(place, name);
    if (!file) file = find_include(name);
    if (!file) {
        reader.warn_possible(place, fmt::format("Cannot find file '{}', even after trying to append file type extension.", name));
        reader.fail(place, fmt::format("Cannot open include file {}.", name));
    }
    count_replay(place, scene.sources.file(*file).text.size());
    push_frame(Lexer(scene.sources, *file, 0, Span::none, &near_choice), false);
}

void Reader::State::include_header() {
    const std::optional<std::uint32_t> file = find_include(options.header);
    if (!file) throw SceneError(fmt::format("File '{0}': Parse Error: Cannot open include header file {0}.", options.header));
    push_frame(Lexer(scene.sources, *file, 0, Span::none, &near_choice), false);
}

std::vector<std::string> Reader::State::search_folders() const {
    std::vector<std::string> folders{"", folder_of(scene.sources.file(frames.back().lexer.file()).name)};
    folders.insert(folders.end(), options.library_paths.begin(), options.library_paths.end());
    if (!options.read_include) folders.insert(folders.end(), installed_includes.begin(), installed_includes.end());
    return folders;
}

std::optional<PictureFile> Reader::find_picture(std::string_view name, std::span<const std::string_view> extensions) {
    if (!state_->options.read_picture) return std::nullopt;
    for (const std::string& folder : state_->search_folders()) {
        const std::string path = (std::filesystem::path(folder) / name).string();
        if (auto found = state_->options.read_picture(path)) return found;
        for (const std::string_view extension : extensions)
            if (auto found = state_->options.read_picture(path + std::string(extension))) return found;
    }
    return std::nullopt;
}

std::optional<std::uint32_t> Reader::State::find_include(const std::string& name) {
    for (const std::string& folder : search_folders())
        for (const char* extension : {"", ".inc"})
            if (const auto file = load((std::filesystem::path(folder) / (name + extension)).string())) return file;
    return std::nullopt;
}

bool Reader::State::has_file(const std::string& name) const {
    for (const std::string& folder : search_folders()) {
        const std::filesystem::path path = std::filesystem::path(folder) / name;
        std::error_code none;
        if (options.read_include ? options.read_include(path.string()).has_value() : std::filesystem::is_regular_file(path, none))
            return true;
    }
    return false;
}

std::optional<std::string> Reader::read_file(const std::string& name, std::initializer_list<const char*> extensions) {
    const ParseOptions& options = state_->options;
    for (const std::string& folder : state_->search_folders()) {
        for (const char* extension : extensions) {
            const std::string path = (std::filesystem::path(folder) / (name + extension)).string();
            if (auto bytes = options.read_include ? options.read_include(path) : read_file_text(path, options.max_file_bytes)) return bytes;
        }
    }
    return std::nullopt;
}

std::optional<std::uint32_t> Reader::State::load(const std::string& path) {
    if (const auto found = files.find(path); found != files.end()) return found->second;
    auto text = options.read_include ? options.read_include(path) : read_file_text(path, options.max_file_bytes);
    if (!text) return std::nullopt;
    const std::uint32_t file = scene.sources.add({path, std::move(*text)});
    files.emplace(path, file);
    return file;
}

}  // namespace rt
