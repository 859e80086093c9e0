// The course's dialect: positional arguments, single-dash options, no word on any stream when all is well.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "commands/base/names.h"
#include "commands/base/program.h"
#include "commands/commands.h"
#include "commands/course/course_boxes.h"
#include "commands/help.h"
#include "commands/job/course_arguments.h"
#include "commands/job/job_steps.h"
#include "commands/job/session.h"
#include "commands/pixel/course_pixel.h"
#include "commands/pixel/course_text.h"
#include "commands/pixel/pixel_page.h"
#include "commands/pixel/ray_tree_json.h"
#include "trace/camera.h"

namespace rt {

namespace {

Ray ray_of_centre(const CourseArguments& arguments, const CameraBasis& camera) {
    return camera_ray(camera, arguments.x + 0.5, row_from_top(arguments.job, arguments.y) + 0.5, arguments.job.width, arguments.job.height);
}

int render_course(CourseArguments arguments) { return run_session(std::move(arguments.job)); }

/// Part one of the course: pigments without light.
int raycast(CourseArguments arguments) {
    if (!arguments.job.course) arguments.job.course.emplace();
    arguments.job.course->show = CourseShow::pigment;
    return run_session(std::move(arguments.job));
}

int sceneinfo(CourseArguments arguments) {
    write_stdout(sceneinfo_text(read_scene(arguments.job, message_sink(true))));
    return 0;
}

int pixelray(CourseArguments arguments) {
    const MessageSink silent = message_sink(true);
    const Scene scene = read_scene(arguments.job, silent);
    const CameraBasis camera = camera_basis(scene.camera, arguments.job.profile, scene.sources, silent);
    write_stdout(pixelray_text({arguments.x, arguments.y, {}}, ray_of_centre(arguments, camera)));
    return 0;
}

int firsthit(CourseArguments arguments) {
    const MessageSink silent = message_sink(true);
    const Scene scene = read_scene(arguments.job, silent);
    const World world = build_world(arguments.job, scene, silent, FewRays{.camera = 1, .shaded = false});
    TraceOptions flat;
    flat.course.emplace().show = CourseShow::pigment;
    RayLog log;
    Tracer(world, flat).camera_ray(ray_of_centre(arguments, world.camera), log);
    write_stdout(firsthit_text({arguments.x, arguments.y, {}}, scene, log.nodes.front()));
    return 0;
}

std::string_view brdf_name(const RenderJob& job) {
    if (!job.course) return name_of(shading_names, *job.shading);
    return job.course->cook_torrance ? "Cook-Torrance" : "Blinn-Phong";
}

int pixelcolor(CourseArguments arguments) {
    const TracedPixel traced = trace_course_pixel(arguments);
    // Of several samples the middle one stands for the pixel.
    const RayNode& node = traced.rays.samples[traced.rays.samples.size() / 2].nodes.front();
    write_stdout(pixelcolor_text(traced.name, traced.scene, node, brdf_name(arguments.job)));
    return 0;
}

int printrays(CourseArguments arguments) {
    const TracedPixel traced = trace_course_pixel(arguments);
    write_stdout(arguments.json ? ray_tree_json(traced) : printrays_text(traced.name, traced.scene, traced.rays.samples));
    return 0;
}

int pixeltrace(CourseArguments arguments) {
    if (arguments.page) return write_pixel_page(std::move(arguments));
    const TracedPixel traced = trace_course_pixel(arguments);
    write_stdout(arguments.json ? ray_tree_json(traced) : pixeltrace_text(traced.name, traced.scene, traced.rays.samples));
    return 0;
}

int printbvh(CourseArguments arguments) {
    const MessageSink silent = message_sink(true);
    const Scene scene = read_scene(arguments.job, silent);
    write_stdout(printbvh_text(scene, build_world(arguments.job, scene, silent, FewRays{.camera = 0, .shaded = false})));
    return 0;
}

struct Command {
    CourseUsage usage;
    int (*run)(CourseArguments arguments);
};

constexpr bool size = true, pixel = true, tree = true, page = true;
constexpr std::array<Command, 9> commands{{{{"render", size, !pixel}, render_course},
                                           {{"raycast", size, !pixel}, raycast},
                                           {{"sceneinfo", !size, !pixel}, sceneinfo},
                                           {{"pixelray", size, pixel}, pixelray},
                                           {{"firsthit", size, pixel}, firsthit},
                                           {{"pixelcolor", size, pixel}, pixelcolor},
                                           {{"printrays", size, pixel, tree}, printrays},
                                           {{"pixeltrace", size, pixel, tree, page}, pixeltrace},
                                           {{"printbvh", !size, !pixel}, printbvh}}};

}  // namespace

bool is_course_command(const std::string& word) {
    return std::any_of(commands.begin(), commands.end(), [&](const Command& c) { return c.usage.command == word; });
}

int run_course(const std::string& command, const Words& words) {
    const bool help = std::any_of(words.begin(), words.end(), [](const std::string& w) { return w == "--help" || w == "-h"; });
    if (help) {
        write_stdout(help_topic("course"));
        return 0;
    }
    const auto found = std::find_if(commands.begin(), commands.end(), [&](const Command& c) { return c.usage.command == command; });
    return found->run(parse_course_arguments(found->usage, words));
}

}  // namespace rt
