#include "commands/job/test_job.h"

#include <filesystem>

#include "commands/job/course_arguments.h"

namespace rt {

namespace fs = std::filesystem;

std::optional<RenderJob> job_of_test(const std::vector<std::string>& arguments, const std::string& inputs) {
    if (arguments.empty() || (arguments[0] != "render" && arguments[0] != "raycast")) return std::nullopt;
    const CourseUsage usage{.command = arguments[0], .size = true};
    RenderJob job = parse_course_arguments(usage, {arguments.begin() + 1, arguments.end()}).job;
    if (job.profile != Profile::csc473 || job.shading) return std::nullopt;
    if (!job.course) job.course.emplace();
    if (arguments[0] == "raycast") job.course->show = CourseShow::pigment;
    job.scene = scene_path(inputs, job.scene);
    job.threads = 1;
    return job;
}

std::string scene_path(const std::string& inputs, const std::string& word) {
    const fs::path path(word);
    for (fs::path::iterator part = path.begin(); part != path.end(); ++part) {
        if (*part == "..") continue;
        if (*part != "resources") break;
        fs::path rest;
        for (++part; part != path.end(); ++part) rest /= *part;
        return (fs::path(inputs) / rest).string();
    }
    return (fs::path(inputs) / path).string();
}

}  // namespace rt
