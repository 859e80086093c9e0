// Scene text with places in it: files, spans, excerpts with a caret, and the one error type of the program.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// One file that was read, whole. `name` is as the user or the including file wrote it.
struct SourceFile {
    std::string name;
    std::string text;
};

/// A piece of a source file: bytes [begin, end) of file `file` in a `Sources`. `file == none` means "no place".
struct Span {
    static constexpr std::uint32_t none = 0xffffffffu;
    std::uint32_t file = none;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    bool operator==(const Span&) const = default;
};

/// Line and column, both counted from 1; the column counts bytes.
struct LineColumn {
    std::size_t line = 1;
    std::size_t column = 1;
};

/// Every file of one scene. Files never move or change once added, so views into them stay valid.
class Sources {
public:
    std::uint32_t add(SourceFile file);
    std::size_t size() const { return files_.size(); }
    const SourceFile& file(std::uint32_t index) const { return files_[index]->source; }
    LineColumn locate(std::uint32_t file, std::size_t offset) const;

    /// POV-Ray's line, which editors parse, then the excerpt and a caret under the span:
    ///     File 'scene.pov' line 12: Parse Error: text
    ///       12 | the source line
    ///          |     ^^^^
    /// Without a place only "Parse Error: text". Long lines are cut around the caret; control bytes are shown as '?'. No final newline.
    std::string describe(const Span& span, std::string_view kind, std::string_view text) const;

private:
    struct Entry {
        SourceFile source;
        mutable std::once_flag lines_counted;
        mutable std::vector<std::size_t> line_begins;  ///< made on the first message: a file can give a hundred thousand warnings
    };
    std::vector<std::shared_ptr<const Entry>> files_;
};

/// A mistake in a scene file; what() is the complete text of `Sources::describe`.
class SceneError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A mistake on the command line or in an option's value.
class OptionError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The picture or another result could not be written.
class OutputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A documented limit (memory, size, depth) was exceeded.
class LimitError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Receives warnings, #debug text and notes in the order in which they arise, each complete and without a final newline
/// (#debug text is passed as the scene wrote it). Never called from two threads at once.
using MessageSink = std::function<void(std::string_view)>;

}  // namespace rt
