// Where a picture goes: POV-Ray's rules for +O and +F, and ours for -o.
#pragma once

#include <optional>
#include <string>

#include "film/image_file.h"

namespace rt {

/// Per channel, of any format.
inline constexpr int most_bits = 32;

struct OutputRequest {
    std::string name;           ///< empty: the scene's name in the current directory; "-": standard output; "dir/": the scene's name there
    bool povray_rules = false;  ///< the type is never taken from the name's extension
    std::optional<ImageFormat> format;
    bool to_file = true;  ///< false: render and write nothing (-F)
};

struct OutputTarget {
    std::string path;  ///< "-" is standard output; empty: write nothing
    ImageFormat format = ImageFormat::png;
};

/// The right extension is appended unless the name has it (case counts, as in POV-Ray): "out.dat" becomes "out.dat.png".
OutputTarget output_target(const OutputRequest& request, const std::string& scene);

/// "" or, where an extension that is not the type's got another behind it, a note that says so.
std::string note_on_name(const OutputRequest& request, const OutputTarget& target);

/// "out.png" -> "out.partial.png": what an interrupted run leaves.
std::string partial_name(const std::string& path);

/// POV-Ray's type letters with an optional number of bits ("N", "n16", "E"). `bits` is only changed if stated.
ImageFormat povray_file_type(const std::string& text, std::optional<int>& bits);

}  // namespace rt
