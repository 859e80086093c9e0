// A comparison as a page for a browser.
#pragma once

#include <string>

#include "commands/versus/versus_reports.h"

namespace rt {

/// The scenes worst first, each with its pictures (those below `folder`/pictures), commands, figures and times: one file that asks the
/// network for nothing. Where its pictures would be more than 64 MiB, those of scenes that agree are the first to be left out.
std::string versus_page_text(const VersusRecord& record, const std::string& folder);

}  // namespace rt
