#include "commands/base/output_name.h"

#include <gtest/gtest.h>

namespace rt::output_name_test {
namespace {

struct Name {
    std::string name;
    bool povray;
    std::optional<ImageFormat> format;
    std::string path;
    ImageFormat type;
};

class OutputName : public testing::TestWithParam<Name> {};

TEST_P(OutputName, Becomes) {
    const Name& n = GetParam();
    const OutputTarget target = output_target({n.name, n.povray, n.format, true}, "scenes/ball.pov");
    EXPECT_EQ(target.path, n.path);
    EXPECT_EQ(target.format, n.type);
}

using F = ImageFormat;

// POV-Ray's rows are what POV-Ray 3.7 itself wrote for the same +O and +F.
INSTANTIATE_TEST_SUITE_P(Povray, OutputName,
                         testing::Values(Name{"", true, {}, "ball.png", F::png},                //
                                         Name{"out.png", true, {}, "out.png", F::png},          //
                                         Name{"out.png", true, F::tga, "out.png.tga", F::tga},  //
                                         Name{"out.dat", true, {}, "out.dat.png", F::png},      //
                                         Name{"out.exr", true, {}, "out.exr.png", F::png},      //
                                         Name{"out.PNG", true, {}, "out.PNG.png", F::png},      //
                                         Name{"out", true, F::ppm, "out.ppm", F::ppm},          //
                                         Name{"dir/", true, {}, "dir/ball.png", F::png},        //
                                         Name{"dir/", true, F::hdr, "dir/ball.hdr", F::hdr},    //
                                         Name{"", true, F::exr, "ball.exr", F::exr},            //
                                         Name{"", true, F::jpeg, "ball.jpg", F::jpeg},          //
                                         Name{"out.jpg", true, F::jpeg, "out.jpg", F::jpeg},    //
                                         Name{"-", true, {}, "-", F::png},                      //
                                         Name{"-", true, F::ppm, "-", F::ppm}));

INSTANTIATE_TEST_SUITE_P(Ours, OutputName,
                         testing::Values(Name{"out.exr", false, {}, "out.exr", F::exr},          //
                                         Name{"out.jpeg", false, {}, "out.jpeg", F::jpeg},       //
                                         Name{"out.tif", false, {}, "out.tif", F::tiff},         //
                                         Name{"out", false, {}, "out.png", F::png},              //
                                         Name{"out.dat", false, {}, "out.dat.png", F::png},      //
                                         Name{"out.exr", false, F::png, "out.exr.png", F::png},  //
                                         Name{"dir/", false, {}, "dir/ball.png", F::png},        //
                                         Name{"-", false, {}, "-", F::png}));

TEST(OutputName, NothingIsWrittenWithoutAFile) { EXPECT_EQ(output_target({"out.png", false, {}, false}, "a.pov").path, ""); }

TEST(OutputName, PartialPicturesKeepTheEnding) {
    EXPECT_EQ(partial_name("out.png"), "out.partial.png");
    EXPECT_EQ(partial_name("a.b/out.exr"), "a.b/out.partial.exr");
}

TEST(OutputName, TypeLettersMayCarryBits) {
    std::optional<int> bits;
    EXPECT_EQ(povray_file_type("n16", bits), F::png);
    EXPECT_EQ(bits, 16);
    EXPECT_EQ(povray_file_type("E", bits), F::exr);
    EXPECT_EQ(bits, 16);
}

TEST(OutputName, ADeviceKeepsItsName) {
    EXPECT_EQ(output_target({"/dev/null", false, {}, true}, "ball.pov").path, "/dev/null");
    EXPECT_EQ(output_target({"/dev/null", true, {}, true}, "ball.pov").path, "/dev/null");
}

TEST(OutputName, AnExistingFolderIsNoFileName) {
    const OutputTarget target = output_target({testing::TempDir() + ".", false, {}, true}, "scenes/ball.pov");
    EXPECT_EQ(target.path, testing::TempDir() + "./ball.png");
}

}  // namespace
}  // namespace rt::output_name_test
