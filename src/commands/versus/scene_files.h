// What a scene may read, found in its text.
#pragma once

#include <string>
#include <vector>

namespace rt {

/// Files that a scene and what it includes name between quotes, wherever a renderer would look for them.
struct SceneFiles {
    std::string fingerprint;  ///< of their names and contents, the scene's own content included
    bool complete = true;     ///< false: there may be more; names may be put together from parts, the time be asked for, or it is too much
};

/// `folders`: searched besides that of the scene and those of what names a file. `installed`: folders whose files may put strings
/// together. `words`: strings that the scene gets from outside.
SceneFiles files_of_scene(const std::string& scene, const std::vector<std::string>& folders, const std::vector<std::string>& installed,
                          const std::vector<std::string>& words);

}  // namespace rt
