// What the programs that write a page have in common.
#pragma once

#include <functional>
#include <string>

namespace rt::extremes {

struct Outcome {
    std::string html;
    bool right = false;  ///< every picture is as it has to be
};

/// `NAME FOLDER`: writes what `work` returns to FOLDER/FILE and prints that name. Returns the exit status: 0 if all is right, 1 if not, 2
/// for wrong arguments, 3 if something could not be read, rendered or written. That the page cannot be written is told before the work; an
/// older page stays until there is a new one.
int page_program(int argc, char** argv, const std::string& name, const std::string& file, const std::function<Outcome()>& work);

}  // namespace rt::extremes
