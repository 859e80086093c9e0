#include "commands/base/content_hash.h"

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

namespace rt {

namespace {

namespace fs = std::filesystem;

std::string text_of(const XXH128_hash_t& hash) { return fmt::format("{:016x}{:016x}", hash.high64, hash.low64); }

}  // namespace

std::string hash_of(std::string_view bytes) { return text_of(XXH3_128bits(bytes.data(), bytes.size())); }

std::string hash_of_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return "-";
    XXH3_state_t* state = XXH3_createState();
    XXH3_128bits_reset(state);
    std::vector<char> block(1u << 18);
    while (file) {
        file.read(block.data(), static_cast<std::streamsize>(block.size()));
        XXH3_128bits_update(state, block.data(), static_cast<std::size_t>(file.gcount()));
    }
    const XXH128_hash_t hash = XXH3_128bits_digest(state);
    XXH3_freeState(state);
    return text_of(hash);
}

std::string hash_of_folder(const std::string& path) {
    std::vector<std::string> lines;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(path, fs::directory_options::skip_permission_denied, error), end; entry != end && !error;
         entry.increment(error)) {
        const std::string name = entry->path().lexically_relative(path).string();
        std::error_code none;
        if (entry->is_symlink(none)) {
            lines.push_back(fmt::format("{}\n>{}", name, fs::read_symlink(entry->path(), none).string()));
        } else if (entry->is_regular_file(none)) {
            const bool executable = (entry->status(none).permissions() & fs::perms::owner_exec) != fs::perms::none;
            lines.push_back(fmt::format("{}\n{}{}", name, executable ? '*' : '=', hash_of_file(entry->path().string())));
        }
    }
    std::sort(lines.begin(), lines.end());
    return hash_of(fmt::format("{}", fmt::join(lines, "\n")));
}

}  // namespace rt
