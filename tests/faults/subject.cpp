#include "tests/faults/subject.h"

#include "commands/job/encoding.h"
#include "commands/job/job_steps.h"
#include "commands/pixel/course_text.h"
#include "commands/pixel/ray_tree_json.h"
#include "commands/pixel/told_pixel_file.h"
#include "trace/pixel_rays.h"

namespace rt::test {

namespace {

CourseArguments arguments_of(const std::string& file, const std::vector<std::string>& options, int width, int height) {
    std::vector<std::string> words{file, std::to_string(width), std::to_string(height), "0", "0"};
    words.insert(words.end(), options.begin(), options.end());
    return parse_course_arguments({"printrays", true, true, true}, words);
}

const MessageSink silent = message_sink(true);

ToldPixel read_back(std::string text, ToldPixel (*reader)(const Sources&)) {
    Sources sources;
    sources.add({"record", std::move(text)});
    return reader(sources);
}

}  // namespace

Subject::Subject(const std::string& file, const std::vector<std::string>& options, int width, int height)
    : arguments_(arguments_of(file, options, width, height)),
      scene_(read_scene(arguments_.job, silent)),
      world_(build_world(arguments_.job, scene_, silent)),
      options_(render_options(arguments_.job, scene_)) {}

std::vector<std::uint16_t> Subject::picture() const {
    Encoding encoding = encoding_of(arguments_.job, scene_.settings.gamma);
    encoding.bits = 8;
    return quantise(render(world_, options_).film, encoding);
}

std::array<ToldPixel, 3> Subject::told(int x, int y) const {
    const RenderJob& job = arguments_.job;
    TracedPixel traced{"scene.pov", "", job.profile, job.width, job.height, scene_, world_.camera, {}, trace_pixel(world_, options_, x, y)};
    Encoding encoding = encoding_of(job, scene_.settings.gamma);
    encoding.bits = 8;
    const Pixel& p = traced.rays.pixel;
    traced.name = {x,
                   job.profile == Profile::csc473 ? job.height - 1 - y : y,
                   {quantise(p.r, encoding), quantise(p.g, encoding), quantise(p.b, encoding)}};
    return {read_back(ray_tree_json(traced), told_pixel_of_json),
            read_back(printrays_text(traced.name, scene_, traced.rays.samples), told_pixel_of_text),
            read_back(pixeltrace_text(traced.name, scene_, traced.rays.samples), told_pixel_of_text)};
}

std::array<std::size_t, 2> records_of(Form form) {
    switch (form) {
        case Form::json:
            return {0, 0};
        case Form::printrays:
            return {0, 1};
        case Form::tree:
            return {0, 2};
        case Form::text:
            return {1, 1};
    }
    return {};
}

}  // namespace rt::test
