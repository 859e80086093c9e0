// What POV-Ray and we print, as values.
#include "commands/versus/program_told.h"

#include <gtest/gtest.h>

namespace rt::program_told_test {
namespace {

// Laid out as POV-Ray 3.7 does.
constexpr const char* statistics = R"(Parser Time
  Parse Time:       0 hours  1 minutes  2 seconds (62.125 seconds)
              using 1 thread(s) with 61.000 CPU-seconds total
  Bounding Time:    0 hours  0 minutes  0 seconds (0.250 seconds)
Pixels:            81840   Samples:           26786   Smpls/Pxl: 0.33
Rays:             108626   Saved:                 0   Max Level: 1/5
Shadow Ray Tests:            101838   Succeeded:                  8930
  Photon Time:      0 hours  0 minutes  1 seconds (1.500 seconds)
  Radiosity Time:   No radiosity
  Trace Time:       0 hours  0 minutes  0 seconds (0.052 seconds)
              using 2 thread(s) with 0.038 CPU-seconds total
)";

TEST(ProgramTold, TimesAndCountsOfPovray) {
    VersusRun run;
    read_povray_statistics(statistics, run);
    EXPECT_EQ(run.phases.parse, 62.125);
    EXPECT_EQ(run.phases.build, 0.25);
    EXPECT_EQ(run.phases.trace, 1.552);
    EXPECT_EQ(run.phases.write, 0.0);
    EXPECT_EQ(run.rays, 108626u);
    EXPECT_EQ(run.shadow_tests, 101838u);
    read_povray_statistics("\nRays: 5\n  Parse Time: (seconds (7 seconds)\n" + std::string(statistics), run);  // printed by a scene
    EXPECT_EQ(run.rays, 108626u);
    EXPECT_EQ(run.phases.parse, 62.125);
    read_povray_statistics("nothing of the kind", run);
    EXPECT_EQ(run.phases.trace, 0.0);
    EXPECT_EQ(run.rays, 0u);
}

TEST(ProgramTold, AMessageOverSeveralLinesIsOne) {
    EXPECT_EQ(povray_message("==== [Parsing...] ====\nFile 'bad.pov' line 1: Parse Error: No matching } in 'sphere', undeclared\n"
                             " identifier 'pigmnt' found instead\nFatal error in parser: Cannot parse input.\nRender failed\n\n"),
              "File 'bad.pov' line 1: Parse Error: No matching } in 'sphere', undeclared identifier 'pigmnt' found instead");
    EXPECT_EQ(povray_message("one\ntwo\n-----------\n\n"), "two");
    EXPECT_EQ(povray_message(""), "");
    // Warnings look like errors; the one that ended it is the last.
    EXPECT_EQ(
        povray_message("File 'a.pov' line 1: Possible Parse Error: gamma\nFile 'a.pov' line 9: Parse Error: this\nFatal error in parser\n"),
        "File 'a.pov' line 9: Parse Error: this");
    EXPECT_EQ(our_message("a.pov:1: Parse Warning: w\nFile 'a.pov' line 2: Possible Parse Error: no file\n   2 | #include\n"
                          "File 'a.pov' line 2: Parse Error: this\n   2 | #include\n     | ^^^\n"),
              "File 'a.pov' line 2: Parse Error: this");
    EXPECT_LT(our_message(std::string(1u << 20, 'x')).size(), 1100u);
}

TEST(ProgramTold, LinesThatPovrayCutsAreWhole) {
    const std::string line = "File '/" + std::string(73, 'a');
    EXPECT_EQ(povray_lines("one\n\n" + line + "\nb.pov' line 5: Parse Error: no\n number\nFatal error in parser\n"),
              "one\n" + line + "b.pov' line 5: Parse Error: no\n number\nFatal error in parser\n");
    EXPECT_EQ(povray_lines(line + "\nFatal error in parser: no\n"), line + "\nFatal error in parser: no\n");
    EXPECT_EQ(povray_lines(line + "\nRender failed\n"), line + "\nRender failed\n");
    EXPECT_EQ(povray_lines(line + "a\nb"), line + "a\nb");
    EXPECT_EQ(povray_message(povray_lines(line + "\n.pov' line 5: Parse Error: no\n number\n")),
              line + ".pov' line 5: Parse Error: no number");
}

TEST(ProgramTold, WhereAMistakeIsHasNoFolder) {
    EXPECT_EQ(refused_place("File '/x/a.pov' line 5: Parse Error: no"), "a.pov line 5");
    EXPECT_EQ(refused_place("File 'a.pov' line 5: Parse Error: File 'b' line 6: Parse Error: no"), "a.pov line 5");
    EXPECT_EQ(refused_place("File '/x/it's' line 1.pov' line 12: Parse Error: no"), "it's' line 1.pov line 12");
    EXPECT_EQ(refused_place("File '/x/a\x01.pov' line 5: Parse Error: no"), "a?.pov line 5");
    EXPECT_EQ(refused_place("File 'a.pov': Parse Error: Cannot open input file."), "");
    EXPECT_EQ(refused_place("a.pov' line 5: Parse Error: no"), "");
    EXPECT_EQ(refused_place("File 'a.pov' line 5: Parse Warning: no"), "");
    EXPECT_EQ(refused_place(""), "");
}

TEST(ProgramTold, VersionsOfPovrayAndOfOthers) {
    EXPECT_EQ(povray_version("povray: cannot open something\nPOV-Ray 3.7.0.10.unofficial\n\nCopyright\n"), "POV-Ray 3.7.0.10.unofficial");
    EXPECT_EQ(povray_version("GNU bash, version 5"), "");
}

TEST(ProgramTold, OurOwnStatistics) {
    VersusRun run;
    read_our_statistics(
        "a warning\ntime: parse 0.0001 s, build 0.0009 s, trace 0.1336 s, write 0.0023 s\nrays:\n  camera            104839     0.785 M/s\n"
        "  shadow             98583     0.738 M/s\n  reflected             20     0.000 M/s\n  refracted              3     0.000 M/s\n"
        "  all               203422     1.523 M/s\n",
        run);
    EXPECT_EQ(run.phases.parse, 0.0001);
    EXPECT_EQ(run.phases.build, 0.0009);
    EXPECT_EQ(run.phases.trace, 0.1336);
    EXPECT_EQ(run.phases.write, 0.0023);
    EXPECT_EQ(run.rays, 104862u);
    EXPECT_EQ(run.shadow_tests, 98583u);
}

}  // namespace
}  // namespace rt::program_told_test
