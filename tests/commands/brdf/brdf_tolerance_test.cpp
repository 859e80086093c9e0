// raytrace brdf check: what is right, what is beyond its tolerance by a little to either side, and what cannot be judged. The tolerances
// are written out here a second time, from those of the tables' makers.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include "tests/commands/brdf/brdf_support.h"
#include "tests/commands/support.h"

namespace rt::brdf_tolerance_test {
namespace {

using test::Cells;
using test::Outcome;
using test::run;

constexpr double e = 0x1p-53;

using Tolerance = std::function<double(double want)>;
Tolerance units(double count, double absolute) {
    return [=](double want) { return e * count * std::fabs(want) + absolute; };
}
Tolerance by_condition(double kappa) { return units(32.0 + 4.0 * kappa, 1e-60); }

/// One row of inputs of a table and the tolerance of every column that is judged.
struct Judged {
    std::string table;
    Cells inputs;
    std::map<std::string, Tolerance> tolerances;
};

Cells oblique() { return Cells().add("n", Vec3(2, 3, 6) / 7.0).add("l", Vec3(1, 2, 2) / 3.0).add("v", Vec3(-6, 2, 3) / 7.0); }

Cells general(double lc) {
    return oblique()
        .add("roughness", 0.7)
        .add("ior", 1.6)
        .add("k", 0.5)
        .add("ka", 1e-4)
        .add("kd", 0.6)
        .add("s", 0.3)
        .add("lc", lc)
        .add("sigma", 0.6)
        .add("Dname", "ggx")
        .add("Gname", "ggx")
        .add("Fname", "schlick")
        .add("diffuse", "oren-nayar");
}

std::vector<Judged> terms() {
    const double alpha = 0.2, nh = 0.9, tan2 = (1.0 - nh) * (1.0 + nh) / (nh * nh);
    const Tolerance D = [=](double want) { return e * (32.0 + 4.0 * std::fabs(std::log(want)) + 4.0 * tan2 / (alpha * alpha)) * want; };
    const Tolerance relative = units(256.0, 1e-300);
    const auto all = [](std::initializer_list<const char*> columns, const Tolerance& tolerance) {
        std::map<std::string, Tolerance> tolerances;
        for (const char* column : columns) tolerances[column] = tolerance;
        return tolerances;
    };
    const Cells F = Cells().add("class", "random").add("c", 0.3).add("ior", 1.4).add("k", 0.8);
    const Cells G = Cells().add("alpha", 0.4).add("nv", 0.3).add("nl", 0.8).add("nh", 0.7).add("vh", 0.6);
    return {{"terms_D", Cells().add("alpha", alpha).add("nh", nh), all({"D_blinn", "D_beckmann", "D_ggx"}, D)},
            {"terms_D", Cells().add("alpha", 1e-3).add("nh", 0.5), all({"D_beckmann"}, [](double) { return 1e-300; })},
            {"terms_G", G, all({"G_ct", "G_ggx", "G_ggx_hc", "G_beck", "Vis_ct", "Vis_ggx"}, relative)},
            {"terms_F", F, all({"F_schlick", "F_dielectric", "F_conductor"}, relative)},
            {"terms_F", F.with("class", "critical"), all({"F_schlick", "F_dielectric", "F_conductor"}, [](double) { return 4e-7; })}};
}

std::vector<Judged> forms() {
    const Cells lights = Cells()
                             .add("light", "spot")
                             .add("n", Vec3(2, 3, 6) / 7.0)
                             .add("p", Vec3(1, 2, 3))
                             .add("e", Vec3(-5, 4, 6))
                             .add("lp", Vec3(3, 6, 7))
                             .add("sd", Vec3(-1, -1, -3));
    const Cells phong = Cells(lights).add("shininess", 4.0).add("spot_exp", 5.0).add("range", 1e30);
    const Cells effects = oblique().add("m", 0.6).add("F0", 0.2).add("ks", 0.9).add("kd", 0.7).add("ka", 0.3).add("dc", 0.8).add("il", 1.5);
    const Cells gooch = oblique().add("roughness", 0.8).add("ior", 1.6).add("kcool", 0.2).add("kwarm", 0.9).add("Dname", "ggx");
    const Cells lecture = oblique().add("m", 0.6).add("ratio", 1.8).add("ka", 0.1).add("ks", 0.3).add("rho", 0.7).add("Ia", 0.9);
    const Tolerance total = [](double want) { return 1e-9 * (1.0 + std::fabs(want)); };
    return {
        {"contract", general(1e-3), {{"r", units(4.0, 1e-16)}}},
        {"contract", general(1e6), {{"r", units(4.0, 1e-16)}}},
        {"general_r", general(2.0).add("kappa_rs", 50.0).add("kappa_r", 900.0), {{"rs", by_condition(50.0)}, {"r", by_condition(900.0)}}},
        {"seed0_effectsbrowser",
         Cells(effects)
             .add("power", 7.0)
             .add("dw", 0.05)
             .add("kappa_linear", 20.0)
             .add("kappa_simplified", 70.0)
             .add("kappa_vh", 300.0)
             .add("kappa_cube", 1000.0),
         {{"ct_linear", by_condition(20.0)},
          {"ct_simplified", by_condition(70.0)},
          {"ct_vh", by_condition(300.0)},
          {"cube", by_condition(1000.0)},
          {"ambient", units(64.0, 0.0)},
          {"diffuse", units(256.0, 1e-15)},
          {"phong_spec", units(64.0 + 64.0 * 7.0, 1e-15)}}},
        {"seed2_gooch",
         Cells(gooch).add("kappa", 40.0).add("kappa_literal", 500.0),
         {{"k_spec", by_condition(40.0)},
          {"k_spec_literal", by_condition(500.0)},
          {"gooch", units(0.0, 1e-14)},
          {"gooch_literal", units(0.0, 1e-14)}}},
        {"seed3_phong_lights",
         Cells(phong).add("Ma", 0.5).add("Ca", 0.4).add("Md", 0.9).add("Cd", 0.8).add("Ms", 0.7).add("Cs", 0.6),
         {{"La", units(64.0, 0.0)}, {"Ld", units(0.0, 1e-13)}, {"att", units(256.0, 0.0)}, {"total", total}, {"total_seed", total}}},
        {"seed4_lecture", Cells(lecture).add("Ii", 1.6).add("kappa", 60.0), {{"I", by_condition(60.0)}}}};
}

/// The row with every judged column as the program computes it.
Cells right_row(const Judged& judged) {
    const auto values = test::evaluated(judged.table, judged.inputs);
    Cells row = judged.inputs;
    row.add("id", "right");
    for (const JudgedColumn& judgement : find_brdf_kind(judged.table)->judged) {
        const std::string column(judgement.column);
        row.add(column, values.at(column));
    }
    return row;
}

/// A row for each column, side and share of the tolerance; those of a share above 1 must be found.
void expect_judged_by_tolerance(const Judged& judged) {
    const std::string file = judged.table + ".csv";
    const test::Workplace here;
    const Cells right = right_row(judged);
    const auto values = test::evaluated(judged.table, judged.inputs);
    std::string text = right.header() + right.row();
    std::set<std::string> expected, found;
    for (const auto& [column, tolerance] : judged.tolerances)
        for (const double side : {-1.0, 1.0})
            for (const double share : {0.75, 1.3}) {  // a few units in the last place apart where the tolerance is least
                const double got = values.at(column), want = got + side * share * tolerance(got);
                ASSERT_EQ(std::fabs(want - got) > tolerance(want), share > 1.0) << judged.table << " " << column;
                const std::string id = fmt::format("{}{:+.2f}", column, side * share);
                text += right.with("id", id).with(column, want).row();
                if (share > 1.0) expected.insert(fmt::format("{} {}", id, column));
            }
    here.write(file, text);
    const Outcome outcome = run({"brdf", "check", file});
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    const std::string mark = "  beyond: id ";
    for (std::size_t at = outcome.out.find(mark); at != std::string::npos; at = outcome.out.find(mark, at + 1)) {
        const std::size_t begin = at + mark.size();
        found.insert(outcome.out.substr(begin, outcome.out.find(" wanted", begin) - begin));
    }
    EXPECT_EQ(found, expected) << outcome.out << outcome.err;
}

TEST(BrdfTolerances, OfTermsDivideRightFromWrongOnEitherSide) {
    for (const Judged& judged : terms()) expect_judged_by_tolerance(judged);
}

TEST(BrdfTolerances, OfFormsDivideRightFromWrongOnEitherSide) {
    for (const Judged& judged : forms()) expect_judged_by_tolerance(judged);
}

TEST(BrdfTolerances, EveryJudgedColumnIsAmongThem) {
    std::set<std::string> tried, judged;
    for (const std::vector<Judged>& all : {terms(), forms()})
        for (const Judged& one : all)
            for (const auto& [column, tolerance] : one.tolerances) tried.insert(one.table + " " + column);
    for (const BrdfKind& kind : brdf_kinds())
        for (const JudgedColumn& column : kind.judged) judged.insert(fmt::format("{} {}", kind.name, column.column));
    EXPECT_EQ(tried, judged);
}

/// `brdf check` of one row that ought to be refused.
void expect_refused(const std::string& table, const Cells& row, const std::string& message) {
    const test::Workplace here;
    here.write(table + ".csv", "# a table\n" + row.header() + row.row());
    const Outcome outcome = run({"brdf", "check", table + ".csv"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "raytrace: " + table + ".csv:3: column " + message + "\n");
    EXPECT_EQ(outcome.out, "");
}

TEST(BrdfTolerances, WhatCannotBeJudgedIsAMistakeOfItsRow) {
    const Judged form = forms()[2];
    ASSERT_EQ(form.table, "general_r");
    const Cells row = right_row(form);
    const std::string expected = "': expected a finite number from 0 on instead of '";
    for (const char* kappa : {"inf", "-1e9", "nan", "-0.5"}) {
        expect_refused("general_r", row.with("kappa_rs", kappa), "'kappa_rs" + expected + kappa + "'");
        expect_refused("general_r", row.with("kappa_r", kappa), "'kappa_r" + expected + kappa + "'");
    }
    expect_refused("general_r", row.with("kappa_r", "1e308").with("r", "1e20"),
                   "'r': its tolerance is inf, expected a finite number from 0 on");
    expect_refused("general_r", row.with("r", "nan"), "'r': expected a number instead of 'nan'");
    const Cells D = right_row(terms()[0]);
    expect_refused("terms_D", D.with("D_ggx", "-nan"), "'D_ggx': expected a number instead of '-nan'");
    expect_refused("terms_D", D.with("nh", "0"), "'D_blinn': its tolerance is inf, expected a finite number from 0 on");
}

}  // namespace
}  // namespace rt::brdf_tolerance_test
