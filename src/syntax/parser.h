// parse(text) -> Scene: reads the scene language and evaluates it while reading, as POV-Ray does.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/object_probe.h"

namespace rt {

/// How deep blocks and parentheses may be nested on the stack of the calling thread: 1000, or what it surely holds, but at least 10.
int nesting_that_fits();
/// True where less is left of the stack than the next level of nesting surely fits into.
bool stack_is_low();
/// Three quarters of what is installed.
std::size_t memory_that_fits();

/// What a scene reads of the frame that it is in an animation; all 0 in a single picture.
struct FrameValues {
    bool clock_on = false;
    int number = 0, initial_frame = 0, final_frame = 0;
    double initial_clock = 0.0, final_clock = 0.0, clock_delta = 0.0;
};

/// A picture as its file has it.
struct PictureFile {
    enum class Kind { png, gif, pixmap, tiff, hdr, other };
    int width = 0, height = 0, channels = 0;  ///< 1..4 channels: grey, grey and alpha, RGB, RGB and alpha
    int max_value = 255;                      ///< of whole numbers; 0: floats, linear light
    std::vector<float> values;                ///< interleaved, row by row from the top
    std::optional<double> gamma;              ///< the exponent that decodes it, where the file says so; else sRGB's curve does
    Kind kind = Kind::other;
    std::vector<std::uint8_t> indices = {};  ///< of a PNG with a palette: the number of each pixel's entry
};

struct ParseOptions {
    std::vector<std::string> library_paths;                     ///< searched for includes after the current folder and the including file's
    std::vector<std::pair<std::string, std::string>> declares;  ///< Declare=ID=value: a float, else a string
    int image_width = 800;
    int image_height = 600;
    double clock = 0.0;
    FrameValues frame;
    double version = 0.0;  ///< +MV; 0: not given
    std::string header;    ///< a file that is read before the scene, as if it were included there; empty: none
    Rotation rotation = Rotation::povray;
    Finish default_finish;                              ///< until the scene states another by `#default`
    bool lenient = false;                               ///< known but unmodelled features are warnings instead of errors
    bool collect_unmodelled = false;                    ///< ... or only collected in Scene::unmodelled (for `requires`)
    std::size_t max_file_bytes = std::size_t{1} << 30;  ///< per file
    int max_include_depth = 100;
    std::size_t max_includes = 1'000'000;   ///< `#include`s carried out, so that files which include each other twice end
    int max_nesting = nesting_that_fits();  ///< of blocks and parentheses
    int max_directive_nesting = 10'000;     ///< of directives inside the values of others, as far as the stack reaches
    std::size_t max_macro_depth = 10'000;   ///< of macros that call macros
    std::size_t max_array_elements = 10'000'000;
    /// Of text that loops and macros read again, in bytes; each round counts for 64 more, each
    /// element of an array that is copied for 16, of one of arrays for 128.
    std::size_t max_replayed_bytes = std::size_t{2} << 30;
    std::size_t max_memory_bytes = memory_that_fits();       ///< of the whole process, looked at while a scene is read
    std::size_t max_written_bytes = std::size_t{256} << 20;  ///< by `#write`, which writes into memory
    std::size_t max_string_bytes = std::size_t{1} << 20;     ///< that `concat` and its like make
    std::size_t max_picture_pixels = std::size_t{1} << 28;   ///< of one that the scene reads
    /// Of one texture: a colour, or a pattern besides its cells, is one node in each layer. Names make textures double with each line.
    std::size_t max_texture_nodes = 10'000;
    std::size_t max_texture_depth = 100;  ///< of patterns inside patterns
    /// Of the whole scene: nodes beyond the first of each texture, counted once where objects share it.
    std::size_t max_scene_nodes = 2'000'000;
    /// Of all sets of objects together; a part counts once in each set that it becomes a part of, and once in the scene.
    std::size_t max_set_parts = 10'000'000;
    /// Where the text of an included path comes from, empty if there is none; unset: the file system.
    std::function<std::optional<std::string>(const std::string& path)> read_include;
    /// The picture at a path, empty if there is no such file; throws OptionError for one that cannot be read. Unset: there are none.
    std::function<std::optional<PictureFile>(const std::string& path)> read_picture;
    /// What answers `trace` and `inside`; unset: they are not modelled.
    ProbeMaker make_probe;
    /// The same function with patterns and pigments that can answer, which take what they do not state from the scene so far; unset:
    /// they are not modelled where a value is wanted while the scene is read.
    std::function<std::shared_ptr<const Function>(const std::shared_ptr<const Function>& stated, const Scene& scene)> compile_function;
};

/// Reads `file` (its path is also its name in messages). Throws SceneError with POV-Ray's line, excerpt and caret; LimitError when a
/// documented limit is exceeded. Warnings and #debug text go to `messages`.
Scene parse_file(const std::string& path, const ParseOptions& options, const MessageSink& messages);

/// The same for text in memory.
Scene parse_text(SourceFile file, const ParseOptions& options, const MessageSink& messages);

}  // namespace rt
