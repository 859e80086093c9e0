#include "grading/text_alignment.h"

#include <algorithm>

#include "grading/text_fields.h"

namespace rt {

namespace {

constexpr std::size_t most_cells = 90'000;

enum class Step : unsigned char { pair, expected_alone, actual_alone };

/// A line and its fields, which refer to it.
struct Line {
    std::string_view text;
    std::size_t number = 0;
    std::vector<std::string_view> fields;
};

std::vector<Line> split(const TextLines& lines) {
    std::vector<Line> split;
    for (std::size_t i = 0; i < lines.texts.size(); ++i) split.push_back({lines.texts[i], lines.numbers[i], fields_of(lines.texts[i])});
    return split;
}

bool same_line(const Line& a, const Line& b, double tolerance) {
    return a.text == b.text || (tolerance > 0.0 && std::equal(a.fields.begin(), a.fields.end(), b.fields.begin(), b.fields.end(),
                                                              [&](auto x, auto y) { return same_field(x, y, tolerance); }));
}

/// Of a pair; a line that is only indented otherwise differs in its first field.
std::vector<std::size_t> differing_fields(const Line& a, const Line& b, double tolerance) {
    std::vector<std::size_t> differing;
    if (same_line(a, b, tolerance)) return differing;
    for (std::size_t i = 0; i < std::max(a.fields.size(), b.fields.size()); ++i)
        if (i >= a.fields.size() || i >= b.fields.size() || !same_field(a.fields[i], b.fields[i], tolerance)) differing.push_back(i + 1);
    if (differing.empty()) differing.push_back(1);
    return differing;
}

/// 0 for the same, 2 where every field differs.
float pair_cost(const Line& a, const Line& b, double tolerance) {
    if (same_line(a, b, tolerance)) return 0.0f;
    const std::size_t common = std::min(a.fields.size(), b.fields.size()), all = std::max(a.fields.size(), b.fields.size());
    std::size_t same = 0;
    for (std::size_t i = 0; i < common; ++i) same += same_field(a.fields[i], b.fields[i], tolerance);
    return 2.0f * static_cast<float>(all - same) / static_cast<float>(all);
}

class Alignment {
public:
    Alignment(const std::vector<Line>& a, const std::vector<Line>& b, double tolerance) : a_(a), b_(b), tolerance_(tolerance) {}

    std::vector<AlignedLine> lines() {
        std::size_t begin = 0, end_a = a_.size(), end_b = b_.size();
        while (begin < end_a && begin < end_b && same_line(a_[begin], b_[begin], tolerance_)) ++begin;
        while (end_a > begin && end_b > begin && same_line(a_[end_a - 1], b_[end_b - 1], tolerance_)) --end_a, --end_b;
        std::vector<Step> steps(begin, Step::pair);
        const std::vector<Step> middle = middle_steps(begin, end_a, end_b);
        steps.insert(steps.end(), middle.begin(), middle.end());
        steps.insert(steps.end(), a_.size() - end_a, Step::pair);
        return follow(steps);
    }

private:
    /// How lines begin..end_a and begin..end_b go together.
    std::vector<Step> middle_steps(std::size_t begin, std::size_t end_a, std::size_t end_b) const {
        const std::size_t n = end_a - begin, m = end_b - begin;
        std::vector<Step> steps;
        if (n * m > most_cells) {
            steps.assign(std::min(n, m), Step::pair);
            steps.insert(steps.end(), std::max(n, m) - std::min(n, m), n > m ? Step::expected_alone : Step::actual_alone);
            return steps;
        }
        // best[i][j]: the last step of the cheapest way that uses i lines of the one and j of the other.
        std::vector<Step> best((n + 1) * (m + 1), Step::actual_alone);
        std::vector<float> above(m + 1), row(m + 1);
        for (std::size_t j = 0; j <= m; ++j) above[j] = static_cast<float>(j);
        for (std::size_t i = 1; i <= n; ++i) {
            row[0] = static_cast<float>(i), best[i * (m + 1)] = Step::expected_alone;
            for (std::size_t j = 1; j <= m; ++j) {
                const float pair = above[j - 1] + pair_cost(a_[begin + i - 1], b_[begin + j - 1], tolerance_);
                row[j] = std::min({pair, above[j] + 1.0f, row[j - 1] + 1.0f});
                best[i * (m + 1) + j] = row[j] == pair ? Step::pair : row[j] == above[j] + 1.0f ? Step::expected_alone : Step::actual_alone;
            }
            std::swap(above, row);
        }
        for (std::size_t i = n, j = m; i > 0 || j > 0;) {
            steps.push_back(best[i * (m + 1) + j]);
            i -= steps.back() != Step::actual_alone, j -= steps.back() != Step::expected_alone;
        }
        std::reverse(steps.begin(), steps.end());
        return steps;
    }

    std::vector<AlignedLine> follow(const std::vector<Step>& steps) const {
        std::vector<AlignedLine> lines;
        std::size_t i = 0, j = 0;
        for (const Step step : steps) {
            AlignedLine line;
            if (step != Step::actual_alone) line.expected = a_[i].text, line.expected_number = a_[i].number;
            if (step != Step::expected_alone) line.actual = b_[j].text, line.actual_number = b_[j].number;
            if (step == Step::pair) line.differing = differing_fields(a_[i], b_[j], tolerance_);
            i += step != Step::actual_alone, j += step != Step::expected_alone;
            lines.push_back(std::move(line));
        }
        return lines;
    }

    const std::vector<Line>& a_;
    const std::vector<Line>& b_;
    double tolerance_;
};

}  // namespace

std::vector<AlignedLine> aligned_lines(std::string_view expected, std::string_view actual, double tolerance) {
    const TextLines a = lines_of(expected), b = lines_of(actual);
    return Alignment(split(a), split(b), tolerance).lines();
}

}  // namespace rt
