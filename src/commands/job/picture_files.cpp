#include "commands/job/picture_files.h"

#include <filesystem>

#include "film/image_file.h"

namespace rt {

std::optional<PictureFile> read_picture_file(const std::string& path, std::size_t max_pixels) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
    StoredImage image = read_image(path, max_pixels);
    const auto kind = image.kind == StoredImage::Kind::png   ? PictureFile::Kind::png
                      : image.kind == StoredImage::Kind::gif ? PictureFile::Kind::gif
                                                             : PictureFile::Kind::other;
    return PictureFile{image.width, image.height, image.channels,          image.max_value, std::move(image.values),
                       image.gamma, kind,         std::move(image.indices)};
}

}  // namespace rt
