#include "commands/versus/scene_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>

#include "commands/base/content_hash.h"
#include "core/source.h"
#include "syntax/file_text.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

// Beyond these, what a scene reads is not found out: looking for it is no render that may take its time.
constexpr std::size_t most_text = 1u << 26, most_files = 10'000, most_names = 2'000, longest_name = 1024;
constexpr std::uintmax_t most_scene_bytes = 1u << 30;  ///< of all files together

/// Files that tell of the machine: they may never end, and say something else each time.
bool is_of_the_system(const fs::path& path) {
    const std::string name = path.string();
    return name.starts_with("/proc/") || name.starts_with("/sys/");
}

/// What a name may lack, as POV-Ray tries it.
constexpr std::array endings = {"",     ".inc",  ".INC",  ".pov", ".POV", ".png",  ".PNG",  ".gif", ".GIF", ".tga", ".TGA", ".jpg",
                                ".JPG", ".jpeg", ".JPEG", ".tif", ".TIF", ".tiff", ".TIFF", ".ppm", ".PPM", ".pgm", ".PGM", ".bmp",
                                ".BMP", ".exr",  ".EXR",  ".hdr", ".HDR", ".iff",  ".IFF",  ".ttf", ".TTF", ".df3", ".DF3"};

bool is_word_character(char c) { return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; }

/// Whether a text has a word that puts a name together or makes two renders of it differ.
bool computes(std::string_view text) {
    constexpr std::array<std::string_view, 9> functions = {"concat", "chr", "str", "vstr", "strlwr", "strupr", "substr", "datetime", "now"};
    for (std::size_t begin = 0; begin < text.size(); ++begin) {
        std::size_t end = begin;
        while (end < text.size() && is_word_character(text[end])) ++end;
        if (std::find(functions.begin(), functions.end(), text.substr(begin, end - begin)) != functions.end()) return true;
        begin = end;
    }
    return false;
}

class Search {
public:
    Search(const std::vector<std::string>& folders, const std::vector<std::string>& installed) : folders_(folders), installed_(installed) {}

    SceneFiles run(const std::string& scene, const std::vector<std::string>& words) {
        scene_folder_ = fs::path(scene).parent_path();
        add("", scene);
        for (const std::string& word : words) look_for(word, scene_folder_);
        while (!open_.empty() && files_.complete) {
            const fs::path file = open_.back();
            open_.pop_back();
            read(file);
        }
        files_.fingerprint = hash_of(lines_);
        return files_;
    }

private:
    bool is_installed(const fs::path& file) const {
        return std::any_of(installed_.begin(), installed_.end(), [&](const std::string& folder) {
            const fs::path inner = file.lexically_relative(folder);
            return !inner.empty() && *inner.begin() != "..";
        });
    }

    void read(const fs::path& file) {
        std::optional<std::string> text;
        try {
            text = read_file_text(file.string(), most_text);
        } catch (const LimitError&) {
            files_.complete = false;
        }
        if (!text) return;
        if (!is_installed(file) && computes(*text)) files_.complete = false;
        // Between any two quotes: one in a comment may have no other.
        for (std::size_t begin = text->find('"'); begin != text->npos;) {
            const std::size_t end = text->find('"', begin + 1);
            if (end == text->npos) break;
            const std::string name = text->substr(begin + 1, end - begin - 1);
            if (!name.empty() && name.size() <= longest_name && name.find('\n') == name.npos) look_for(name, file.parent_path());
            begin = end;
        }
    }

    void look_for(const std::string& name, const fs::path& folder) {
        if (name.find('\0') != name.npos || !asked_.emplace(name, folder.string()).second) return;
        if (asked_.size() > most_names) files_.complete = false;
        if (!files_.complete) return;
        std::vector<fs::path> places = {folder, scene_folder_};
        places.insert(places.end(), folders_.begin(), folders_.end());
        for (const fs::path& place : places)
            for (const char* ending : endings) add(name, place / (name + ending));
    }

    void add(const std::string& name, const fs::path& file) {
        std::error_code none;
        if (!fs::is_regular_file(file, none)) return;
        const fs::path path = fs::canonical(file, none);
        const auto [entry, is_new] = known_.try_emplace(path);
        if (is_new) {
            bytes_ += std::min(fs::file_size(path, none), most_scene_bytes + 1);
            if (known_.size() > most_files || bytes_ > most_scene_bytes || is_of_the_system(path)) files_.complete = false;
            if (!files_.complete) return;
            entry->second = hash_of_file(path.string());
            open_.push_back(path);
        }
        lines_ += fmt::format("{}\n{}\n", name, entry->second);
    }

    const std::vector<std::string>& folders_;
    const std::vector<std::string>& installed_;
    fs::path scene_folder_;
    SceneFiles files_;
    std::string lines_;
    std::vector<fs::path> open_;
    std::map<fs::path, std::string> known_;  ///< and its fingerprint
    std::uintmax_t bytes_ = 0;               ///< of those
    std::set<std::pair<std::string, std::string>> asked_;
};

}  // namespace

SceneFiles files_of_scene(const std::string& scene, const std::vector<std::string>& folders, const std::vector<std::string>& installed,
                          const std::vector<std::string>& words) {
    return Search(folders, installed).run(scene, words);
}

}  // namespace rt
