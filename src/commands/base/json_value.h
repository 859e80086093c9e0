// Values of a JSON text that know their places: whatever is not as expected is told with line, column and what was found.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/name_table.h"
#include "core/vec.h"

namespace rt {

/// The JSON text that `sources` holds as its file 0. Throws SceneError with the place of a mistake.
nlohmann::json parse_json(const Sources& sources);

/// One value, and the way to it. Refers to both arguments of its constructor; throws SceneError for what is not as expected.
class JsonValue {
public:
    JsonValue(const Sources& sources, const nlohmann::json& content) : sources_(&sources), content_(&content) {}

    bool has(const char* name) const { return content_->is_object() && content_->contains(name); }
    bool is_null() const { return content_->is_null(); }
    bool is_list() const { return content_->is_array(); }
    bool is_word() const { return content_->is_string(); }

    JsonValue operator[](const char* name) const;
    /// Of a list.
    JsonValue item(std::size_t index) const;
    /// Of a list.
    std::size_t size() const;
    /// Members of an object that are none of `known` are refused.
    void expect_only(std::initializer_list<std::string_view> known) const;

    /// Infinities and what is no number are strings, "Infinity", "-Infinity", "NaN".
    double number() const;
    double number_in(double least, double most) const;
    std::uint32_t count() const;
    bool truth() const;
    const std::string& word() const;
    Vec3 vector() const;
    template <typename T, std::size_t N>
    T name(const NameTable<T, N>& table, std::string_view what) const {
        if (const std::optional<T> value = find_name(table, word())) return *value;
        fail(fmt::format("a {}", what));
    }

    [[noreturn]] void fail(std::string_view expected) const;

private:
    JsonValue below(const nlohmann::json& content, std::string key) const;
    [[noreturn]] void refuse(const std::vector<std::string>& path, std::string_view text) const;

    const Sources* sources_;
    const nlohmann::json* content_;
    std::vector<std::string> path_;
};

}  // namespace rt
