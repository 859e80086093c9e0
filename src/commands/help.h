// Texts that are only help. Each fits a screen of 24 lines and 80 columns.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rt {

extern const char* const render_usage;
extern const char* const render_footer;
extern const char* const requires_usage;
extern const char* const requires_footer;
extern const char* const compare_usage;
extern const char* const compare_footer;
extern const char* const explain_usage;
extern const char* const explain_footer;
extern const char* const grade_usage;
extern const char* const grade_footer;
extern const char* const merge_usage;
extern const char* const merge_footer;
extern const char* const versus_usage;
extern const char* const versus_footer;
extern const char* const trade_usage;
extern const char* const trade_footer;
extern const char* const trade_topic;
extern const char* const quality_topic;
extern const char* const brdf_usage;
extern const char* const brdf_footer;
extern const char* const brdf_plot_usage;
extern const char* const brdf_plot_footer;

/// What `raytrace help TOPIC` can be asked for.
std::vector<std::string> help_topics();
/// The text of one topic, or "" if there is no such topic.
std::string_view help_topic(std::string_view topic);

}  // namespace rt
