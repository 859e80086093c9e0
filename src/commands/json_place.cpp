#include "commands/json_place.h"

#include <algorithm>

namespace rt {

namespace {

/// Walks over values without reading them; the text is known to be JSON.
class Walker {
public:
    explicit Walker(std::string_view json) : json_(json) { space(); }

    std::size_t place() const { return at_; }

    /// From a list or an object to the value of one of its members.
    void enter(const std::string& key) {
        const bool object = json_[at_++] == '{';
        for (std::size_t index = 0; at_ < json_.size(); ++index) {
            space();
            std::string name = std::to_string(index);
            if (object) {
                const std::size_t begin = at_ + 1;
                string();
                name = json_.substr(begin, at_ - 1 - begin);
                space();
                ++at_;  // the colon
                space();
            }
            if (name == key) return;
            value();
            space();
            ++at_;  // the comma
        }
    }

private:
    void space() { at_ = std::min(json_.find_first_not_of(" \t\r\n", at_), json_.size()); }

    void string() {
        for (++at_; at_ < json_.size() && json_[at_] != '"'; ++at_)
            if (json_[at_] == '\\') ++at_;
        ++at_;
    }

    void value() {
        std::size_t open = 0;
        do {
            const char c = json_[at_];
            if (c == '"') {
                string();
            } else if (c == '{' || c == '[') {
                ++open, ++at_;
            } else if (c == '}' || c == ']') {
                --open, ++at_;
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
