// What was measured already, kept by all that it depends on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commands/base/entry_store.h"
#include "commands/trade/trade_result.h"
#include "film/film.h"

namespace rt {

struct KnownReference {
    ReferenceFacts facts;
    Film film;
};

/// Of a setting, what is no measurement of it.
struct KnownSetting {
    Setting setting;
    Origin origin = Origin::step;
    bool too_slow = false;
    double expected_seconds = 0.0;
};

/// Entries that cannot be read count as not there. All put functions throw OutputError.
class TradeStore {
public:
    /// In `folder`, which is made; `content` is all that every entry depends on: the program, the scene, the picture's settings, the
    /// machine. With `fresh` nothing is known until it is put.
    TradeStore(const std::string& folder, std::string content, bool fresh);

    std::optional<KnownReference> reference(const std::string& words, int width, int height) const;
    void put_reference(const std::string& words, const KnownReference& reference) const;

    std::optional<Measured> measured(const std::string& words) const;
    void put_measured(const std::string& words, const Measured& measured) const;

    /// The settings that a trade reported, in their order.
    std::vector<KnownSetting> settings() const;
    void put_settings(const std::vector<KnownSetting>& settings) const;

    std::optional<UnstableCount> unstable(const std::string& words) const;
    void put_unstable(const std::string& words, const UnstableCount& unstable) const;

    /// The size of picture that was chosen, as a share of the usual width and height.
    std::optional<double> size(const std::string& words) const;
    void put_size(const std::string& words, double share) const;

    std::optional<double> alone(const std::string& words) const;
    void put_alone(const std::string& words, double rmse) const;

private:
    /// Entries that are one number.
    std::optional<double> number(const char* kind, const std::string& words, const char* name) const;
    void put_number(const char* kind, const std::string& words, const char* name, double value) const;
    std::string key(const char* kind, const std::string& words) const;
    std::optional<std::string> text(const std::string& key, const std::string& name) const;

    EntryStore entries_;
    std::string content_;
    bool fresh_;
    mutable std::vector<std::string> put_;  ///< keys that are known although `fresh`
};

}  // namespace rt
