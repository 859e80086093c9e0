// #fopen, #read, #write, #fclose: numbers, vectors and strings from files beside the scene. No file is ever written: what a scene writes is
// kept in memory for what it reads and includes later.
#include "syntax/user_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "syntax/expression.h"
#include "syntax/file_text.h"
#include "syntax/reader_state.h"

namespace rt {

namespace {

/// Whether `path` lies in `folder` or below, links followed.
bool is_below(const std::filesystem::path& path, const std::filesystem::path& folder) {
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::weakly_canonical(path, error);
    const std::filesystem::path root = std::filesystem::weakly_canonical(folder.empty() ? "." : folder, error);
    return !error && std::mismatch(root.begin(), root.end(), whole.begin(), whole.end()).first == root.end();
}

/// Each float as `%g` of the C library writes it, a blank behind a vector.
std::string text_of(const Number& n) {
    if (n.size == 1) return fmt::format("{:g}", n.v[0]);
    return fmt::format("<{:g}> ", fmt::join(n.v.begin(), n.v.begin() + n.size, ","));
}

/// One value of a file that is read: a float with its sign, a vector of such, or a string.
class FileReader {
public:
    FileReader(Reader& reader, Lexer& lexer) : reader_(reader), lexer_(lexer) { next(); }

    bool at_end() const { return token_.kind == Token::Kind::end; }

    /// With the comma behind it.
    Value value() {
        Value result = token_.kind == Token::Kind::string ? Value(string())
                       : token_.is('<')                   ? Value(vector())
                                                          : Value(Number{{number()}, 1, false});
        skip_comma();
        return result;
    }

    /// Gives back what was looked at.
    void leave() { lexer_.seek(token_.span.begin); }

private:
    void next() { lexer_.next(token_); }

    void skip_comma() {
        if (token_.is(',')) next();
    }

    std::string string() {
        const std::string text = unescaped(reader_, token_);
        next();
        return text;
    }

    double number() {
        const bool negative = token_.is('-');
        if (negative || token_.is('+')) next();
        if (token_.kind != Token::Kind::number) fail("float, vector, or string literal");
        const double x = token_.number;
        next();
        return negative ? -x : x;
    }

    Number vector() {
        next();
        Number result;
        for (result.size = 0; result.size < 5 && !token_.is('>'); ++result.size) {
            result.v[result.size] = number();
            skip_comma();
        }
        if (result.size < 2 || !token_.is('>')) fail("vector");
        next();
        return result;
    }

    [[noreturn]] void fail(std::string_view what) {
        reader_.fail(token_.span, fmt::format("Expected '{}', {} found instead", what, reader_.describe(token_)));
    }

    Reader& reader_;
    Lexer& lexer_;
    Token token_;
};

/// Of whole numbers that are written as bytes.
bool is_integer_format(Word w) {
    switch (w) {
        case Word::sint8:
        case Word::uint8:
        case Word::sint16be:
        case Word::sint16le:
        case Word::uint16be:
        case Word::uint16le:
        case Word::sint32be:
        case Word::sint32le:
            return true;
        default:
            return false;
    }
}

}  // namespace

void Reader::State::file_directive(Word w, const Span& place) {
    if (w == Word::fopen) return open_file(place);
    if (w == Word::fclose) return close_file();
    if (w == Word::read) return read_file(place);
    write_file(place);
}

/// #fopen Handle "name" read | write | append
void Reader::State::open_file(const Span& place) {
    const Token handle = take_name();
    if (handle.kind != Token::Kind::identifier)
        reader.fail(handle.span, fmt::format("Expected 'undeclared identifier', {} found instead", reader.describe(handle)));
    const std::string name = reader.parse_string();
    const auto file = std::make_shared<OpenFile>();
    file->name = name;
    if (reader.accept(Word::read)) {
        const std::optional<std::uint32_t> index = find_user_file(place, name);
        if (!index) {
            reader.warn_possible(since(place),
                                 fmt::format("Cannot find file '{}', even after trying to append file type extension.", name));
            reader.fail(since(place), fmt::format("Cannot open user file {} (read).", name));
        }
        file->lexer.emplace(scene.sources, *index);
    } else if (reader.peek().is(Word::write) || reader.peek().is(Word::append)) {
        file->path = written_path(name);
        begin_writing(since(place), name, file->path, reader.take().is(Word::append));
    } else {
        reader.fail_expected("read or write");
    }
    names.bind(0, handle.text, make_variable(FileValue{file}));
}

/// What is there before is kept to append to it.
void Reader::State::begin_writing(const Span& place, const std::string& name, const std::string& path, bool append) {
    if (const auto found = written.find(path); found != written.end()) {
        if (!append) found->second.clear();
        return;
    }
    reader.warn(place, fmt::format("What is written to '{}' is kept in memory: the scene can read and include it, no file is made.", name));
    const std::optional<std::uint32_t> before = append ? find_user_file(place, name) : std::nullopt;
    written.emplace(path, before ? scene.sources.file(*before).text : std::string());
}

std::string Reader::State::written_path(const std::string& name) const {
    const std::string& scene_file = scene.sources.file(frames.front().lexer.file()).name;
    return std::filesystem::path(scene_file).replace_filename(name).lexically_normal().string();
}

std::optional<std::uint32_t> Reader::State::find_written(const Span& place, const std::string& name) {
    const auto found = written.find(written_path(name));
    if (found == written.end()) return std::nullopt;
    count_written(place, found->second.size());
    return scene.sources.add({found->first, found->second});
}

/// Only what lies below the scene's folder or one of the library paths is read.
std::optional<std::uint32_t> Reader::State::find_user_file(const Span& place, const std::string& name) {
    if (const auto file = find_written(place, name)) return file;
    const auto file = find_include(name);
    if (!file || options.read_include) return file;
    const std::string path = scene.sources.file(*file).name;
    const auto allows = [&](const std::filesystem::path& folder) { return is_below(path, folder); };
    const bool beside = allows(std::filesystem::path(scene.sources.file(frames.front().lexer.file()).name).parent_path());
    if (!beside && std::none_of(options.library_paths.begin(), options.library_paths.end(), allows))
        reader.fail(since(place), fmt::format("File '{}' is neither below the scene's folder nor below a library path.", name));
    return file;
}

/// What is written, and the copies of it that are read.
void Reader::State::count_written(const Span& place, std::size_t bytes) {
    written_bytes += bytes;
    if (written_bytes > options.max_written_bytes)
        reader.fail_limit(since(place), fmt::format("The scene writes more than {} bytes.", options.max_written_bytes), "written");
}

void Reader::State::close_file() {
    const Token handle = take_name();
    const VariablePtr& variable = names.find(handle.text);
    if (variable && std::holds_alternative<FileValue>(variable->value)) names.unbind(handle.text);
}

/// The '(' and the handle of `#read` and `#write`; `handle` is the handle's name.
std::shared_ptr<OpenFile> Reader::State::parse_handle(Token& handle) {
    reader.expect('(');
    handle = take_name();
    const VariablePtr variable = handle.kind == Token::Kind::identifier ? names.find(handle.text) : nullptr;
    const auto* const value = variable ? std::get_if<FileValue>(&variable->value) : nullptr;
    if (!value) reader.fail(handle.span, fmt::format("Expected 'file identifier', {} found instead", reader.describe(handle)));
    return value->file;
}

/// #read(Handle, Name, ...): at the end of the file the handle is undefined, and so are the names for which nothing was left.
void Reader::State::read_file(const Span& place) {
    Token handle;
    const std::shared_ptr<OpenFile> file = parse_handle(handle);
    if (!file->lexer)
        reader.fail(since(place), fmt::format("Cannot read from file {} because the file is open for writing only.", file->name));
    names_only = true;
    for (reader.accept_comma(); !reader.accept(')'); names_only = true, reader.accept_comma()) {
        const Token name = take_name();
        if (name.kind != Token::Kind::identifier)
            reader.fail(name.span, fmt::format("Expected 'undeclared identifier', {} found instead", reader.describe(name)));
        const VariablePtr known = names.find(name.text);
        if (known) require_redeclarable(name, known->value);
        std::optional<std::size_t> index;
        if (known && std::holds_alternative<ArrayValue>(known->value) && raw_next_is('[')) index = parse_index(*known);
        FileReader input(reader, *file->lexer);
        if (input.at_end()) {
            names.unbind(handle.text);
            continue;
        }
        const VariablePtr value = make_variable(input.value());
        if (input.at_end()) names.unbind(handle.text);
        input.leave();
        if (index)
            set_element(name.span, std::get<ArrayValue>(known->value), *index, value);
        else if (known)
            *known = std::move(*value);
        else
            names.bind(0, name.text, value);
    }
}

/// #write(Handle, value, ...): floats and vectors with six digits, a blank behind each vector.
void Reader::State::write_file(const Span& place) {
    Token handle;
    const std::shared_ptr<OpenFile> file = parse_handle(handle);
    if (file->lexer)
        reader.fail(since(place), fmt::format("Cannot write to file {} because the file is open for reading only.", file->name));
    for (reader.accept_comma(); !reader.accept(')'); reader.accept_comma()) {
        std::string text;
        if (at_string(reader)) {
            text = reader.parse_string();
        } else if (is_integer_format(reader.peek().word)) {
            const Token format = reader.take();
            reader.unmodelled(format.span, fmt::format("#write of {}", rt::text(format.word)));
            Expression(*this).sum();
        } else if (reader.at_expression()) {
            text = text_of(Expression(*this).sum());
        } else {
            reader.fail_expected("string");
        }
        count_written(place, text.size());
        written[file->path] += text;
    }
}

}  // namespace rt
