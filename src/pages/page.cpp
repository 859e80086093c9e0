#include "pages/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>

#include "pages/assets.h"

namespace rt {

namespace {

std::string_view asset(std::string_view name) {
    const std::string_view text = page_asset(name);
    if (text.empty()) throw std::logic_error(fmt::format("no page asset '{}'", name));
    return text;
}

/// An asset in an element of its own.
std::string element(std::string_view tag, std::string_view name) {
    const std::string_view text = asset(name);
    if (text.find(fmt::format("</{}", tag)) != text.npos) throw std::logic_error(fmt::format("asset '{}' ends its own element", name));
    return fmt::format("<{}>\n{}</{}>", tag, text, tag);
}

std::string picture(const PageContent& content, std::string_view name) {
    const auto found = std::find_if(content.pictures.begin(), content.pictures.end(), [&](const auto& p) { return p.first == name; });
    if (found == content.pictures.end()) throw std::logic_error(fmt::format("no picture '{}' for the page", name));
    return "data:image/png;base64," + base64(found->second);
}

std::string all_pictures(const PageContent& content) {
    std::string text;
    for (const auto& [name, bytes] : content.pictures)
        text += fmt::format("<script type=\"text/plain\" id=\"{}\">{}</script>\n", name, base64(bytes));
    return text;
}

/// The asset with what its fields stand for.
std::string with_fields_filled(const PageContent& content, std::string_view name);

/// What stands in the page for one {{field}} of the skeleton.
std::string filled(const PageContent& content, std::string_view field) {
    const std::size_t space = field.find(' ');
    const std::string_view kind = field.substr(0, space), name = space == field.npos ? "" : field.substr(space + 1);
    if (kind == "data") return "<script type=\"application/json\" id=\"data\">" + json_in_html(content.json) + "</script>";
    if (kind == "style" || kind == "script") return element(kind, name);
    if (kind == "part") return with_fields_filled(content, name);
    if (kind == "pictures") return all_pictures(content);
    if (kind == "picture") return picture(content, name);
    throw std::logic_error(fmt::format("no page field '{}'", field));
}

std::string with_fields_filled(const PageContent& content, std::string_view name) {
    std::string page;
    std::string_view rest = asset(name);
    for (std::size_t open = rest.find("{{"); open != rest.npos; open = rest.find("{{")) {
        const std::size_t close = rest.find("}}", open);
        if (close == rest.npos) throw std::logic_error(fmt::format("'{}' has a field without end", name));
        page += rest.substr(0, open);
        page += filled(content, rest.substr(open + 2, close - open - 2));
        rest.remove_prefix(close + 2);
    }
    return page += rest;
}

}  // namespace

std::string json_in_html(std::string_view json) {
    std::string text;
    text.reserve(json.size());
    for (const char c : json) {
        if (c == '<') {
            text += "\\u003c";
        } else {
            text += c;
        }
    }
    return text;
}

std::string base64(std::string_view bytes) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(bytes.size() - i, 3);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

std::string assemble_page(const PageContent& content) { return with_fields_filled(content, content.skeleton); }

}  // namespace rt
