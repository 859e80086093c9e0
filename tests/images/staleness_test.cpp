// Every scene has its reference picture, made from the scene as it is now: recipes.json holds the hashes of the sources and pictures.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace staleness_test {
namespace {

namespace fs = std::filesystem;

const fs::path scenes = fs::path(PROJECT_ROOT) / "pov";
const fs::path references = fs::path(PROJECT_ROOT) / "reference";

nlohmann::json recipes() {
    std::ifstream file(references / "recipes.json");
    return nlohmann::json::parse(file).at("pictures");
}

/// Hashes by path of what sha256sum says about these files; a file that cannot be read has none.
std::map<std::string, std::string> sha256_of(const std::set<std::string>& paths) {
    std::string command = "sha256sum --";
    for (const std::string& path : paths) command += " '" + path + "'";
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen((command + " 2>/dev/null").c_str(), "r"), &pclose);
    std::string text;
    std::array<char, 4096> buffer{};
    for (std::size_t n; pipe && (n = fread(buffer.data(), 1, buffer.size(), pipe.get())) > 0;) text.append(buffer.data(), n);
    std::map<std::string, std::string> hashes;
    std::istringstream lines(text);
    for (std::string hash, path; lines >> hash >> path;) hashes[path] = hash;
    return hashes;
}

TEST(References, AreMadeFromTheScenesAsTheyAre) {
    const nlohmann::json pictures = recipes();
    std::map<std::string, std::set<std::string>> stated;  // path -> the hashes that recipes give it
    for (const auto& [name, recipe] : pictures.items()) {
        stated[references / (name + ".png")].insert(recipe.at("picture_sha256"));
        for (const auto& [source, hash] : recipe.at("sources_sha256").items()) stated[scenes / source].insert(hash);
    }
    ASSERT_GE(stated.size(), 60u);
    std::set<std::string> paths;
    for (const auto& [path, hashes] : stated) paths.insert(path);
    const auto actual = sha256_of(paths);
    for (const auto& [path, hashes] : stated) {
        const auto found = actual.find(path);
        ASSERT_NE(found, actual.end()) << path << " is missing";
        EXPECT_EQ(hashes, std::set<std::string>{found->second}) << path << " has changed: run reference/regenerate";
    }
}

/// Those of extremes/ and shading/ are about what POV-Ray has not; the former have their own truth.
TEST(References, EverySceneHasAPicture) {
    const nlohmann::json pictures = recipes();
    std::set<std::string> with_picture;
    for (const auto& [name, recipe] : pictures.items())
        for (const auto& [source, hash] : recipe.at("sources_sha256").items()) with_picture.insert(source);
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(scenes)) {
        const std::string scene = fs::relative(entry.path(), scenes);
        if (entry.path().extension() != ".pov" || scene.starts_with("errors/")) continue;
        if (scene.starts_with("extremes/") || scene.starts_with("shading/")) continue;
        ++count;
        EXPECT_TRUE(with_picture.contains(scene)) << scene << ": run reference/regenerate";
    }
    EXPECT_GE(count, 30);
}

TEST(References, AreSmall) {
    std::uintmax_t bytes = 0;
    for (const auto& entry : fs::directory_iterator(references)) bytes += entry.file_size();
    EXPECT_LT(bytes, 3u << 20);
}

/// The head of a scene says what it shows.
TEST(Scenes, OpenWithAComment) {
    for (const auto& entry : fs::recursive_directory_iterator(scenes)) {
        if (entry.path().extension() != ".pov" && entry.path().extension() != ".inc") continue;
        if (fs::relative(entry.path(), scenes).string().starts_with("errors/")) continue;
        std::ifstream file(entry.path());
        std::string line;
        std::getline(file, line);
        EXPECT_TRUE(line.starts_with("// ") && line.size() > 10) << entry.path();
    }
}

}  // namespace
}  // namespace staleness_test
