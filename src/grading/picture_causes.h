// Why a picture is wrong, as far as two pictures alone can tell: mistakes that treat all pixels alike, whatever scene they show.
#pragma once

#include "grading/color_picture.h"
#include "grading/finding.h"

namespace rt {

/// Every hypothesis that explains some of the difference, each with what it leaves; the more special ones first. Both pictures have the
/// same size. What is found are, by `Finding::cause`: "black", "one colour", "unfinished", "mirrored", "upside down", "turned by 180
/// degrees", "channels swapped", "negative", "gamma missing", "gamma twice", "exposure", "another tone curve", "shifted",
/// "half-pixel shift", "missing anti-aliasing", "needless anti-aliasing", "noise", "shadow acne".
std::vector<Finding> picture_findings(const ColorPicture& expected, const ColorPicture& actual);

/// How far `actual` is from `predicted`.
Misfit misfit(const ColorPicture& predicted, const ColorPicture& actual);

/// "12 of 307200 pixels differ then, 21000 as it is".
std::string pixels_left(const Misfit& left, const Misfit& whole, const ColorPicture& picture);

/// Of the squared difference in parts where the expected picture is smooth, the share that is left beside the mean of each 3 x 3 pixels:
/// 8/9 of independent noise, next to nothing of a surface that is wrong as a whole.
double roughness_of(const ColorPicture& expected, const ColorPicture& actual);

// Its parts.
std::vector<Finding> tone_findings(const ColorPicture& expected, const ColorPicture& actual, const Misfit& whole);
std::vector<Finding> shift_findings(const ColorPicture& expected, const ColorPicture& actual, const Misfit& whole);
std::vector<Finding> grain_findings(const ColorPicture& expected, const ColorPicture& actual, const Misfit& whole);

}  // namespace rt
