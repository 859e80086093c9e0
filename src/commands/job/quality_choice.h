// A quality as a job holds it.
#pragma once

#include <string_view>
#include <vector>

namespace rt {

struct QualityChoice {
    std::string_view knob, value;  ///< names in knobs()
};

struct ChosenQuality {
    bool cheap = false;                  ///< never makes a scene's own value finer; else never coarser
    std::vector<QualityChoice> choices;  ///< empty: no quality was asked for
};

}  // namespace rt
