// Pages: what is put into them cannot break out, and every asset of the folder is compiled into the program as it stands.
#include "pages/page.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "pages/assets.h"

namespace rt::page_test {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

TEST(PageAssets, AreTheFilesByteForByte) {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(PROJECT_ROOT "/src/pages")) {
        const std::string kind = entry.path().extension().string();
        if (kind != ".html" && kind != ".css" && kind != ".js") continue;
        ++count;
        EXPECT_EQ(page_asset(entry.path().filename().string()), text_of(entry.path())) << entry.path();
    }
    EXPECT_GE(count, 20);
    EXPECT_EQ(page_asset("none.js"), "");
}

TEST(JsonInHtml, HasNoCharacterThatBeginsATag) {
    EXPECT_EQ(json_in_html(R"({"a":"</script><!--"})"), R"({"a":"\u003c/script>\u003c!--"})");
    EXPECT_EQ(json_in_html("[1,2]"), "[1,2]");
}

/// RFC 4648, section 10, and bytes of the upper half.
TEST(Base64, HasTheStandardsValues) {
    for (const auto& [bytes, text] : {std::pair("", ""), std::pair("f", "Zg=="), std::pair("fo", "Zm8="), std::pair("foo", "Zm9v"),
                                      std::pair("foob", "Zm9vYg=="), std::pair("fooba", "Zm9vYmE="), std::pair("foobar", "Zm9vYmFy")})
        EXPECT_EQ(base64(bytes), text);
    EXPECT_EQ(base64("\xff\xfe\xfb"), "//77");
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
    return found;
}

TEST(Page, IsWholeAndFilledOnce) {
    const std::string page = assemble_page({"pixel_page.html", R"({"scene":"</script>{{data}}{{picture render}}"})", {{"render", "PNG"}}});
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
    EXPECT_TRUE(page.ends_with("</html>\n"));
    EXPECT_EQ(count(page, R"({"scene":"\u003c/script>{{data}}{{picture render}}"})"), 1u);
    EXPECT_EQ(count(page, "data:image/png;base64,UE5H"), 1u);
    EXPECT_EQ(count(page, "<script"), count(page, "</script>"));
    EXPECT_EQ(count(page, "<style>"), 2u);
    EXPECT_NE(page.find(page_asset("picture_view.js")), page.npos);
    EXPECT_NE(page.find("default-src 'none'"), page.npos);
}

TEST(Page, HoldsPicturesThatNothingDecodes) {
    const std::string page = assemble_page({"report_page.html", "{}", {{"p0", "foo"}, {"p1", "bar"}}});
    EXPECT_EQ(count(page, "<script type=\"text/plain\" id=\"p0\">Zm9v</script>"), 1u);
    EXPECT_EQ(count(page, "<script type=\"text/plain\" id=\"p1\">YmFy</script>"), 1u);
    EXPECT_EQ(count(page, "<script"), count(page, "</script>"));
}

TEST(Page, PartsAreFilledInTurn) {
    for (const auto& [skeleton, styles] : {std::pair("report_page.html", 3u), std::pair("report_index.html", 2u)}) {
        const std::string page = assemble_page({skeleton, "{}", {}});
        EXPECT_TRUE(page.starts_with("<!DOCTYPE html>")) << skeleton;
        EXPECT_EQ(count(page, "<style>"), styles) << skeleton;
        EXPECT_EQ(count(page, std::string(page_asset("page.css"))), 1u) << skeleton;
        EXPECT_EQ(count(page, "{{part"), 0u) << skeleton;
    }
}

TEST(Page, NamesWhatIsMissing) {
    EXPECT_THROW(assemble_page({"none.html", "{}", {}}), std::logic_error);
    EXPECT_THROW(assemble_page({"pixel_page.html", "{}", {}}), std::logic_error);
}

}  // namespace
}  // namespace rt::page_test
