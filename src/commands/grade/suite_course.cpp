#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "commands/base/json_value.h"
#include "commands/base/values.h"
#include "commands/grade/suite_file.h"
#include "commands/grade/suite_notes.h"
#include "core/utf8.h"
#include "syntax/file_text.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_suite_bytes = 1u << 26;

std::string text_of(const fs::path& path) {
    std::optional<std::string> text = read_file_text(path.string(), most_suite_bytes);
    if (!text) throw OptionError(fmt::format("cannot read '{}'", printable(path.string())));
    return std::move(*text);
}

std::vector<std::string> words_of(const fs::path& path) {
    std::vector<std::string> words;
    std::string text = text_of(path);
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    for (const std::string& word : split(text, ' '))
        if (!word.empty()) words.push_back(word);
    return words;
}

bool is_there(const fs::path& path) {
    std::error_code none;
    return fs::exists(path, none);
}

/// "test2" before "test10".
bool comes_before(const std::string& a, const std::string& b) {
    const auto key = [](const std::string& name) {
        const std::size_t digits = std::min(name.find_last_not_of("0123456789") + 1, name.size());
        const std::string number = name.substr(digits);
        return std::tuple(name.substr(0, digits), number.size(), number);
    };
    return key(a) < key(b);
}

/// The tests of one folder with a tests.json.
class Part {
public:
    Part(const fs::path& folder, std::string prefix) : folder_(folder), prefix_(std::move(prefix)) {}

    void read(std::vector<TestCase>& tests, const MessageSink& messages) {
        read_list(tests, messages);
        std::vector<std::string> others;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
            if (const std::string name = entry.path().stem().string(); entry.path().extension() == ".args" && !listed_.contains(name))
                others.push_back(name);
        std::sort(others.begin(), others.end(), comes_before);
        for (const std::string& name : others) {
            const bool text = is_there(folder_ / (name + ".out"));
            if (!text && !is_there(folder_ / (name + ".png"))) continue;
            TestCase test = with_files(name, text ? TestCase::Kind::text : TestCase::Kind::picture);
            test.required = test.listed = false;
            tests.push_back(std::move(test));
        }
        if (!others.empty())
            messages(fmt::format("raytrace: note: {} not in {} but run, as not required: {}",
                                 others.size() == 1 ? "one test is" : "tests are", printable((folder_ / "tests.json").string()),
                                 one_line(fmt::format("{}", fmt::join(others, ", ")))));
    }

private:
    void read_list(std::vector<TestCase>& tests, const MessageSink& messages) {
        Sources sources;
        sources.add({(folder_ / "tests.json").string(), text_of(folder_ / "tests.json")});
        const nlohmann::json content = parse_json(sources);
        const JsonValue list(sources, content);
        for (std::size_t i = 0; i < list.size(); ++i) {
            const JsonValue entry = list.item(i);
            const std::string name = entry["name"].word();
            if (!listed_.emplace(name, i).second) entry["name"].fail("a name that no other test has");
            constexpr NameTable<TestCase::Kind, 3> types{
                {{"text", TestCase::Kind::text}, {"image", TestCase::Kind::picture}, {"additional", TestCase::Kind::shown}}};
            const TestCase::Kind kind = entry["type"].name(types, "type of test: text, image or additional");
            if (kind != TestCase::Kind::shown && !is_there(folder_ / (name + ".args"))) {
                messages(fmt::format("raytrace: note: test {}{} is in the list but has no {}.args: left out", printable(prefix_),
                                     printable(name), printable(name)));
                continue;
            }
            TestCase test = with_files(name, kind);
            if (entry.has("required")) test.required = entry["required"].truth();
            if (kind == TestCase::Kind::shown) test.required = false, test.weight = 0.0;
            if (entry.has("timeout")) test.limits.wall_seconds = entry["timeout"].number_in(0.01, 86400.0);
            tests.push_back(std::move(test));
        }
    }

    TestCase with_files(const std::string& name, TestCase::Kind kind) const {
        TestCase test;
        test.name = prefix_ + name, test.kind = kind;
        if (valid_utf8(test.name) != test.name)
            throw OptionError(fmt::format("test '{}': its name is not UTF-8", printable((folder_ / name).string())));
        test.limits.wall_seconds = kind == TestCase::Kind::text ? 20.0 : 60.0;
        if (kind == TestCase::Kind::shown) {  // a scene of the student's own
            test.arguments = {"render", name + ".pov", "640", "480"};
            return test;
        }
        test.arguments = words_of(folder_ / (name + ".args"));
        const fs::path expected = folder_ / (name + (kind == TestCase::Kind::text ? ".out" : ".png"));
        if (!is_there(expected))
            throw OptionError(fmt::format("test '{}' has no '{}'", printable(test.name), printable(expected.string())));
        test.expected = fs::absolute(expected).lexically_normal().string();
        return test;
    }

    fs::path folder_;
    std::string prefix_;
    std::map<std::string, std::size_t> listed_;
};

std::string find_inputs(const fs::path& folder) {
    for (const fs::path& place : {folder, folder.parent_path()})
        for (const char* name : {"inputs", "resources"})
            if (std::error_code none; fs::is_directory(place / name, none)) return (place / name).string();
    throw OptionError(
        fmt::format("no folder 'inputs' or 'resources' in '{}' or beside it; name it with --inputs", printable(folder.string())));
}

}  // namespace

Suite read_course_suite(const std::string& path, const std::string& inputs, const MessageSink& messages) {
    fs::path folder = fs::absolute(path).lexically_normal();
    if (!folder.has_filename()) folder = folder.parent_path();
    Suite suite{folder.filename().string(), folder.string(), inputs.empty() ? find_inputs(folder) : inputs, {}};
    const fs::path tests = !is_there(folder / "tests.json") && fs::is_directory(folder / "tests") ? folder / "tests" : folder;
    if (is_there(tests / "tests.json")) {
        Part(tests, "").read(suite.tests, messages);
    } else {
        std::vector<std::string> parts;
        for (const fs::directory_entry& entry : fs::directory_iterator(tests))
            if (is_there(entry.path() / "tests.json")) parts.push_back(entry.path().filename().string());
        std::sort(parts.begin(), parts.end(), comes_before);
        for (const std::string& part : parts) Part(tests / part, part + "/").read(suite.tests, messages);
    }
    if (suite.tests.empty())
        throw OptionError(fmt::format("'{}' is no suite: it has no tests.json with tests, nor have its folders", printable(path)));
    return suite;
}

Suite read_suite(const std::string& path, const std::string& inputs, const MessageSink& messages) {
    std::error_code none;
    if (!fs::exists(path, none)) throw OptionError(fmt::format("there is no suite '{}'", printable(path)));
    if (!inputs.empty() && !fs::is_directory(inputs, none))
        throw OptionError(fmt::format("there is no folder '{}' of inputs", printable(inputs)));
    const std::string absolute_inputs = inputs.empty() ? "" : fs::canonical(inputs).string();
    Suite suite;
    if (fs::is_directory(path, none)) {
        suite = read_course_suite(fs::canonical(path).string(), absolute_inputs, messages);
    } else {
        Sources sources;
        sources.add({path, text_of(path)});
        suite = suite_of_json(sources, absolute_inputs);
    }
    note_tests_in_vain(suite, messages);
    return suite;
}

}  // namespace rt
