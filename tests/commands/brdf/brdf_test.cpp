// raytrace brdf: values of closed form, passing lines through, judging, and every mistake in a table.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "tests/commands/support.h"

namespace rt::brdf_test {
namespace {

using test::Outcome;
using test::run;

constexpr double pi = 3.14159265358979323846;

class Brdf : public ::testing::Test {
protected:
    /// `brdf eval` with `text` as standard input, through the shell.
    Outcome eval(const std::string& table, const std::string& text) const {
        here.write("in.csv", text);
        const std::string command = std::string(PROGRAM) + " brdf eval " + table + " < in.csv > out.csv 2> err.txt";
        const int status = std::system(command.c_str());
        return {WEXITSTATUS(status), here.read("out.csv"), here.read("err.txt")};
    }
    Outcome check(const std::string& file, const std::string& text) const {
        here.write(file, text);
        return run({"brdf", "check", file});
    }
    test::Workplace here;
};

/// The cells behind the input of the row with that number.
std::vector<double> values(const std::string& out, std::size_t row, std::size_t input_cells) {
    std::istringstream lines(out);
    std::string line;
    for (std::size_t i = 0; i <= row; ++i) std::getline(lines, line);
    std::istringstream cells(line);
    std::vector<double> found;
    std::size_t i = 0;
    for (std::string cell; std::getline(cells, cell, ','); ++i)
        if (i >= input_cells) found.push_back(std::strtod(cell.c_str(), nullptr));
    return found;
}

TEST_F(Brdf, EvalAppendsColumnsAndKeepsEveryLine) {
    const Outcome outcome = eval("terms_F", "# a comment, kept\nid,class,c,ior,k\n\n7,x,1,3,0\r\n8, y ,0.5,1e0,0.0\n");
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out,
              "# a comment, kept\n"
              "id,class,c,ior,k,got_F0,got_F0k,got_F_schlick,got_F_schlick1,got_F_dielectric,got_F_conductor,got_F_schlick_k\n\n"
              "7,x,1,3,0,0.25,0.25,0.25,0.25,0.25,0.25,0.25\n"
              "8, y ,0.5,1e0,0.0,0,0,0.03125,0.5,0,0,0.03125\n");
}

TEST_F(Brdf, EvalTakesNoEvaluatedTable) {
    const Outcome once = eval("terms_F", "# from\nc,ior,k\n1,3,0\n");
    ASSERT_EQ(once.status, 0) << once.err;
    const Outcome twice = eval("terms_F", once.out);
    EXPECT_EQ(twice.status, 1);
    EXPECT_EQ(twice.err, "raytrace: standard input:2: column 'got_F0' is there already: take an earlier evaluation's columns out first\n");
    EXPECT_EQ(twice.out, "");
    EXPECT_EQ(eval("terms_F", "c,ior,k,got_other\n1,3,0,5\n").status, 0);
}

TEST_F(Brdf, AByteOrderMarkIsNoPartOfTheTable) {
    const std::string mark = "\xEF\xBB\xBF";
    EXPECT_EQ(eval("terms_D", mark + "alpha,nh\n0.5,1\n").out, eval("terms_D", "alpha,nh\n0.5,1\n").out);
    const Outcome comment = eval("terms_D", mark + "# x\nalpha,nh\n0.5,1\n");
    EXPECT_EQ(comment.status, 0) << comment.err;
    EXPECT_TRUE(comment.out.starts_with("# x\nalpha"));
}

TEST_F(Brdf, ParametersOutsideOfTheirDomainAreNamedWithTheirPlace) {
    const auto fails = [&](const std::string& table, const std::string& text, const std::string& message) {
        const Outcome outcome = eval(table, text);
        EXPECT_EQ(outcome.status, 1) << text;
        EXPECT_EQ(outcome.err, "raytrace: standard input:2: column " + message + "\n");
        EXPECT_EQ(outcome.out, "");
    };
    const std::string from_0 = "': expected a finite number from 0 on instead of '",
                      above_0 = "': expected a finite number above 0 instead of '", cosine = "': expected a cosine, -1 to 1 instead of '";
    for (const std::string bad : {"nan", "-1", "inf", "-1e-300"}) {
        fails("terms_D", "alpha,nh\n" + bad + ",1\n", "'alpha" + from_0 + bad + "'");
        fails("terms_G", "alpha,nl,nv,nh,vh\n" + bad + ",1,1,1,1\n", "'alpha" + from_0 + bad + "'");
        fails("terms_F", "c,ior,k\n1,1.5," + bad + "\n", "'k" + from_0 + bad + "'");
        fails("terms_F", "c,ior,k\n1," + bad + ",0\n", "'ior" + above_0 + bad + "'");
    }
    fails("terms_F", "c,ior,k\n1,0,0\n", "'ior" + above_0 + "0'");
    for (const std::string bad : {"nan", "2", "-1.0000000000000002", "inf"}) {
        fails("terms_D", "alpha,nh\n1," + bad + "\n", "'nh" + cosine + bad + "'");
        fails("terms_F", "c,ior,k\n" + bad + ",1.5,0\n", "'c" + cosine + bad + "'");
        for (const std::string column : {"nl", "nv", "nh", "vh"}) {
            std::string cells = "1";
            for (const std::string name : {"nl", "nv", "nh", "vh"}) cells += "," + (name == column ? bad : "0.5");
            fails("terms_G", "alpha,nl,nv,nh,vh\n" + cells + "\n", "'" + column + cosine + bad + "'");
        }
    }
}

TEST_F(Brdf, EvalKnowsTheTermsAtTheNormal) {
    const Outcome D = eval("terms_D", "alpha,nh\n0.5,1\n1,0.3\n");
    ASSERT_EQ(D.status, 0) << D.err;
    for (std::size_t i = 0; i < 3; ++i) EXPECT_DOUBLE_EQ(values(D.out, 1, 2).at(i), 4.0 / pi) << i;
    EXPECT_DOUBLE_EQ(values(D.out, 1, 2).at(3), 1.0);
    EXPECT_DOUBLE_EQ(values(D.out, 2, 2).at(0), 1.0 / pi);  // alpha 1: Blinn and GGX are constant
    EXPECT_DOUBLE_EQ(values(D.out, 2, 2).at(2), 1.0 / pi);
    const Outcome G = eval("terms_G", "alpha,nv,nl,nh,vh\n1,0.5,0.5,0.25,1\n");
    ASSERT_EQ(G.status, 0) << G.err;
    const std::vector<double> got = values(G.out, 1, 5);
    EXPECT_DOUBLE_EQ(got.at(0), 0.25);       // 2 nh nv / vh
    EXPECT_DOUBLE_EQ(got.at(1), 2.0 / 3.0);  // 2 c / (c + sqrt(c^2 + 1 - c^2))
    EXPECT_DOUBLE_EQ(got.at(3), 4.0 / 9.0);  // the product of two
    EXPECT_DOUBLE_EQ(got.at(4), 0.5);        // 2 / (1/c + 1/c)
    EXPECT_DOUBLE_EQ(got.at(9), 0.25);       // V of 2 nh nv / vh
    EXPECT_DOUBLE_EQ(got.at(10), 1.0 / 2.25);
}

TEST_F(Brdf, EvalKnowsTheFormsAtTheNormal) {
    // n = l = v: D = 1/(pi alpha^2), V = 1/4, h = n; F0 of index 3 is 1/4.
    const std::string n = "0,0,1,0,0,1,0,0,1", vectors = "nx,ny,nz,lx,ly,lz,vx,vy,vz";
    const Outcome general = eval("general_r", vectors + ",roughness,ior,k,ka,kd,s,lc,sigma,Dname,Gname,Fname,diffuse\n" + n +
                                                  ",0.5,3,0,0.125,0.5,0.25,2,0,ggx,ggx,schlick,lambert\n");
    ASSERT_EQ(general.status, 0) << general.err;
    const double rs = 0.25 * 0.25 * 16.0 / pi;
    const std::vector<double> want{16.0 / pi, 1.0, 0.25, 0.5, rs, 0.125 + 2.0 * (0.75 * 0.5 + 0.25 * rs)};
    for (std::size_t i = 0; i < want.size(); ++i) EXPECT_DOUBLE_EQ(values(general.out, 1, 21).at(i), want[i]) << i;

    const Outcome effects =
        eval("seed0_effectsbrowser", vectors + ",m,F0,ks,kd,ka,dc,il,power,dw\n" + n + ",0.5,0.25,0.5,0.5,0.5,1,2,10,0.01\n");
    ASSERT_EQ(effects.status, 0) << effects.err;
    const double ct = 0.01 * 0.5 * 0.25 / pi;  // dw ks F / (4 m^2 pi nv)
    const std::vector<double> shown{0.5, 1.0, 1.0, ct, ct, ct, ct, 0.25, 0.25, 2.0 * ct};
    for (std::size_t i = 0; i < shown.size(); ++i) EXPECT_DOUBLE_EQ(values(effects.out, 1, 18).at(i), shown[i]) << i;

    const Outcome lecture = eval("seed4_lecture", vectors + ",m,ratio,ka,ks,rho,Ia,Ii\n" + n + ",0.5,3,0.25,0.25,0.5,2,4\n");
    ASSERT_EQ(lecture.status, 0) << lecture.err;
    EXPECT_DOUBLE_EQ(values(lecture.out, 1, 16).at(4), 0.5 + 4.0 * (0.25 + 0.25 * 0.25 / pi));

    const Outcome gooch = eval("seed2_gooch", vectors + ",roughness,ior,kcool,kwarm,Dname\n" + n + ",0.5,3,0.25,0.75,beckmann\n");
    ASSERT_EQ(gooch.status, 0) << gooch.err;
    const std::vector<double> tones{rs, rs, 0.25, 0.75};
    for (std::size_t i = 0; i < tones.size(); ++i) EXPECT_DOUBLE_EQ(values(gooch.out, 1, 14).at(i), tones[i]) << i;

    // A spot two units above, shining down; the eye is there, too.
    const Outcome phong = eval("seed3_phong_lights",
                               "light,nx,ny,nz,px,py,pz,ex,ey,ez,lpx,lpy,lpz,sdx,sdy,sdz,shininess,spot_exp,range,Ma,Ca,Md,Cd,Ms,Cs\n"
                               "spot,0,0,1,0,0,0,0,0,2,0,0,2,0,0,-3,5,7,1e30,0.5,0.5,1,0.5,1,0.25\n");
    ASSERT_EQ(phong.status, 0) << phong.err;
    const std::vector<double> lit{2, 1, 1, 0.25, 0.5, 0.25, 0.25, 1.0 / 7.0, 1, 0.25 + 0.75 / 7.0, 1.0 / 7.0};
    for (std::size_t i = 0; i < lit.size(); ++i) EXPECT_DOUBLE_EQ(values(phong.out, 1, 25).at(i), lit[i]) << i;
}

TEST_F(Brdf, EvalTakesTheExtremesOfNumbers) {
    const Outcome outcome = eval("terms_D", "alpha,nh\n2,4.9406564584124654e-324\n1e200,1\n0,1\n1,0\n");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const std::vector<double> horizon = values(outcome.out, 1, 2);  // (n.h)^-1.5 is beyond doubles, GGX is alpha^2 / pi
    EXPECT_EQ(horizon.at(0), HUGE_VAL);
    EXPECT_EQ(horizon.at(1), 0.0);
    EXPECT_DOUBLE_EQ(horizon.at(2), 4.0 / pi);
    EXPECT_EQ(horizon.at(3), 0.0);
    for (const std::size_t row : {2u, 3u}) {  // nothing is left of the one, the other is the mirror ray's business
        ASSERT_EQ(values(outcome.out, row, 2).size(), 4u);
        for (const double value : values(outcome.out, row, 2)) EXPECT_EQ(value, 0.0);
    }
    EXPECT_DOUBLE_EQ(values(outcome.out, 4, 2).at(0), 1.0 / pi);  // alpha 1 has no exponent to take
    const Outcome masking = eval("terms_G", "alpha,nl,nv,nh,vh\n1e200,1,0.5,0.5,0.5\n1e200,0.5,1,0.5,0.5\n0,1,1,1,1\n");
    ASSERT_EQ(masking.status, 0) << masking.err;
    for (std::size_t row = 1; row <= 3; ++row) {
        ASSERT_EQ(values(masking.out, row, 5).size(), 13u);
        for (const double value : values(masking.out, row, 5)) EXPECT_TRUE(value >= 0.0 && value <= 1.0) << row << ": " << value;
    }
}

/// What the contract is about: directions that are none.
TEST_F(Brdf, DirectionsMayBeNone) {
    const std::string head = "nx,ny,nz,lx,ly,lz,vx,vy,vz,roughness,ior,k,ka,kd,s,lc,sigma,Dname,Gname,Fname,diffuse\n";
    const std::string rest = ",0.5,1.5,0,0.125,0.5,0.25,2,0,ggx,ggx,schlick,lambert\n";
    const Outcome outcome =
        eval("contract", head + "0,0,0,0,0,1,0,0,1" + rest + "0,0,1,nan,0,1,0,0,1" + rest + "0,0,1,0,0,1,0,inf,nan" + rest);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    for (std::size_t row = 1; row <= 3; ++row) EXPECT_EQ(values(outcome.out, row, 21), (std::vector<double>{0, 0, 0, 0, 0, 0.125})) << row;
}

TEST_F(Brdf, CheckPassesAndFailsByTheTolerance) {
    // F = 1/4 exactly; the tolerance is 256 half units in the last place: 0.25 * 2.8e-14.
    const std::string head = "# by hand\nid,class,c,ior,k,F_schlick,F_dielectric,F_conductor\n";
    const Outcome good = check("terms_F.csv", head + "0,x,1,3,0,0.25,0.250000000000001,0.25\n");
    EXPECT_EQ(good.status, 0) << good.err;
    EXPECT_EQ(good.out,
              "terms_F.csv\n"
              "  F_schlick            1 rows  largest 0 at id 0  beyond 0\n"
              "  F_dielectric         1 rows  largest 0.141 at id 0  beyond 0\n"
              "  F_conductor          1 rows  largest 0 at id 0  beyond 0\n");
    const Outcome bad = check("terms_F.csv", head +
                                                 "0,x,1,3,0,0.25,0.25,0.25\n4,x,1,3,0,0.25,0.25000000000001,0.25\n5,x,1,3,0,0.25,-inf,inf\n"
                                                 "6,critical,1,3,0,0.25,0.2500003,0.25\n");
    EXPECT_EQ(bad.status, 1);
    EXPECT_EQ(bad.err, "");
    EXPECT_EQ(bad.out,
              "terms_F.csv\n"
              "  F_schlick            4 rows  largest 0 at id 0  beyond 0\n"
              "  F_dielectric         4 rows  largest inf at id 5  beyond 2\n"
              "  F_conductor          4 rows  largest inf at id 5  beyond 1\n"
              "  beyond: id 4 F_dielectric wanted 0.25000000000000999 got 0.25 fraction 1.41\n"
              "  beyond: id 5 F_dielectric wanted -inf got 0.25 fraction inf\n"
              "  beyond: id 5 F_conductor wanted inf got 0.25 fraction inf\n");
    EXPECT_EQ(run({"brdf", "check", "terms_F.csv", "terms_F.csv"}).out, bad.out + bad.out);
}

TEST_F(Brdf, MistakesInATableAreNamedWithTheirPlace) {
    const std::string names =
        "contract, general_r, seed0_effectsbrowser, seed2_gooch, seed3_phong_lights, seed4_lecture, terms_D, terms_G, terms_F";
    const auto fails = [&](const std::string& file, const std::string& text, const std::string& message) {
        const Outcome outcome = check(file, text);
        EXPECT_EQ(outcome.status, 1) << text;
        EXPECT_EQ(outcome.err, "raytrace: " + message + "\n");
        EXPECT_EQ(outcome.out, "");
    };
    const std::string head = "id,class,alpha,nh,D_blinn,D_beckmann,D_ggx\n";
    fails("terms_E.csv", head, "terms_E.csv: the name is no table's; expected one of " + names + ", or one in front of the files");
    fails("terms_D.csv", "# x\n" + head + "\n# y\n", "terms_D.csv: no rows");
    fails("terms_D.csv", "", "terms_D.csv: no header line with the names of the columns");
    fails("terms_D.csv", "# only this\n\n", "terms_D.csv: no header line with the names of the columns");
    fails("terms_D.csv", "# x\nid,class,alpha,nh,D_blin,D_beckmann,D_ggx\n", "terms_D.csv:2: no column 'D_blinn'; did you mean 'D_blin'?");
    fails("terms_D.csv", "D_blin\x1b\n", "terms_D.csv:1: no column 'D_blinn'; did you mean 'D_blin?'?");
    fails("terms_D.csv", "id,alpha,nh,id\n", "terms_D.csv:1: column 'id' appears twice");
    fails("terms_D.csv", head + "0,x,1,1,1,1\n", "terms_D.csv:2: 6 cells under a header of 7");
    fails("terms_D.csv", head + "\n0,x,1,1.0.0,1,1,1\n", "terms_D.csv:3: column 'nh': '1.0.0' is not a number");
    fails("terms_D.csv", head + "0,x,,1,1,1,1\n", "terms_D.csv:2: column 'alpha': '' is not a number");
    fails("terms_D.csv", head + "0,x,1,1,one,1,1\n", "terms_D.csv:2: column 'D_blinn': 'one' is not a number");
    fails("terms_D.csv", head + "0,x,1\x01" + std::string(60, 'y') + ",1,1,1,1\n",
          "terms_D.csv:2: column 'alpha': '1?" + std::string(38, 'y') + "...' is not a number");
    fails("seed2_gooch.csv",
          "id,nx,ny,nz,lx,ly,lz,vx,vy,vz,roughness,ior,kcool,kwarm,Dname,k_spec,k_spec_literal,gooch,gooch_literal,kappa,kappa_literal\n"
          "0,0,0,1,0,0,1,0,0,1,1,1,0,0,gxg,0,0,0,0,0,0\n",
          "seed2_gooch.csv:2: 'gxg' is no D; expected one of ggx, beckmann, blinn, gaussian");
    const Outcome light = eval("seed3_phong_lights", "light\nlaser\n");
    EXPECT_EQ(light.status, 1);
    EXPECT_EQ(light.err, "raytrace: standard input:2: 'laser' is no light; expected one of parallel, point, spot\n");
    EXPECT_EQ(light.out, "");
    EXPECT_EQ(eval("nothing", "").err, "raytrace: brdf eval: no table 'nothing'; expected one of " + names + "\n");
    EXPECT_EQ(run({"brdf", "check", "gone/terms_D.csv"}).err, "raytrace: cannot open 'gone/terms_D.csv': No such file or directory\n");
}

TEST_F(Brdf, CheckJudgesEveryFileWhateverTheOthersAre) {
    const std::string good = "id,class,c,ior,k,F_schlick,F_dielectric,F_conductor\n0,x,1,3,0,0.25,0.25,0.25\n";
    here.write("terms_F.csv", good);
    here.write("pictures.csv", "a,b\n");
    here.write("terms_D.csv", "id,alpha\n");
    const std::string verdict = run({"brdf", "check", "terms_F.csv"}).out;
    const Outcome all = run({"brdf", "check", "pictures.csv", "gone.csv", "terms_D.csv", "terms_F.csv"});
    EXPECT_EQ(all.status, 1);
    EXPECT_EQ(all.out, verdict);
    EXPECT_TRUE(all.err.starts_with("raytrace: pictures.csv: the name is no table's; expected one of contract, ")) << all.err;
    EXPECT_NE(all.err.find("\nraytrace: cannot open 'gone.csv': No such file or directory\n"), std::string::npos) << all.err;
    EXPECT_NE(all.err.find("\nraytrace: terms_D.csv:1: no column 'D_blinn'"), std::string::npos) << all.err;
    here.write("terms_G.csv", std::string(1000, ','));
    EXPECT_EQ(run({"brdf", "check", "terms_G.csv", "pictures.csv", "terms_F.csv"}).status, 4);
}

TEST_F(Brdf, CheckTakesATablesNameInFrontOfFiles) {
    const std::string good = "id,class,c,ior,k,F_schlick,F_dielectric,F_conductor\n0,x,1,3,0,0.25,0.25,0.25\n";
    here.write("mine.csv", good);
    here.write("terms_D.csv", good);
    const Outcome stated = run({"brdf", "check", "terms_F", "mine.csv", "terms_D.csv"});
    EXPECT_EQ(stated.status, 0) << stated.err;
    EXPECT_TRUE(stated.out.starts_with("mine.csv\n  F_schlick            1 rows")) << stated.out;
    EXPECT_NE(stated.out.find("\nterms_D.csv\n  F_schlick            1 rows"), std::string::npos) << stated.out;
    EXPECT_EQ(run({"brdf", "check", "terms_F"}).err, "raytrace: cannot open 'terms_F': No such file or directory\n");
}

/// Tables kept outside of the project; skipped, and said so, where they are missing.
TEST(BrdfTables, EveryOneIsWithinItsTolerance) {
    const std::string folder = PROJECT_ROOT "/../shared/golden/";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "not present: " << folder;
    std::vector<std::string> words{"brdf", "check"};
    for (const char* name : {"contract", "general_r", "seed0_effectsbrowser", "seed2_gooch", "seed3_phong_lights", "seed4_lecture",
                             "terms_D", "terms_F", "terms_G"})
        words.push_back(folder + name + ".csv");
    const test::Workplace here;
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
    EXPECT_EQ(outcome.out.find("beyond:"), std::string::npos);
}

TEST_F(Brdf, TablesHaveLimits) {
    const Outcome lines = check("terms_D.csv", "id\n" + std::string(1'000'000, '\n'));
    EXPECT_EQ(lines.status, 4);
    EXPECT_EQ(lines.err, "raytrace: terms_D.csv: more than 1000000 lines\n");
    const Outcome columns = check("terms_D.csv", std::string(1000, ','));
    EXPECT_EQ(columns.status, 4);
    EXPECT_EQ(columns.err, "raytrace: terms_D.csv: more than 1000 columns\n");
    // The limit itself may be read: 32 MiB of zeros are a header. One byte more may not, nor what has no end.
    here.write("terms_D.csv", "");
    std::filesystem::resize_file("terms_D.csv", 32u << 20);
    EXPECT_EQ(run({"brdf", "check", "terms_D.csv"}).status, 1);
    std::filesystem::resize_file("terms_D.csv", (32u << 20) + 1);
    const Outcome larger = run({"brdf", "check", "terms_D.csv"});
    EXPECT_EQ(larger.status, 4);
    EXPECT_EQ(larger.err, "raytrace: terms_D.csv is larger than 32 MiB\n");
    const Outcome endless = run({"brdf", "check", "terms_D", "/dev/zero"});
    EXPECT_EQ(endless.status, 4);
    EXPECT_EQ(endless.err, "raytrace: /dev/zero is larger than 32 MiB\n");
    const Outcome bytes = eval("terms_D", std::string(33u << 20, '#'));
    EXPECT_EQ(bytes.status, 4);
    EXPECT_EQ(bytes.err, "raytrace: standard input is larger than 32 MiB\n");
}

TEST_F(Brdf, WrongWordsSayWhatIsExpected) {
    const std::string see = "; see raytrace brdf --help\n";
    EXPECT_EQ(run({"brdf"}).err, "raytrace: brdf: expected 'eval', 'check', 'normalization', 'albedo' or 'plot'" + see);
    EXPECT_EQ(run({"brdf", "evil"}).err,
              "raytrace: brdf: expected 'eval', 'check', 'normalization', 'albedo' or 'plot' instead of 'evil'" + see);
    EXPECT_EQ(run({"brdf", "eval"}).err, "raytrace: brdf eval: expected one table's name" + see);
    EXPECT_EQ(run({"brdf", "check"}).err, "raytrace: brdf check: expected a file" + see);
    EXPECT_EQ(run({"brdf"}).status, 1);
    EXPECT_EQ(run({"help", "brdf"}).out, run({"brdf", "--help"}).out);
}

TEST_F(Brdf, IntegralsOfTheChosenTerms) {
    const Outcome one = run({"brdf", "normalization", "--D", "ggx", "--alpha", "0.5"});
    EXPECT_EQ(one.status, 0);
    const std::string head =
        "integral of D (n.m) over the hemisphere; 1 if normalised\n"
        "D                             alpha 0.5           \n"
        "ggx                           ";
    ASSERT_EQ(one.out.substr(0, head.size()), head);
    EXPECT_NEAR(std::stod(one.out.substr(head.size())), 1.0, 1e-12);
    const Outcome albedo = run({"brdf", "albedo", "--D=ggx", "--G=none", "--alpha=1"});
    EXPECT_EQ(albedo.out,
              "directional albedo with F = 1 at n.v = 1 / 0.5 / 0.1\n"
              "D, G                          alpha 1             \n"
              "ggx, none                     0.500/1.000/5.000   \n");
    EXPECT_EQ(run({"brdf", "albedo", "--D=phong"}).err, "raytrace: 'phong' is no D; expected one of ggx, beckmann, blinn, gaussian\n");
    EXPECT_EQ(run({"brdf", "albedo", "--alpha=0"}).status, 1);
    const std::string elsewhere = "raytrace: brdf: --D and --alpha are for normalization and albedo, --G for albedo\n";
    EXPECT_EQ(run({"brdf", "normalization", "--G=ggx"}).err, elsewhere);
    EXPECT_EQ(run({"brdf", "check", "--D=ggx", "terms_D.csv"}).err, elsewhere);
}

}  // namespace
}  // namespace rt::brdf_test
