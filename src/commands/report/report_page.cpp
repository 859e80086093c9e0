#include "commands/report/report_page.h"

#include <fmt/format.h>

#include <string_view>

#include "commands/base/json_text.h"
#include "commands/base/program.h"
#include "commands/report/page_pictures.h"
#include "core/name_table.h"
#include "pages/page.h"

namespace rt {

namespace {

using Json = nlohmann::ordered_json;

constexpr NameTable<CellKind, 7> cell_kinds{{{"text", CellKind::text},
                                             {"outcome", CellKind::outcome},
                                             {"count", CellKind::count},
                                             {"points", CellKind::points},
                                             {"figure", CellKind::figure},
                                             {"seconds", CellKind::seconds},
                                             {"bytes", CellKind::bytes}}};

/// Everything but the rows, as an object without its end.
std::string head_of(const ReportPage& page) {
    Json columns = Json::array();
    for (const ReportColumn& column : page.columns) {
        columns.push_back({{"key", column.key}, {"title", column.title}, {"kind", name_of(cell_kinds, column.kind)}});
        if (!column.hint.empty()) columns.back()["hint"] = column.hint;
    }
    Json head = {{"format", "raytrace report 1"}, {"version", program_version()}, {"title", page.title}, {"about", page.about}};
    head["facts"] = page.facts, head["notes"] = page.notes;
    if (!page.back_href.empty()) head["back"] = {{"href", page.back_href}, {"text", page.back}};
    if (!page.first.empty()) head["first"] = page.first;
    for (const auto& [name, value] : page.more.items()) head[name] = value;
    head["rows_name"] = page.rows_name, head["bad_name"] = page.bad_name, head["columns"] = columns;
    std::string text = json_line(head);
    text.pop_back();
    return text;
}

bool is_good(const ReportRow& row) { return row.data.value("good", true); }

Json pictures_of(const ReportRow& row, PagePictures& embedded, const PictureChoice& choice) {
    Json pictures = Json::array();
    for (const ReportPicture& picture : row.pictures) {
        Json entry = {{"label", picture.label}};
        if (picture.path.empty()) {
            entry["missing"] = picture.missing;
        } else if (is_good(row) && !choice.of_good_rows) {
            entry["missing"] = choice.left_out;
        } else {
            const EmbeddedPicture& found = embedded.add(picture.path, choice.left_out);
            if (found.name.empty())
                entry["missing"] = found.problem;
            else
                entry["picture"] = found.name;
            if (!found.note.empty()) entry["note"] = found.note;
        }
        pictures.push_back(std::move(entry));
    }
    return pictures;
}

std::string data_of(const ReportPage& page, PagePictures& embedded, const PictureChoice& choice) {
    std::vector<Json> pictures(page.rows.size());
    for (const bool good : {choice.good_first, !choice.good_first})
        for (std::size_t i = 0; i < page.rows.size(); ++i)
            if (is_good(page.rows[i]) == good) pictures[i] = pictures_of(page.rows[i], embedded, choice);
    std::string text = head_of(page) + ",\n\"rows\":[";
    for (std::size_t i = 0; i < page.rows.size(); ++i) {
        Json row = page.rows[i].data;
        if (!pictures[i].empty()) row["pictures"] = std::move(pictures[i]);
        text += fmt::format("{}\n{}", i ? "," : "", json_line(row));
    }
    return text + "\n]}\n";
}

}  // namespace

std::string report_page(const ReportPage& page, const PictureChoice& choice) {
    PagePictures embedded(choice.most_bytes);
    std::string data = data_of(page, embedded, choice);
    return assemble_page({page.skeleton, std::move(data), embedded.take()});
}

std::string report_index(const ReportPage& page) {
    PagePictures none(0);
    return assemble_page({"report_index.html", data_of(page, none, {}), {}});
}

std::string in_address(const std::string& name) {
    constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.~";
    std::string address;
    for (const char c : name) {
        if (plain.find(c) != std::string_view::npos)
            address += c;
        else
            address += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return address;
}

}  // namespace rt
