// How far apart two pictures are for an eye that forgives one pixel: each pixel beside the best of nine.
#pragma once

#include "film/image_file.h"

namespace rt {

/// The mean over all pixels of the largest channel difference to that pixel of the other picture, among the 3 x 3 around the same place, to
/// which it is smallest; taken both ways, the larger. 0 to 1 of full scale. A shift by a pixel and a jagged instead of a smooth edge cost
/// little, a wrong surface all of its difference (the idea of the min-difference grader of George Mason University's graphics course).
/// Alpha does not count. Both pictures have the same size.
double neighbourhood_difference(const StoredImage& a, const StoredImage& b);

}  // namespace rt
