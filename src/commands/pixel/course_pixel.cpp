#include "commands/pixel/course_pixel.h"

#include "commands/job/encoding.h"
#include "commands/job/job_steps.h"
#include "commands/job/surroundings.h"
#include "commands/job/text.h"

namespace rt {

TracedPixel trace_course_pixel(CourseArguments& arguments) {
    const MessageSink silent = message_sink(true);
    const RenderJob& job = arguments.job;
    TracedPixel traced;
    traced.scene = read_scene(arguments.job, silent);
    RenderOptions options = render_options(job, traced.scene);
    const World world = build_world(job, traced.scene, silent, few_rays_of_pixel(options, traced.scene.settings.max_trace_level));
    options.trace.environment = read_surroundings(job.environment);
    traced.rays = trace_pixel(world, std::move(options), arguments.x, row_from_top(job, arguments.y));
    Encoding encoding = encoding_of(job, traced.scene.settings.gamma);
    encoding.bits = 8;
    const Pixel& p = traced.rays.pixel;
    traced.name = {arguments.x, arguments.y, {quantise(p.r, encoding), quantise(p.g, encoding), quantise(p.b, encoding)}};
    traced.scene_name = job.scene, traced.shading = shading_text(job), traced.profile = job.profile;
    traced.width = job.width, traced.height = job.height;
    traced.camera = world.camera;
    return traced;
}

}  // namespace rt
