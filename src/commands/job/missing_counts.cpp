#include "commands/job/missing_counts.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace rt {

namespace {

std::vector<std::set<std::string>> names_of(const MissingOfScenes& scenes) {
    std::vector<std::set<std::string>> names;
    for (const std::vector<MissingFeature>& missing : scenes) {
        names.emplace_back();
        for (const MissingFeature& feature : missing) names.back().insert(feature.name);
    }
    return names;
}

/// What having a feature is worth.
struct Gain {
    std::size_t completes = 0;
    double nearer = 0.0;  ///< sum of 1/(features that a scene misses)
};

}  // namespace

std::vector<MissingCount> missing_counts(const MissingOfScenes& scenes) {
    std::map<std::string, MissingCount> counts;
    for (const std::set<std::string>& names : names_of(scenes))
        for (const std::string& name : names) {
            MissingCount& count = counts.try_emplace(name, MissingCount{name}).first->second;
            ++count.scenes;
            if (names.size() == 1) ++count.only_this;
        }
    std::vector<MissingCount> list;
    for (const auto& [name, count] : counts) list.push_back(count);
    std::stable_sort(list.begin(), list.end(), [](const MissingCount& a, const MissingCount& b) {
        return std::pair(a.only_this, a.scenes) > std::pair(b.only_this, b.scenes);
    });
    return list;
}

std::vector<MissingStep> missing_order(const MissingOfScenes& scenes) {
    std::vector<std::set<std::string>> left = names_of(scenes);
    std::vector<MissingStep> steps;
    while (true) {
        std::map<std::string, Gain> gains;
        for (const std::set<std::string>& names : left)
            for (const std::string& name : names) {
                Gain& gain = gains[name];
                gain.nearer += 1.0 / static_cast<double>(names.size());
                if (names.size() == 1) ++gain.completes;
            }
        if (gains.empty()) return steps;
        const auto best = std::max_element(gains.begin(), gains.end(), [](const auto& a, const auto& b) {  // the first of equal ones
            return std::tie(a.second.completes, a.second.nearer) < std::tie(b.second.completes, b.second.nearer);
        });
        steps.push_back({best->first, best->second.completes});
        for (std::set<std::string>& names : left) names.erase(steps.back().name);
    }
}

}  // namespace rt
