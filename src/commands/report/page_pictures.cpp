#include "commands/report/page_pictures.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <string_view>

#include "commands/base/content_hash.h"
#include "core/source.h"
#include "film/png.h"
#include "syntax/file_text.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t i = at; i < at + 4; ++i) number = number << 8 | static_cast<unsigned char>(bytes[i]);
    return number;
}

std::string note_of(const StoredImage& image) {
    if (image.max_value == 255 || image.max_value == 65535) return {};
    if (image.max_value == 0) return "floating-point numbers, shown as 0 to 65535 for 0 to 1";
    return fmt::format("numbers from 0 to {}, shown as 0 to {}", image.max_value, image.max_value < 255 ? 255 : 65535);
}

}  // namespace

bool is_plain_png(const std::string& bytes) {
    constexpr std::string_view start("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
    if (!bytes.starts_with(start) || bytes.size() < 33) return false;
    if (number_at(bytes, 16) == 0 || number_at(bytes, 20) == 0) return false;
    const int depth = bytes[24], kind = bytes[25], interlaced = bytes[28];
    if ((depth != 8 && depth != 16) || (kind != 0 && kind != 2 && kind != 4 && kind != 6) || interlaced) return false;
    for (std::size_t at = 33; at + 12 <= bytes.size(); at += 12 + std::size_t{number_at(bytes, at)}) {
        const std::string_view chunk = std::string_view(bytes).substr(at + 4, 4);
        if (chunk == "IDAT") return true;
        if (chunk == "tRNS") return false;
    }
    return false;
}

const EmbeddedPicture& PagePictures::add(const std::string& path, const std::string& left_out) {
    const auto known = by_path_.find(path);
    return known != by_path_.end() ? known->second : by_path_.emplace(path, embed(path, left_out)).first->second;
}

EmbeddedPicture PagePictures::embed(const std::string& path, const std::string& left_out) {
    std::error_code error;
    const std::uint64_t size = fs::file_size(path, error);
    if (error) return {"", fmt::format("its file is not there: {}", error.message()), ""};
    if (size > most_) return {"", left_out, ""};
    std::optional<std::string> bytes = read_file_text(path, size);
    if (!bytes) return {"", "its file cannot be read", ""};
    const std::string content = hash_of(*bytes);
    if (const auto same = by_content_.find(content); same != by_content_.end()) return same->second;
    if (size > left_) return {"", left_out, ""};
    EmbeddedPicture picture{fmt::format("p{}", pictures_.size()), "", ""};
    if (!is_plain_png(*bytes)) try {
            const StoredImage image = read_image(path);
            bytes = png_of(image);
            picture.note = note_of(image);
        } catch (const OptionError&) {
            return {"", "its file is no picture that can be read", ""};
        }
    if (bytes->size() > left_) return {"", left_out, ""};
    left_ -= bytes->size();
    pictures_.emplace_back(picture.name, std::move(*bytes));
    return by_content_[content] = picture;
}

}  // namespace rt
