// The converged picture that all others are compared with: the mean of grids of growing size.
//
// Each grid has about as many samples as all before it together, and no point but the pixel's centre in common with them or with a grid
// that a setting samples by: sides are primes from 5 on. The two halves are pictures of equal worth, so how far they are apart tells how
// far their mean is from the limit.
#pragma once

#include "commands/trade/trade_result.h"
#include "film/film.h"

namespace rt {

/// The side of the grid that follows those of these sides: 5, 7, 11, 13, 19, 29, 41, 59, ...
int next_grid(const std::vector<int>& grids);

/// The mean of two films of one size by their numbers of samples.
Film joined(const Film& a, double samples_a, const Film& b, double samples_b);

/// The RMSE of the joined picture, where the halves are `apart` by this RMSE: the errors of both are independent and their squares shrink
/// with the number of samples, so apart^2 = c (1/a + 1/b) and the square of the mean's error is c / (a + b).
double joined_error(double apart, double samples_a, double samples_b);

}  // namespace rt
