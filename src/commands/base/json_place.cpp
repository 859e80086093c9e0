#include "commands/base/json_place.h"

#include <algorithm>

namespace rt {

namespace {

/// Walks over values without reading them; the text is known to be JSON. A path that it does not have leads to its end.
class Walker {
public:
    explicit Walker(std::string_view json) : json_(json) { space(); }

    std::size_t place() const { return at_; }

    /// From a list or an object to the value of one of its members.
    void enter(const std::string& key) {
        const bool object = at_ < json_.size() && json_[at_] == '{';
        skip(1);
        for (std::size_t index = 0; at_ < json_.size(); ++index) {
            space();
            if (at_ >= json_.size()) return;
            std::string name = std::to_string(index);
            if (object) {
                const std::size_t begin = at_ + 1;
                string();
                name = json_.substr(std::min(begin, at_), at_ - std::min(begin + 1, at_));
                space();
                skip(1);  // the colon
                space();
            }
            if (name == key) return;
            value();
            space();
            skip(1);  // the comma
        }
    }

private:
    void skip(std::size_t n) { at_ = std::min(at_ + n, json_.size()); }
    void space() { at_ = std::min(json_.find_first_not_of(" \t\r\n", at_), json_.size()); }

    void string() {
        for (skip(1); at_ < json_.size() && json_[at_] != '"'; skip(1))
            if (json_[at_] == '\\') skip(1);
        skip(1);
    }

    void value() {
        std::size_t open = 0;
        do {
            const char c = at_ < json_.size() ? json_[at_] : ',';
            if (c == '"') {
                string();
            } else if (c == '{' || c == '[') {
                ++open, skip(1);
            } else if (c == '}' || c == ']') {
                --open, skip(1);
            } else {
                at_ = std::min(json_.find_first_of(open > 0 ? "\"{}[]" : ",}] \t\r\n", at_), json_.size());
            }
        } while (open > 0 && at_ < json_.size());
    }

    std::string_view json_;
    std::size_t at_ = 0;
};

}  // namespace

std::size_t place_in_json(std::string_view json, std::span<const std::string> path) {
    Walker walker(json);
    for (const std::string& key : path) walker.enter(key);
    return walker.place();
}

}  // namespace rt
