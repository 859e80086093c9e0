// Results that are already known, named by everything that they depend on.
#pragma once

#include <optional>
#include <string>

#include "commands/base/entry_store.h"
#include "grading/result.h"

namespace rt {

class GradeStore {
public:
    /// See EntryStore.
    explicit GradeStore(std::string folder) : entries_(std::move(folder)) {}

    /// The result under `key`; empty if there is none (or a broken one, which is as good).
    std::optional<Result> find(const std::string& key) const;
    /// Puts a result under `key`, with the picture the program wrote if `picture` is not empty (its bytes). Replaces an older one.
    void put(const std::string& key, const Result& result, const std::string& picture) const;
    /// Fills `cause` and `explanation` with those under `key`; false if there are none. And puts them there.
    bool find_cause(const std::string& key, Result& result) const;
    void put_cause(const std::string& key, const Result& result) const;
    /// Where the picture of an entry is, if it has one.
    std::string picture_path(const std::string& key) const;

private:
    EntryStore entries_;
};

}  // namespace rt
