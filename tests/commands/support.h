// What the tests of the commands share: a folder of their own and the program as a child process.
#pragma once

#include <string>
#include <vector>

namespace rt::test {

/// An empty folder that is the current one while this lives and is removed afterwards.
class Workplace {
public:
    Workplace();
    ~Workplace();
    Workplace(const Workplace&) = delete;
    Workplace& operator=(const Workplace&) = delete;

    void write(const std::string& name, const std::string& text) const;
    bool has(const std::string& name) const;
    std::string read(const std::string& name) const;
    std::vector<std::string> files() const;  ///< sorted

private:
    std::string path_, before_;
};

struct Outcome {
    int status = -1;  ///< exit status, or 128 + signal
    std::string out, err;
};

/// Runs the program in the current folder. `out_file` receives standard output where it is not empty.
Outcome run(const std::vector<std::string>& words, const std::string& out_file = "");

/// Starts the program, waits until it has worker threads, sends it `signals` in one go and waits for its end.
Outcome run_and_interrupt(const std::vector<std::string>& words, const std::vector<int>& signals);

/// Starts the program, stops it as soon as a file in the current folder whose name contains `part` holds something, sends it `signals`
/// and lets it go on: they all arrive before it does anything else. Throws if the program ends without such a file.
Outcome run_and_interrupt_at_file(const std::vector<std::string>& words, const std::string& part, const std::vector<int>& signals);

/// A small scene that renders at once: a lit sphere.
extern const char* const small_scene;
/// An egg of coloured glass over a mirroring floor under two lamps, as the course and as POV-Ray read it.
extern const char* const glass_scene;

}  // namespace rt::test
