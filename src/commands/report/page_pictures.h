// The pictures that a page embeds.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace rt {

/// What became of a file that a page is to show.
struct EmbeddedPicture {
    std::string name;     ///< in the page, "p0", "p1", ...; empty: it is not in it
    std::string problem;  ///< then: why
    std::string note;     ///< what its numbers are if they are not those of the file
};

/// Collects the pictures of a page; files of the same bytes become one.
class PagePictures {
public:
    /// Takes no more bytes than that.
    explicit PagePictures(std::uint64_t most_bytes) : most_(most_bytes), left_(most_bytes) {}

    /// The picture of the file at `path`; `left_out` is the problem of one for which there is no room.
    const EmbeddedPicture& add(const std::string& path, const std::string& left_out);

    /// Names and PNG files.
    std::vector<std::pair<std::string, std::string>> take() { return std::move(pictures_); }

private:
    EmbeddedPicture embed(const std::string& path, const std::string& left_out);

    std::uint64_t most_, left_;
    std::vector<std::pair<std::string, std::string>> pictures_;
    std::map<std::string, EmbeddedPicture> by_path_, by_content_;
};

/// Whether a page's script reads the bytes as they are: a PNG that has pixels of 8 or 16 bits, without palette, transparent colour and
/// interlacing.
bool is_plain_png(const std::string& bytes);

}  // namespace rt
