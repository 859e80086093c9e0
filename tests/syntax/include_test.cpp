#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "syntax/reader.h"
#include "tests/syntax/read_scene.h"

namespace rt::include_test {
namespace {

TEST(Include, ReadsTheFileWhereItStands) {
    const Files files{{"a.inc", "#declare A = 3;\n"}, {"half.inc", "0, "}, {"if.inc", "#if(1) #declare B = 2; #end"}, {"empty.inc", ""}};
    EXPECT_EQ(debug_text("#include \"a.inc\"\n#debug str(A,0,0)", {}, files), "3");
    EXPECT_EQ(debug_text("#include \"a\" #debug str(A,0,0)", {}, files), "3");
    EXPECT_EQ(debug_text("#include concat(\"a\",\".inc\") #debug str(A,0,0)", {}, files), "3");
    EXPECT_EQ(debug_text("#declare N = \"a.inc\" #include N #debug str(A,0,0)", {}, files), "3");
    EXPECT_EQ(debug_text("#include \"if.inc\"#debug str(B,0,0)", {}, files), "2");
    EXPECT_EQ(read_scene("sphere { #include \"half.inc\" 1 } #include \"empty.inc\"", {}, files).error, "");
}

TEST(Include, IsLookedForHereThenBesideTheIncludingFileThenInTheLibraries) {
    const Files files{{"a.inc", "#debug \"here\""},        {"lib/a.inc", "#debug \"library\""}, {"lib/only.inc", "#debug \"library\""},
                      {"sub/b.inc", "#include \"a.inc\""}, {"sub/a.inc", "#debug \"beside\""},  {"two/only.inc", "#debug \"second\""},
                      {"sub/d.inc", "#include \"c.inc\""}, {"sub/c.inc", "#debug \"beside\""},  {"lib/c.inc", "#debug \"library\""}};
    ParseOptions options;
    options.library_paths = {"lib", "two"};
    EXPECT_EQ(debug_text("#include \"a.inc\"", options, files), "here");
    EXPECT_EQ(debug_text("#include \"sub/b.inc\"", options, files), "here");
    EXPECT_EQ(debug_text("#include \"sub/d.inc\"", options, files), "beside");
    EXPECT_EQ(debug_text("#include \"only.inc\"", options, files), "library");
}

TEST(Include, LocalNamesEndWithTheirFileAndAreSeenInWhatItIncludes) {
    const Files files{{"a.inc", "#local A = 1; #declare B = A; #include \"b.inc\" #debug str(A,0,0)"},
                      {"b.inc", "#debug str(A,0,0) #local A = 2;"}};
    EXPECT_EQ(debug_text("#include \"a.inc\" #ifdef(A) #debug \"A\" #end #ifdef(B) #debug \"B\" #end", {}, files), "11B");
}

TEST(Include, MessagesNameTheIncludedFile) {
    const Files files{{"a.inc", "\n\nsphere { 0, 1 pigmnt { } }\n"}};
    EXPECT_EQ(read_scene("#include \"a.inc\"", {}, files).error,
              "File 'a.inc' line 3: Parse Error: No matching } in 'sphere', undeclared identifier 'pigmnt' found instead\n"
              "   3 | sphere { 0, 1 pigmnt { } }\n"
              "     |               ^^^^^^");
}

TEST(Include, MissingFilesAreNamed) {
    const Outcome o = read_scene("#declare A = 1;\n  #include \"nope.inc\"");
    EXPECT_EQ(o.error,
              "File 't.pov' line 2: Parse Error: Cannot open include file nope.inc.\n"
              "   2 |   #include \"nope.inc\"\n"
              "     |            ^^^^^^^^^^");
    EXPECT_THAT(o.log(),
                testing::HasSubstr("Possible Parse Error: Cannot find file 'nope.inc', even after trying to append file type extension."));
    EXPECT_EQ(error_text("#include nope"), "Expected 'string expression', undeclared identifier 'nope' found instead");
    EXPECT_EQ(error_text("#include"), "Expecting a string after INCLUDE.");
    EXPECT_EQ(error_text("#include \"a.inc\"", {}, {{"a.inc", "#include \"b\""}}), "Cannot open include file b.");
}

TEST(Include, AHeaderIsReadBeforeTheScene) {
    ParseOptions options;
    options.header = "h";
    const Files files{{"h.inc", "#declare A = 1; #local B = 2; #debug \"header \""}};
    EXPECT_EQ(debug_text("#debug str(A, 0, 0) #ifdef (B) #debug \"local\" #end", options, files), "header 1");
    options.header = "none.inc";
    EXPECT_EQ(read_scene("sphere { 0, 1 }", options, files).error,
              "File 'none.inc': Parse Error: Cannot open include header file none.inc.");
}

std::string too_many_files(int most) {
    return fmt::format("Too many nested include files. More than {} are open. --limit include-depth=N allows more.", most);
}

TEST(Include, CyclesEnd) {
    const Files files{{"a.inc", "#include \"b.inc\""}, {"b.inc", "#include \"a.inc\""}, {"self.inc", "#include \"self.inc\""}};
    EXPECT_EQ(error_text("#include \"a.inc\"", {}, files), too_many_files(100));
    EXPECT_EQ(error_text("#include \"self.inc\"", {}, files), too_many_files(100));
    ParseOptions options;
    options.max_include_depth = 3;
    const Files chain{{"1", "#include \"2\""}, {"2", "#include \"3\""}, {"3", "#debug \"deep\""}, {"0", "#include \"1\""}};
    EXPECT_EQ(debug_text("#include \"1\"", options, chain), "deep");
    EXPECT_EQ(error_text("#include \"0\"", options, chain), too_many_files(3));
}

TEST(Include, AFileThatIncludesTwoOfItsKindAtEveryLevelEnds) {
    Files files;
    for (int i = 0; i < 60; ++i) {
        const std::string next = fmt::format("#include \"f{}\"\n", i + 1);
        files[fmt::format("f{}", i)] = next + next;
    }
    files["f60"] = "";
    ParseOptions options;
    options.max_includes = 1000;
    const Outcome o = read_scene("#include \"f0\"", options, files);
    EXPECT_TRUE(o.limit);
    EXPECT_THAT(o.error, testing::HasSubstr("More than 1000 files are included."));
}

TEST(Include, ConditionalsBelongToTheirFile) {
    EXPECT_EQ(error_text("#if(1) #include \"a.inc\"", {}, {{"a.inc", "#end"}}), "Mis-matched '#end'.");
    EXPECT_EQ(error_text("#if(1) #include \"a.inc\" #end", {}, {{"a.inc", "#else"}}), "Mis-matched '#else'.");
    EXPECT_EQ(read_scene("#include \"a.inc\" #end", {}, {{"a.inc", "#if(1)"}}).error,
              "File 'a.inc' line 1: Parse Error: End of file reached but #end expected.\n"
              "   1 | #if(1)\n"
              "     | ^^^");
}

/// A folder of its own for one test, removed at its end.
class FilesOnDisk : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::temp_directory_path() /
                  ("raytrace_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_ / "lib");
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name, std::ios::binary) << text;
        return (folder_ / name).string();
    }
    std::string parse(const std::string& path, const ParseOptions& options = {}) const {
        std::string log;
        try {
            parse_file(path, options, [&](std::string_view m) { log += m; });
        } catch (const std::runtime_error& e) {
            return e.what();
        }
        return log;
    }
    std::filesystem::path folder_;
};

TEST_F(FilesOnDisk, SceneAndIncludesAreFound) {
    const std::string scene = write("scene.pov", "#include \"beside.inc\" #include \"far.inc\"");
    write("beside.inc", "#debug \"beside\"");
    write("lib/far.inc", "#debug \"far\"");
    ParseOptions options;
    options.library_paths = {(folder_ / "lib").string()};
    EXPECT_THAT(parse(scene, options), testing::StartsWith("besidefar"));
}

TEST_F(FilesOnDisk, WhatIsNoSceneFileIsRefused) {
    const std::string nowhere = (folder_ / "nowhere.pov").string();
    EXPECT_EQ(parse(nowhere), "File '" + nowhere + "': Parse Error: Cannot open input file.");
    EXPECT_EQ(parse(folder_.string()), "File '" + folder_.string() + "': Parse Error: Cannot open input file.");
    EXPECT_THAT(parse(write("scene.pov", "#include \"/dev/zero\"")), testing::HasSubstr("Cannot open include file /dev/zero."));
    EXPECT_THAT(parse(write("scene.pov", "#include \"lib\"")), testing::HasSubstr("Cannot open include file lib."));
    EXPECT_THAT(parse(write("binary.pov", std::string("\x7f"
                                                      "ELF\0\0",
                                                      6))),
                testing::HasSubstr("Illegal character in input file, value is 7f."));
}

TEST_F(FilesOnDisk, SizeIsLimited) {
    ParseOptions options;
    options.max_file_bytes = 30;
    const std::string big = write("big.inc", std::string(31, ' '));
    EXPECT_EQ(parse(big, options), "File '" + big + "' is larger than 30 bytes. --limit file=N allows more.");
    EXPECT_EQ(parse(write("scene.pov", "#include \"big.inc\""), options),
              "File '" + big + "' is larger than 30 bytes. --limit file=N allows more.");
    const Outcome o = read_scene(std::string(31, ' '), options);
    EXPECT_TRUE(o.limit);
}

TEST_F(FilesOnDisk, InstalledColorsLoad) {
    if (!std::filesystem::exists("/usr/share/povray-3.7/include/colors.inc")) GTEST_SKIP() << "POV-Ray's include files are not installed";
    // The numbers of the file, in single precision; derived ones by its formulas.
    const std::string scene = write(
        "scene.pov",
        "#include \"colors.inc\"\n"
        "#debug concat(vstr(5,Red,\",\",0,9),\"|\",vstr(3,Gray25,\",\",0,9),\"|\",vstr(3,Orange,\",\",0,9),\"|\",vstr(5,Clear,\",\",0,1))");
    EXPECT_THAT(parse(scene), testing::StartsWith("1.000000000,0.000000000,0.000000000,0.000000000,0.000000000|"
                                                  "0.250000000,0.250000000,0.250000000|1.000000000,0.500000000,0.000000000|"
                                                  "1.0,1.0,1.0,1.0,0.0"));
    const Scene read = parse_file(scene, {}, [](std::string_view) {});
    EXPECT_EQ(read.language_version, 3.7);  // restoring the version states it
    EXPECT_EQ(read.settings.gamma, (Gamma{Gamma::Kind::power, 1.0}));
    const Scene old = parse_file(write("old.pov", "#version 3.6; #include \"colors.inc\""), {}, [](std::string_view) {});
    EXPECT_EQ(old.settings.gamma.kind, Gamma::Kind::legacy);
}

}  // namespace
}  // namespace rt::include_test
