#include "commands/job/scene_answers.h"

#include "commands/job/picture_files.h"
#include "world/body_probe.h"
#include "world/compile_pigment.h"

namespace rt {

void give_answers(ParseOptions& options) {
    options.read_picture = [most = options.max_picture_pixels](const std::string& path) { return read_picture_file(path, most); };
    options.make_probe = make_body_probe;
    options.compile_function = [](const std::shared_ptr<const Function>& stated, const Scene& scene) {
        return compile_function(stated, pattern_defaults(scene));
    };
}

}  // namespace rt
