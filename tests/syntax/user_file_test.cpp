// #fopen, #read, #write, #fclose, as measured on POV-Ray, but that nothing is written to disk.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/syntax/read_scene.h"

namespace rt::user_file_test {
namespace {

const Files files{{"pairs.txt", "\"x\",1,\n\"y\",2.5,\n\"z\",-3\n"},
                  {"vectors.txt", "<1,2,3>,<4,5,6>\n<7,+8,-9>\n"},
                  {"numbers.txt", "// comment\n-1.5e1 +2, 2*3"},
                  {"name.txt", "abc"},
                  {"open.txt", "<1,2"},
                  {"empty.txt", ""}};

TEST(UserFile, IsReadToItsEnd) {
    const std::vector<std::pair<std::string, std::string>> cases{
        {"#fopen F \"pairs.txt\" read #while(defined(F)) #read(F,A,B) #debug concat(A,str(B,0,1),\" \") #end", "x1.0 y2.5 z-3.0 "},
        {"#fopen F \"vectors.txt\" read #while(defined(F)) #read(F,V) #debug concat(vstr(3,V,\",\",0,0),\" \") #end",
         "1,2,3 4,5,6 7,8,-9 "},
        {"#fopen F \"numbers.txt\" read #read(F,A,B,C) #debug vstr(3,<A,B,C>,\",\",0,0)", "-15,2,2"},
        {"#fopen F \"pairs.txt\" read #read(F,A) #fclose F #ifndef(F) #debug \"closed\" #end", "closed"},
        {"#fopen F \"empty.txt\" read #read(F,A) #ifndef(F) #debug \"closed\" #end #ifndef(A) #debug \" unset\" #end", "closed unset"},
        {"#macro M() #fopen F \"numbers.txt\" read #read(F,V) #end M() #debug str(V,0,0)", "-15"},
        {"#declare A=array[2]; #fopen F \"numbers.txt\" read #read(F,A[0],A[1]) #debug str(A[1],0,0)", "2"},
        {"#macro M(P) #fopen F \"numbers.txt\" read #read(F,P) #end #declare A=1; M(A) #debug str(A,0,0)", "-15"},
        {"#fclose F #debug \"nothing\"", "nothing"},
    };
    for (const auto& [scene, text] : cases) EXPECT_EQ(debug_text(scene, {}, files), text) << scene;
}

TEST(UserFile, WhatIsWrittenIsReadAndIncludedAgain) {
    const std::vector<std::pair<std::string, std::string>> cases{
        {"#fopen F \"o.inc\" write #write(F,\"#debug \\\"written\\\"\") #fclose F #include \"o.inc\"", "written"},
        {"#fopen F \"o\" write #write(F,\"1\") #fopen F \"o\" append #write(F,\"2\") #fopen F \"o\" read #read(F,A) #debug str(A,0,0)",
         "12"},
        {"#fopen F \"o\" write #write(F,\"1\") #fopen F \"o\" write #write(F,\"2\") #fopen F \"o\" read #read(F,A) #debug str(A,0,0)", "2"},
        {"#fopen F \"numbers.txt\" append #write(F,\"+77\") #fopen F \"numbers.txt\" read #read(F,A,B,C) #debug str(A,0,0)", "-15"},
        {"#fopen F \"name.txt\" write #write(F,\"5\") #fopen F \"name.txt\" read #read(F,A) #debug str(A,0,0)", "5"},
    };
    for (const auto& [scene, text] : cases) {
        const Outcome o = read_scene(scene, {}, files);
        ASSERT_EQ(o.error, "") << scene;
        ASSERT_EQ(o.messages.size(), 2u) << o.log();  // the first says that nothing is written
        EXPECT_EQ(o.messages[1], text) << scene;
    }
}

TEST(UserFile, FormatsNumbersAsPovRayDoes) {
    const auto written = [](const std::string& values) {
        const Outcome o = read_scene(
            "#fopen F \"o\" write #write(F,\"\\\"\"," + values + ",\"\\\"\") #fclose F #fopen F \"o\" read #read(F,A) #debug A", {}, files);
        return o.error.empty() ? o.messages.back() : o.error;
    };
    EXPECT_EQ(written("1,<1,2,3>,1.5"), "1<1,2,3> 1.5");
    EXPECT_EQ(written("1e10,\",\",pi,\",\",1/3"), "1e+10,3.14159,0.333333");
    EXPECT_EQ(written("<1,2>,\",\",<1,2,3,4>,true,-0.5"), "<1,2> ,<1,2,3,4> 1-0.5");
}

TEST(UserFile, MistakesAreNamedAsPovRayNamesThem) {
    const std::vector<std::pair<const char*, const char*>> mistakes{
        {"#macro M(A,B) #end #fopen F \"numbers.txt\" read M(#read(F,M) 1,2)",
         "Expected 'undeclared identifier', macro identifier found instead"},
        {"#fopen F \"nope.txt\" read", "Cannot open user file nope.txt (read)."},
        {"#read(F,V)", "Expected 'file identifier', undeclared identifier 'F' found instead"},
        {"#write(F,1)", "Expected 'file identifier', undeclared identifier 'F' found instead"},
        {"#fopen F \"pairs.txt\" read #write(F,1)", "Cannot write to file pairs.txt because the file is open for reading only."},
        {"#fopen F \"o.txt\" write #read(F,V)", "Cannot read from file o.txt because the file is open for writing only."},
        {"#fopen F \"o.txt\" write #write(F,sphere{0,1})", "Expected 'string', sphere found instead"},
        {"#fopen F \"o.txt\" write #write(F,uint8 3)", "'#write of uint8' is not modelled."},
        {"#fopen F \"o.txt\"", "Expected 'read or write', End of File found instead"},
        {"#fopen x \"o.txt\" read", "Expected 'undeclared identifier', vector function 'x' found instead"},
        {"#fopen F \"name.txt\" read #read(F,V)", "Expected 'float, vector, or string literal', undeclared identifier 'abc' found instead"},
        {"#fopen F \"open.txt\" read #read(F,V)", "Expected 'float, vector, or string literal', End of File found instead"},
        {"#fopen F \"pairs.txt\" read #read(F,1)", "Expected 'undeclared identifier', float function 'float constant' found instead"},
    };
    for (const auto& [scene, text] : mistakes) EXPECT_EQ(error_text(scene, {}, files), text) << scene;
}

/// A folder of its own with a scene in a folder below it.
class UserFileOnDisk : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::temp_directory_path() /
                  ("raytrace_user_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_ / "scene" / "data");
        write("secret.txt", "1");
        write("scene/data/open.txt", "2");
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name, std::ios::binary) << text; }
    std::string read(const std::string& name, const ParseOptions& options = {}) const {
        std::string log;
        write("scene/s.pov", "#fopen F \"" + name + "\" read #read(F,V) #debug concat(\"read \",str(V,0,0),\"|\")");
        try {
            parse_file((folder_ / "scene" / "s.pov").string(), options, [&](std::string_view m) { log += m; });
        } catch (const SceneError& e) {
            log += e.what();
        }
        return log;
    }
    std::filesystem::path folder_;
};

TEST_F(UserFileOnDisk, OnlyWhatLiesBelowTheSceneOrALibraryIsRead) {
    EXPECT_THAT(read("data/open.txt"), testing::HasSubstr("read 2|"));
    const std::string refusal = "is neither below the scene's folder nor below a library path.";
    EXPECT_THAT(read("../secret.txt"), testing::HasSubstr(refusal));
    EXPECT_THAT(read((folder_ / "secret.txt").string()), testing::HasSubstr(refusal));
    std::filesystem::create_symlink(folder_ / "secret.txt", folder_ / "scene" / "link.txt");
    EXPECT_THAT(read("link.txt"), testing::HasSubstr(refusal));
    ParseOptions library;
    library.library_paths = {folder_.string()};
    EXPECT_THAT(read("secret.txt", library), testing::HasSubstr("read 1|"));
}

TEST_F(UserFileOnDisk, NothingIsWritten) {
    write("scene/w.pov", "#fopen F \"w.txt\" write #write(F,1) #fclose F #fopen F \"data/open.txt\" append #write(F,1)");
    std::string log;
    parse_file((folder_ / "scene" / "w.pov").string(), {}, [&](std::string_view m) { log += m; });
    EXPECT_THAT(log,
                testing::HasSubstr("Parse Warning: What is written to 'w.txt' is kept in memory: the scene can read and include it, no "
                                   "file is made."));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "scene" / "w.txt"));
    EXPECT_EQ(std::filesystem::file_size(folder_ / "scene" / "data" / "open.txt"), 1u);
}

}  // namespace
}  // namespace rt::user_file_test
