#include "commands/grade/grade_store.h"

#include "commands/report/result_json.h"
#include "syntax/file_text.h"

namespace rt {

namespace {

constexpr std::size_t most_grade_bytes = 1u << 26;
constexpr const char* cause_file = "cause.json";

}  // namespace

std::optional<Result> GradeStore::find(const std::string& key) const {
    std::optional<std::string> text = read_file_text(entries_.path(key, "result.json"), most_grade_bytes);
    if (!text) return std::nullopt;
    Sources sources;
    sources.add({key, std::move(*text)});
    try {
        const nlohmann::json content = parse_json(sources);
        const JsonValue value(sources, content);
        Result result = result_of_json(value["result"]);
        read_times(value["times"], result);
        return result;
    } catch (const SceneError&) {
        return std::nullopt;
    }
}

void GradeStore::put(const std::string& key, const Result& result, const std::string& picture) const {
    std::vector<std::pair<std::string, std::string>> files = {
        {"result.json", json_text({{"result", result_json(result)}, {"times", times_json(result)}}, 1)}};
    if (!picture.empty()) files.emplace_back("picture", picture);
    entries_.put(key, files);
}

bool GradeStore::find_cause(const std::string& key, Result& result) const {
    std::optional<std::string> text = read_file_text(entries_.path(key, cause_file), most_grade_bytes);
    if (!text) return false;
    Sources sources;
    sources.add({key, std::move(*text)});
    try {
        const nlohmann::json content = parse_json(sources);
        const JsonValue value(sources, content);
        const std::string cause = value["cause"].word(), explanation = value["explanation"].word();
        result.cause = cause, result.explanation = explanation;
        return true;
    } catch (const SceneError&) {
        return false;
    }
}

void GradeStore::put_cause(const std::string& key, const Result& result) const {
    entries_.put(key, {{cause_file, json_text({{"cause", result.cause}, {"explanation", result.explanation}}, 1)}});
}

std::string GradeStore::picture_path(const std::string& key) const { return entries_.path(key, "picture"); }

}  // namespace rt
