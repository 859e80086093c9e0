// What all scenes of a comparison share, and the command lines that follow from it.
#pragma once

#include <string>
#include <vector>

#include "commands/job/render_job.h"
#include "commands/versus/povray_words.h"
#include "commands/versus/versus_result.h"
#include "grading/sandbox.h"

namespace rt {

struct VersusSettings {
    std::vector<std::string> words;      ///< the picture's settings as options of ours, e.g. --width=640
    RenderJob job;                       ///< what they mean
    int threads = 1;                     ///< of each program
    bool alone = true;                   ///< one scene at a time: times are fair
    bool fresh = false;                  ///< POV-Ray's known pictures are not taken
    std::string program;                 ///< this one
    std::string povray;                  ///< path of the program
    std::string version;                 ///< what it says it is
    std::string povray_hash;             ///< fingerprint of the program
    std::vector<std::string> installed;  ///< its own folders of includes
    std::string folder;                  ///< of the output
    Containment containment;
    Limits limits;
    VersusLimits agreement;
};

/// The words as a job. Throws OptionError for a mistake in one of them.
RenderJob job_of_words(const std::vector<std::string>& words);

/// "povray +I... +O..." and "raytrace ... -o ..." for a scene and the file of its picture. They are run in the scene's folder: there
/// POV-Ray finds what a scene includes before it looks into its own folders, which hold files of usual names.
/// POV-Ray gets no settings but these: the .ini file that it takes in place of the user's and the system's says nothing.
std::vector<std::string> povray_command(const VersusSettings& settings, const std::string& scene, const std::string& picture,
                                        PovrayNames& names);
/// The same for a shell: it makes the links that names need, and removes them.
std::vector<std::string> povray_command_to_copy(const VersusSettings& settings, const std::string& scene, const std::string& picture);
/// What of it a picture depends on besides the files that are read. Throws OptionError for what POV-Ray's command line cannot say.
std::vector<std::string> povray_picture_words(const RenderJob& job);
/// In the folder of the output; it has to be there, and be empty, when POV-Ray runs.
std::string no_settings_file(const VersusSettings& settings);
std::vector<std::string> our_command(const VersusSettings& settings, const std::string& scene, Maker maker, const std::string& picture);
/// "povray.png", "same.png", "general.png".
std::string picture_name(Maker maker);

/// A command as text can hold it, which is UTF-8: with a word that is not, the same by a shell.
std::vector<std::string> command_as_text(std::vector<std::string> command);

/// The absolute path of POV-Ray: `named` if it is not empty, else the first one in $PATH. Throws OptionError that says how to install it.
std::string find_povray(const std::string& named);

/// The folders of includes that come with POV-Ray: beside the program, else the usual ones.
std::vector<std::string> installed_includes(const std::string& povray);

/// Where a program runs.
struct VersusPlace {
    std::string folder;          ///< may be written
    std::string working_folder;  ///< that, or one that may be read
};

/// A program of ours or POV-Ray, contained: it writes nowhere but in its place, has no network, and reads what the user may read.
Ending run_program_for(const VersusSettings& settings, const std::vector<std::string>& command, const VersusPlace& place, int slot);

}  // namespace rt
