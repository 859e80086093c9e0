#include "commands/base/output_name.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "commands/base/values.h"
#include "core/source.h"

namespace rt {

namespace {

/// Does `name` end in an extension of `format`, exactly?
bool has_extension(const std::string& name, ImageFormat format) {
    const std::string found = std::filesystem::path(name).extension().string();
    if (found == fmt::format(".{}", extension(format))) return true;
    return (format == ImageFormat::jpeg && found == ".jpeg") || (format == ImageFormat::tiff && found == ".tiff") ||
           (format == ImageFormat::tiff && found == ".tif");
}

/// Something that exists and takes bytes as they come: a pipe, /dev/stdout, ... Its name stays as it is.
bool is_device(const std::string& path) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(path, ignored);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) && !std::filesystem::is_directory(status);
}

}  // namespace

OutputTarget output_target(const OutputRequest& request, const std::string& scene) {
    OutputTarget target;
    if (!request.to_file) return target;
    const std::string stem = std::filesystem::path(scene).stem().string();
    std::string folder = request.name;
    std::error_code ignored;
    ImageFormat by_name = ImageFormat::png;
    const bool picture = format_of(folder, by_name);
    if (!picture && !folder.empty() && !folder.ends_with('/') && std::filesystem::is_directory(folder, ignored)) folder += '/';
    const bool named = !folder.empty() && !folder.ends_with('/');
    target.path = named ? request.name : folder + stem;
    if (request.format)
        target.format = *request.format;
    else if (named && !request.povray_rules && format_of(target.path, by_name))
        target.format = by_name;
    if (target.path == "-" || is_device(target.path)) return target;
    const bool complete = named && (has_extension(target.path, target.format) ||
                                    (!request.povray_rules && format_of(target.path, by_name) && by_name == target.format));
    if (!complete) target.path += fmt::format(".{}", extension(target.format));
    return target;
}

std::string note_on_name(const OutputRequest& request, const OutputTarget& target) {
    const std::string ending = std::filesystem::path(request.name).extension().string();
    if (ending.empty() || target.path != fmt::format("{}.{}", request.name, extension(target.format))) return "";
    return fmt::format("'{}' is not the ending of the picture's type: '{}' is written", ending, target.path);
}

std::string partial_name(const std::string& path) {
    std::filesystem::path name(path);
    const std::string ending = name.extension().string();
    return name.replace_extension().string() + ".partial" + ending;
}

ImageFormat povray_file_type(const std::string& text, std::optional<int>& bits) {
    static constexpr std::pair<char, ImageFormat> types[] = {
        {'n', ImageFormat::png},  {'t', ImageFormat::tga}, {'c', ImageFormat::tga}, {'p', ImageFormat::ppm},
        {'j', ImageFormat::jpeg}, {'b', ImageFormat::bmp}, {'e', ImageFormat::exr}, {'h', ImageFormat::hdr},
    };
    const std::string type = lower_case(text);
    if (type == "ng" || type == "pg")
        throw OptionError(fmt::format("grey pictures (file type '{}', Grayscale_Output) are not available in this version", text));
    if (type.size() > 1) bits = whole_number("bits per colour", type.substr(1), 1, most_bits);
    for (const auto& [letter, format] : types)
        if (!type.empty() && type[0] == letter) return format;
    throw OptionError(fmt::format(
        "'{}' is no output file type; expected one of N (png), P (ppm), T or C (tga), J (jpeg), E (exr), H (hdr), B (bmp)", text));
}

}  // namespace rt
