// The extreme scenes on one page that needs no other file.
#pragma once

#include "tests/extremes/judgement.h"

namespace rt::extremes {

/// Name and counts of one scene in columns.
std::string line(const Judgement& judgement);

/// HTML with a table of counts, and each scene's pictures: ours, the textbook's in single precision, and how far either is from the truth.
std::string page(const std::vector<Judgement>& judgements);

}  // namespace rt::extremes
