// Many wrong pictures, the cause that each is given, and how often that is the right one.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "film/image_file.h"
#include "grading/suite.h"

namespace rt::test {

/// A test's arguments, and its scene's text or, if that is empty, the file.
struct SceneCase {
    std::string name, text;
    std::vector<std::string> options;  ///< behind scene and size
    int width = 320, height = 240;
};

class Confusion {
public:
    /// Makes a suite of the scenes in a folder that is removed at the end; what is expected comes from the program itself.
    explicit Confusion(const std::vector<SceneCase>& scenes);
    ~Confusion();
    Confusion(const Confusion&) = delete;
    Confusion& operator=(const Confusion&) = delete;

    /// Spoils every picture in every way, and lets every fault trace every scene. What still passes does not count.
    void run();

    /// One line a mistake: how often right, and what else it was called.
    std::string table() const;
    int right() const, asked() const;

private:
    struct Row {
        int right = 0, asked = 0, among_equals = 0;
        std::map<std::string, int> others;
    };
    void judge(const std::string& mistake, const std::vector<std::string>& causes, const TestCase& test, const StoredImage& expected,
               const StoredImage& actual);

    std::string folder_;
    Suite suite_;
    std::vector<std::pair<std::string, Row>> rows_;
};

}  // namespace rt::test
