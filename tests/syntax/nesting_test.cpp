// What the limits let through fits a small stack, in every build.
#include <gtest/gtest.h>
#include <pthread.h>

#include "tests/syntax/read_scene.h"

namespace rt::nesting_test {
namespace {

std::string repeated(const std::string& part, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += part;
    return text;
}

/// The thread sanitizer keeps its own memory of a thread at the end of that thread's stack; the address sanitizer makes frames several
/// times as large.
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
constexpr std::size_t sanitizer_bytes = 1 << 20;
#else
constexpr std::size_t sanitizer_bytes = 0;
#endif

struct Job {
    std::string scene, error;
    int limit = 0;
};

/// What reading `scene` on a stack of so many MB says, and which limit is in force there.
Job read_on_stack(std::size_t megabytes, const std::string& scene) {
    Job job{scene, "not run"};
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, (megabytes << 20) + sanitizer_bytes);
    pthread_t thread;
    const auto run = [](void* argument) -> void* {
        Job& job = *static_cast<Job*>(argument);
        job.limit = nesting_that_fits();
        job.error = read_scene(job.scene).error;
        return nullptr;
    };
    EXPECT_EQ(pthread_create(&thread, &attributes, run, &job), 0);
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
    return job;
}

std::string error_on_small_stack(const std::string& scene) { return read_on_stack(1, scene).error; }

struct Nest {
    const char* before;
    const char* open;
    const char* inner;
    const char* close;
    const char* after;
};

constexpr Nest nests[] = {
    {"", "object { ", "sphere { 0, 1 }", "}", ""},
    {"", "light_group { ", "sphere { 0, 1 }", "}", ""},
    {"", "light_source { 0, 1 looks_like { ", "sphere { 0, 1 }", "} }", ""},
    {"sphere { 0, ", "(", "1", ")", "}"},
    {"sphere { 0, ", "(1 ? ", "1", ": 1)", "}"},
    {"sphere { 0, ", "-(", "1", ")", "}"},
    {"sphere { 0, ", "abs(", "1", ")", "}"},
    {"sphere { 0, ", "<", "1", ", 1>.x", "}"},
    {"#debug ", "concat(", "\"a\"", ")", ""},
    {"sphere { 0, 1 pigment { ", "checker pigment { ", "rgb 1", "}", "}}"},
    {"sphere { 0, 1 texture { ", "checker texture { ", "", "}", "}}"},
    {"#declare A = ", "sphere { 0, 1 #declare A = ", "sphere { 0, 1 }", "}", ""},
    {"#declare A = ", "material { #declare A = ", "material { }", "}", ""},
    {"", "#default { ", "", "}", ""},
};

void expect_deepest_fits(std::size_t megabytes) {
    for (const Nest& nest : nests) {
        const auto read = [&](int depth) {
            return read_on_stack(megabytes,
                                 nest.before + repeated(nest.open, depth) + nest.inner + repeated(nest.close, depth) + nest.after);
        };
        EXPECT_EQ(read(30).error, "") << nest.open;
        // Some of these count more than one level each: on the way to the limit every depth is read.
        const Job deep = read(1100);
        EXPECT_NE(deep.error.find("nested more than " + std::to_string(deep.limit) + " deep."), std::string::npos)
            << nest.open << deep.error;
    }
}

TEST(Nesting, TheDeepestFitsASmallStack) { expect_deepest_fits(1); }
TEST(Nesting, TheDeepestFitsTheUsualStack) { expect_deepest_fits(8); }

TEST(Nesting, TheLimitFollowsTheStack) {
    const int small = read_on_stack(1, "").limit;
    const int usual = read_on_stack(8, "").limit;
    EXPECT_GE(small, 100);
    EXPECT_LE(small, 128);
    EXPECT_GE(usual, 500);
    EXPECT_LE(usual, 1000);
    EXPECT_EQ(read_on_stack(1000, "").limit, 1000);
    EXPECT_EQ(read_on_stack(8, "sphere { 0, " + repeated("(", usual - 10) + "1" + repeated(")", usual - 10) + "}").error, "");
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
}  // namespace rt::nesting_test
