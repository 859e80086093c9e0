// HTML pages in one file that ask the network for nothing: a skeleton, the styles and scripts beside it, data and pictures.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rt {

struct PageContent {
    std::string_view skeleton;                                  ///< an asset's name, e.g. "pixel_page.html"
    std::string json;                                           ///< one value, UTF-8
    std::vector<std::pair<std::string, std::string>> pictures;  ///< name and bytes of PNG files
};

/// The page. In its skeleton
///     {{part NAME}}      becomes the asset, whose fields are filled in turn,
///     {{style NAME}}     the asset in a <style> element,
///     {{script NAME}}    the asset in a <script> element; all of them share one global scope, in their order,
///     {{data}}           the JSON in <script type="application/json" id="data">,
///     {{picture NAME}}   a data: URL,
///     {{pictures}}       all pictures as base64, each in <script type="text/plain" id="NAME">: nothing decodes them until a script does.
/// Throws std::logic_error for a name that is not there, and for an asset that would end its own element.
std::string assemble_page(const PageContent& content);

/// JSON as it may stand inside a <script> element: every `<` (which JSON has in strings alone) as \u003c, so that no text in it ends the
/// element or begins a comment.
std::string json_in_html(std::string_view json);

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

}  // namespace rt
