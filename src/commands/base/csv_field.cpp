#include "commands/base/csv_field.h"

#include <fmt/format.h>

#include <string_view>

#include "core/utf8.h"

namespace rt {

std::string csv_field(std::string text) {
    text = valid_utf8(text);
    for (char& c : text)
        if (const auto byte = static_cast<unsigned char>(c); (byte < 0x20 && c != '\t' && c != '\r' && c != '\n') || byte == 0x7F) c = '?';
    if (!text.empty() && std::string_view("=+-@\t\r").find(text[0]) != std::string_view::npos) text = fmt::format("'{}", text);
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

}  // namespace rt
