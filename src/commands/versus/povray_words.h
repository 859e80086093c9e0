// Names of files in POV-Ray's command line, whose words it reads as lines of an .ini file.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace rt {

/// Whether a word can hold it at all: printable ASCII without one of the two kinds of quotes, no longer than POV-Ray's room for it.
bool povray_can_say(const std::string& path);

/// Paths as POV-Ray reads them: plain ones as they are, others in quotes, and those that it cannot read by a link that it can.
class PovrayNames {
public:
    /// `folder` is where the links are; povray_can_say() it.
    explicit PovrayNames(std::string folder) : folder_(std::move(folder)) {}

    /// The word for `path`; where it takes a link, that has the name `plain`.
    std::string word(const std::string& path, const std::string& plain);
    /// (link, path) of what has been asked for.
    const std::vector<std::pair<std::string, std::string>>& links() const { return links_; }
    /// Makes the links. Throws OutputError.
    void make_links() const;
    /// A text with the paths in place of the links.
    std::string without_links(std::string text) const;

private:
    std::string folder_;
    std::vector<std::pair<std::string, std::string>> links_;
};

}  // namespace rt
