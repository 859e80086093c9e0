// The tables of shading values that the program can compute, each by the functions that the renderer runs.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "commands/brdf/brdf_table.h"

namespace rt {

/// A column that is judged. `tolerance` is the largest absolute error of a good double implementation where `want` is right.
struct JudgedColumn {
    std::string_view column;
    std::function<double(const BrdfRow& row, double want)> tolerance;
};

/// One kind of table. `evaluate` needs the columns of input only and gives a value for each of `columns`, in their order.
struct BrdfKind {
    std::string_view name;
    std::vector<std::string_view> columns;
    std::function<std::vector<double>(const BrdfRow&)> evaluate;
    std::vector<JudgedColumn> judged;  ///< some of `columns`
};

const std::vector<BrdfKind>& brdf_kinds();
/// The kind of that name, or nullptr.
const BrdfKind* find_brdf_kind(std::string_view name);
/// Separated by commas, for messages.
std::string brdf_kind_names();

// The evaluations, by the source of their formulas. A parameter outside of its domain is a mistake of the row. Vectors are used as given,
// none is made a unit vector but seed3's l and v.
std::vector<double> brdf_D_row(const BrdfRow& row);
std::vector<double> brdf_G_row(const BrdfRow& row);
std::vector<double> brdf_F_row(const BrdfRow& row);
std::vector<double> brdf_general_row(const BrdfRow& row);
std::vector<double> brdf_effects_row(const BrdfRow& row);
std::vector<double> brdf_gooch_row(const BrdfRow& row);
std::vector<double> brdf_phong_row(const BrdfRow& row);
std::vector<double> brdf_lecture_row(const BrdfRow& row);

}  // namespace rt
