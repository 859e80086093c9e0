#include "commands/job/picture_files.h"

#include <filesystem>

#include "film/image_file.h"

namespace rt {

namespace {

PictureFile::Kind kind_of(const StoredImage& image) {
    using From = StoredImage::Kind;
    using To = PictureFile::Kind;
    switch (image.kind) {
        case From::png:
            return To::png;
        case From::gif:
            return To::gif;
        case From::pixmap:
            return To::pixmap;
        case From::tiff:
            return To::tiff;
        case From::hdr:
            return To::hdr;
        case From::other:
            break;
    }
    return To::other;
}

}  // namespace

std::optional<PictureFile> read_picture_file(const std::string& path, std::size_t max_pixels) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
    StoredImage image = read_image(path, max_pixels);
    const PictureFile::Kind kind = kind_of(image);
    return PictureFile{image.width, image.height, image.channels,          image.max_value, std::move(image.values),
                       image.gamma, kind,         std::move(image.indices)};
}

}  // namespace rt
