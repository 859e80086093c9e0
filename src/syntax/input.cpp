// Where tokens come from: the stack of files, and what is done before a token is seen.
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <utility>

#include "syntax/choice_prefix.h"
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
            directive(hash);
            if (has_ahead) return;  // the directive looked one token too far
        } else if (ahead.kind == Token::Kind::end) {
            if (leave_frame()) continue;
            ahead.span = last;  // what is missing is missing after the last token, not after the blank lines below it
            break;
        } else if (ahead.kind != Token::Kind::identifier || name_only || !(any_macro || any_deprecated) || !replace_name(ahead.span)) {
            break;
        }
    }
    has_ahead = true;
}

bool Reader::State::leave_frame() {
    if (conditionals.size() > frames.back().conditionals) reader.fail(conditionals.back().place, "End of file reached but #end expected.");
    if (frames.size() == 1) return false;
    frames.pop_back();
    return true;
}

Token Reader::State::take_name() {
    names_only = true;
    return reader.take();
}

bool Reader::State::replace_name(const Span& place) {
    const std::string_view name = ahead.text;
    if (const auto found = deprecated.find(name); found != deprecated.end()) {
        reader.warn(place, found->second.message);
        if (found->second.once) deprecated.erase(found);
    }
    const Value* const value = reader.find(name);
    if (!value || !std::holds_alternative<MacroValue>(*value)) return false;
    reader.unmodelled(place, fmt::format("macro call {}()", name));
    next_raw(ahead);
    if (!ahead.is('(')) reader.fail(ahead.span, fmt::format("Expected '(', {} found instead", reader.describe(ahead)));
    for (std::size_t depth = 1; depth != 0;) {
        next_raw(ahead);
        if (ahead.is('(')) ++depth;
        if (ahead.is(')')) --depth;
        if (ahead.kind == Token::Kind::end) reader.fail(ahead.span, "Expected ')', End of File found instead");
    }
    return true;
}

void Reader::State::push_file(std::uint32_t file) {
    frames.push_back({Lexer(scene.sources, file, 0, Span::none, &near_choice), conditionals.size(), {}});
}

void Reader::State::warn_of_near_choice(const Span& place) {
    if (!near_choices.insert({place.file, place.begin}).second) return;
    const std::string_view found = std::string_view(scene.sources.file(place.file).text).substr(place.begin, place.end - place.begin);
    reader.warn(place, fmt::format("'{}' begins a plain comment, which chooses nothing; expected '{} key=value'.", found, choice_prefix));
}

void Reader::State::include(const Span& place, const std::string& name) {
    if (frames.size() > static_cast<std::size_t>(options.max_include_depth)) reader.fail(place, "Too many nested include files.");
    if (++includes > options.max_includes)
        throw LimitError(
            scene.sources.describe(place, "Parse Error", fmt::format("More than {} files are included.", options.max_includes)));

    const std::optional<std::uint32_t> file = find_include(name);
    if (!file) {
        reader.warn_possible(place, fmt::format("Cannot find file '{}', even after trying to append file type extension.", name));
        reader.fail(place, fmt::format("Cannot open include file {}.", name));
    }
    push_file(*file);
}

std::optional<std::uint32_t> Reader::State::find_include(const std::string& name) {
    std::vector<std::string> folders{folder_of(scene.sources.file(frames.back().lexer.file()).name), ""};
    folders.insert(folders.end(), options.library_paths.begin(), options.library_paths.end());
    if (!options.read_include) folders.insert(folders.end(), installed_includes.begin(), installed_includes.end());
    for (const std::string& folder : folders)
        for (const char* extension : {"", ".inc"})
            if (const auto file = load((std::filesystem::path(folder) / (name + extension)).string())) return file;
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
