// Results for other programs: CSV, JUnit, Gradescope.
#include <fmt/format.h>

#include "commands/base/csv_field.h"
#include "commands/grade/grade_reports.h"
#include "commands/report/result_json.h"
#include "core/utf8.h"
#include "grading/result_names.h"

namespace rt {

namespace {

/// U+FFFE and U+FFFF, the two that UTF-8 has and XML 1.0 has not.
bool is_no_character(std::string_view bytes) { return bytes.starts_with("\xEF\xBF\xBE") || bytes.starts_with("\xEF\xBF\xBF"); }

/// Text in XML 1.0, as an attribute's value or an element's content: characters that XML cannot hold are '?'.
std::string xml(std::string_view text) {
    const std::string clean = valid_utf8(text);
    std::string escaped;
    for (std::size_t i = 0; i < clean.size(); ++i) {
        const char c = clean[i];
        const auto byte = static_cast<unsigned char>(c);
        if (c == '<')
            escaped += "&lt;";
        else if (c == '>')
            escaped += "&gt;";
        else if (c == '&')
            escaped += "&amp;";
        else if (c == '"')
            escaped += "&quot;";
        else if (c == '\n')
            escaped += "&#10;";
        else if (c == '\r')
            escaped += "&#13;";
        else if (byte < 0x20 && c != '\t')
            escaped += '?';
        else if (is_no_character(std::string_view(clean).substr(i)))
            escaped += '?', i += 2;
        else
            escaped += c;
    }
    return escaped;
}

bool is_failure(const Result& result) {
    return result.outcome == Outcome::wrong_answer || result.outcome == Outcome::wrong_size || result.outcome == Outcome::no_output;
}

struct JunitCounts {
    std::size_t tests = 0, failures = 0, errors = 0, skipped = 0;
    double seconds = 0.0;

    void add(const Result& result) {
        const bool is_skipped = result.outcome == Outcome::not_run;
        ++tests, skipped += is_skipped, failures += is_failure(result);
        errors += !is_skipped && !is_failure(result) && !is_good(result.outcome);
        seconds += result.wall_seconds;
    }
    void add(const JunitCounts& other) {
        tests += other.tests, failures += other.failures, errors += other.errors, skipped += other.skipped, seconds += other.seconds;
    }
    std::string attributes() const {
        return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:.3f}\"", tests, failures, errors, skipped,
                           seconds);
    }
};

std::string junit_case(const Result& result) {
    std::string text = fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"", xml(result.submission), xml(result.test),
                                   result.wall_seconds);
    if (is_good(result.outcome) && result.output.empty()) return text + "/>\n";
    text += ">\n";
    const std::string_view outcome = name_of(outcome_names, result.outcome);
    const std::string told = result.cause.empty() ? result.reason : fmt::format("{} ({})", result.reason, result.cause);
    if (result.outcome == Outcome::not_run)
        text += fmt::format("      <skipped message=\"{}\"/>\n", xml(result.reason));
    else if (!is_good(result.outcome))
        text += fmt::format("      <{0} type=\"{1}\" message=\"{2}\">{3}</{0}>\n", is_failure(result) ? "failure" : "error", outcome,
                            xml(told), xml(result.explanation));
    if (!result.output.empty()) text += fmt::format("      <system-out>{}</system-out>\n", xml(result.output));
    return text + "    </testcase>\n";
}

std::string message_of(const Result& result) {
    std::string text{name_of(outcome_names, result.outcome)};
    if (!result.reason.empty()) text += ": " + result.reason;
    if (!result.cause.empty()) text += "\nlikely cause: " + result.cause;
    if (!result.explanation.empty()) text += "\n" + result.explanation;
    return text;
}

}  // namespace

std::string csv_text(const GradeRecord& record) {
    std::string text = "submission,test,kind,required,outcome,credit,weight,status";
    for (const auto& [name, metric] : metric_names) text += fmt::format(",{}", name);
    text += ",cause,reason,wall_seconds,cpu_seconds,spread_seconds,peak_bytes\n";
    for (const Result& r : record.results) {
        text += fmt::format("{},{},{},{},{},{},{},{}", csv_field(r.submission), csv_field(r.test), name_of(kind_names, r.kind),
                            r.required ? "yes" : "no", name_of(outcome_names, r.outcome), r.credit, r.weight, r.status);
        for (const auto& [name, metric] : metric_names) text += r.figures ? fmt::format(",{:.9g}", (*r.figures)[metric]) : ",";
        text += fmt::format(",{},{},{:.3f},{:.3f},{:.3f},{}\n", csv_field(r.cause), csv_field(r.reason), r.wall_seconds, r.cpu_seconds,
                            r.spread_seconds, r.peak_memory_bytes);
    }
    return text;
}

std::string junit_text(const GradeRecord& record) {
    std::string suites;
    JunitCounts all;
    for (const std::vector<Result>& results : by_submission(record.results)) {
        JunitCounts counts;
        std::string cases;
        for (const Result& result : results) {
            counts.add(result);
            cases += junit_case(result);
        }
        const Summary sum = summary_of(results);
        suites += fmt::format("  <testsuite name=\"{}\" {}>\n    <properties>\n", xml(results.front().submission), counts.attributes());
        const auto property = [&](const char* name, double value) {
            suites += fmt::format("      <property name=\"{}\" value=\"{:.6g}\"/>\n", name, value);
        };
        property("points", sum.points), property("out_of", sum.out_of);
        property("required", sum.required), property("required_passed", sum.required_passed);
        suites += fmt::format("    </properties>\n{}  </testsuite>\n", cases);
        all.add(counts);
    }
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\" {}>\n{}</testsuites>\n", xml(record.suite),
                       all.attributes(), suites);
}

std::string gradescope_text(const std::vector<Result>& results) {
    const Summary sum = summary_of(results);
    nlohmann::ordered_json tests = nlohmann::ordered_json::array();
    for (const Result& result : results) {
        if (result.kind == TestCase::Kind::shown) continue;
        tests.push_back({{"name", result.test},
                         {"score", result.weight * result.credit},
                         {"max_score", result.weight},
                         {"status", result.outcome == Outcome::passed ? "passed" : "failed"},
                         {"output", message_of(result)},
                         {"output_format", "text"},
                         {"tags", {std::string(name_of(kind_names, result.kind)), result.required ? "required" : "optional"}},
                         {"visibility", "visible"}});
    }
    return json_text(
        {{"score", sum.points},
         {"execution_time", static_cast<long>(sum.wall_seconds + 0.5)},
         {"output", fmt::format("{} of {} tests passed ({} of {} required)", sum.passed, sum.tests, sum.required_passed, sum.required)},
         {"output_format", "text"},
         {"test_output_format", "text"},
         {"test_name_format", "text"},
         {"visibility", "visible"},
         {"stdout_visibility", "hidden"},
         {"tests", tests}},
        1);
}

}  // namespace rt
