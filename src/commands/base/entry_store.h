// A folder of entries, each a folder of files, named by everything that its content depends on.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace rt {

/// An entry appears whole or not at all, so whoever ends us at any moment loses what was running and nothing else.
class EntryStore {
public:
    /// Makes `folder` if need be and removes what ended runs have left in it. Throws OutputError.
    explicit EntryStore(std::string folder);

    /// Puts files (name, bytes) under `key`, in place of an older entry.
    void put(const std::string& key, const std::vector<std::pair<std::string, std::string>>& files) const;
    /// Where a file of an entry is; empty if there is none.
    std::string path(const std::string& key, const std::string& name) const;

private:
    std::string folder_;
};

}  // namespace rt
