// libFuzzer's entry: any bytes are a scene or an error, never a crash, a hang or a file touched.
#include <cstddef>
#include <cstdint>

#include "syntax/parser.h"

namespace {

/// Files that includes and `#fopen` find; the last includes itself.
std::optional<std::string> read_include(const std::string& path) {
    if (path == "a.inc") return "#local L = 2; #declare A = L; #ifndef(B) #declare B = sphere { 0, A } #end\n";
    if (path == "data.txt") return "1, <2,3,4> \"five\"\n-6";
    if (path == "self.inc") return "#include \"self.inc\"\n";
    return std::nullopt;
}

/// Pictures of every kind that changes how one is read, by the last letter of the name.
std::optional<rt::PictureFile> read_picture(const std::string& path) {
    using Kind = rt::PictureFile::Kind;
    switch (path.empty() ? '\0' : path.back()) {
        case 'a':
            return rt::PictureFile{.width = 2, .height = 2, .channels = 1, .max_value = 65535, .values = {0, 9000, 40000, 65535}};
        case 'b':
            return rt::PictureFile{.width = 2, .height = 1, .channels = 4, .values = {0, 128, 255, 255, 9, 8, 7, 0}, .kind = Kind::png};
        case 'c':
            return rt::PictureFile{.width = 2,
                                   .height = 2,
                                   .channels = 3,
                                   .values = std::vector<float>(12, 100),
                                   .gamma = 2.2,
                                   .kind = Kind::png,
                                   .indices = {0, 1, 2, 3}};
        case 'd':
            return rt::PictureFile{.width = 1, .height = 2, .channels = 3, .max_value = 0, .values = {0, 1, 1e30F, -1, 0.5F, 2}};
        case 'e':
            return rt::PictureFile{
                .width = 2, .height = 2, .channels = 3, .values = std::vector<float>(12, 7), .kind = Kind::gif, .indices = {1, 0, 1, 0}};
        case 'f':
            throw rt::OptionError("Cannot read the picture");
        default:
            return std::nullopt;
    }
}

/// The first byte chooses how features that are not modelled are met.
rt::ParseOptions options_from(std::uint8_t choice) {
    rt::ParseOptions options;
    options.read_include = read_include;
    options.read_picture = read_picture;
    options.library_paths = {"library"};
    options.max_include_depth = 8;
    options.max_includes = 64;
    options.max_nesting = 50;
    options.max_texture_nodes = 64;
    options.max_texture_depth = 8;
    options.max_scene_nodes = 256;
    options.max_macro_depth = 40;
    options.max_directive_nesting = 40;
    options.max_replayed_bytes = 20'000;
    options.max_array_elements = 1'000;
    options.max_written_bytes = 10'000;
    options.max_string_bytes = 10'000;
    options.max_set_parts = 1'000;
    options.max_memory_bytes = std::size_t{3} << 29;
    options.max_file_bytes = std::size_t{1} << 20;
    options.declares = {{"Width", "3"}, {"Label", "text"}};
    options.lenient = (choice & 1) != 0;
    options.collect_unmodelled = (choice & 2) != 0;
    options.rotation = (choice & 4) != 0 ? rt::Rotation::csc473 : rt::Rotation::povray;
    if ((choice & 8) != 0) options.version = 3.6;
    return options;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        rt::parse_text({"fuzz.pov", text}, options_from(data[0]), [](std::string_view) {});
    } catch (const rt::SceneError&) {
    } catch (const rt::LimitError&) {
    }
    return 0;
}
