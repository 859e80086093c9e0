// POV-Ray's own vocabulary: its INI keys and its switches, and which option of ours each one is.
#pragma once

#include <span>
#include <string_view>

namespace rt {

/// One INI key. Every switch of POV-Ray is a short way to write some of them.
struct PovraySetting {
    enum class Kind {
        value,        ///< our `option` with the same value
        whole,        ///< the same of a whole number; POV-Ray cuts fractions off
        boolean,      ///< our `option` with on or off
        unavailable,  ///< asks, when on, for something that the program has not and that leaves the picture as it is: a note
        always_on,    ///< what the program does anyway: a note when off
        ignored,      ///< of no meaning here: a note
        command,      ///< one that the program does not start: a note
        settled,      ///< of no meaning here and nothing that anybody would miss
        unmodelled,   ///< changes the picture when on and is not available: an error
    };
    std::string_view key;
    Kind kind;
    std::string_view option = "";
};

/// One switch: the letters behind + or -, and the keys it sets. In the text `=!` takes the rest of the switch, which must not be empty,
/// `=?` takes it if there is one and is left out otherwise.
struct PovraySwitch {
    std::string_view letters;
    std::string_view plus;
    std::string_view minus;
};

std::span<const PovraySetting> povray_settings();
std::span<const PovraySwitch> povray_switches();

/// Case is ignored; null if there is none.
const PovraySetting* find_povray_setting(std::string_view key);
/// The switch with the longest letters that begin `text` (what follows + or -); null if there is none.
const PovraySwitch* find_povray_switch(std::string_view text);

}  // namespace rt
