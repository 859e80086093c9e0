// Results that are already known, one folder each, named by everything that they depend on.
#pragma once

#include <optional>
#include <string>

#include "grading/result.h"

namespace rt {

/// An entry appears whole or not at all, so whoever ends a grading at any moment loses what was running and nothing else.
class GradeStore {
public:
    /// Makes `folder` if need be and removes what ended runs have left in it. Throws OutputError.
    explicit GradeStore(std::string folder);

    /// The result under `key`; empty if there is none (or a broken one, which is as good).
    std::optional<Result> find(const std::string& key) const;
    /// Puts a result under `key`, with the picture the program wrote if `picture` is not empty (its bytes). Replaces an older one.
    void put(const std::string& key, const Result& result, const std::string& picture) const;
    /// Where the picture of an entry is, if it has one.
    std::string picture_path(const std::string& key) const;

private:
    std::string folder_;
};

}  // namespace rt
