// What scenes say by #debug, case by case.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/syntax/read_scene.h"

namespace rt {

using Cases = std::vector<std::pair<std::string, std::string>>;  ///< scene, text

/// `Show(A)` says a whole number and a blank.
inline void expect_debug(const Cases& cases) {
    const std::string show = "#macro Show(A) #debug concat(str(A,0,0),\" \") #end ";
    for (const auto& [scene, text] : cases) EXPECT_EQ(debug_text(show + scene), text) << scene;
}

}  // namespace rt
