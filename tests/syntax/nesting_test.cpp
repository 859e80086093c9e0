// What the limits let through fits a small stack, in every build.
#include <gtest/gtest.h>
#include <pthread.h>

#include "tests/syntax/read_scene.h"

namespace rt {
namespace {

std::string repeated(const std::string& part, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += part;
    return text;
}

/// What reading `scene` on a stack of 1 MB says.
std::string error_on_small_stack(const std::string& scene) {
    struct Job {
        std::string scene, error;
    } job{scene, "not run"};
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, std::size_t{1} << 20);
    pthread_t thread;
    const auto run = [](void* argument) -> void* {
        Job& job = *static_cast<Job*>(argument);
        job.error = read_scene(job.scene).error;
        return nullptr;
    };
    EXPECT_EQ(pthread_create(&thread, &attributes, run, &job), 0);
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
    return job.error;
}

struct Nest {
    const char* before;
    const char* open;
    const char* inner;
    const char* close;
    const char* after;
};

constexpr Nest nests[] = {
    {"", "object { ", "sphere { 0, 1 }", "}", ""},
    {"sphere { 0, ", "(", "1", ")", "}"},
    {"sphere { 0, ", "(1 ? ", "1", ": 1)", "}"},
    {"sphere { 0, ", "-", "1", "", "}"},
    {"sphere { 0, ", "abs(", "1", ")", "}"},
    {"sphere { 0, ", "<", "1", ", 1>.x", "}"},
    {"#debug ", "concat(", "\"a\"", ")", ""},
    {"sphere { 0, 1 pigment { ", "checker pigment { ", "rgb 1", "}", "}}"},
    {"sphere { 0, 1 texture { ", "checker texture { ", "", "}", "}}"},
    {"#declare A = ", "sphere { 0, 1 #declare A = ", "sphere { 0, 1 }", "}", ""},
    {"#declare A = ", "material { #declare A = ", "material { }", "}", ""},
    {"", "#default { ", "", "}", ""},
};

TEST(Nesting, TheDeepestFitsASmallStack) {
    for (const Nest& nest : nests) {
        const auto scene = [&](int depth) {
            return nest.before + repeated(nest.open, depth) + nest.inner + repeated(nest.close, depth) + nest.after;
        };
        EXPECT_EQ(error_on_small_stack(scene(30)), "") << nest.open;
        // Some of these count more than one level each: on the way to the limit every depth is read.
        const std::string error = error_on_small_stack(scene(1000));
        EXPECT_NE(error.find("nested more than 100 deep."), std::string::npos) << nest.open << error;
    }
}

TEST(Nesting, DeepTexturesInDeepBlocksFitASmallStack) {
    std::string text = "#declare P = pigment { rgb 1 }\n#declare T = texture { }\n";
    text += repeated("#declare P = pigment { checker pigment { P } pigment { P quick_color rgb 1 } }\n", 8);
    text += repeated("#declare P = pigment { checker pigment { P } pigment { rgb 1 } }\n", 90);
    text += repeated("#declare T = texture { checker texture { T } texture { } }\n", 99);
    text += repeated("object { ", 95) + "sphere { 0, 1 texture { T } }" + repeated("texture { T } }", 95);
    EXPECT_EQ(error_on_small_stack(text).find("nested"), std::string::npos);
}

TEST(Nesting, SkippedBlocksMayBeDeeper) {
    EXPECT_EQ(error_on_small_stack("#if (0) " + repeated("object { ", 100'000) + " #end sphere { 0, 1 }"), "");
}

}  // namespace
}  // namespace rt
