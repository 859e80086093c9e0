// TrueType fonts: the outlines of characters and where they stand in a line. Everything in ems, the baseline at y = 0.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geometry/outline.h"

namespace rt {

class FontFile {
public:
    /// From the bytes of a font file. Throws std::invalid_argument if they are none that can be used.
    explicit FontFile(std::string bytes);
    ~FontFile();
    FontFile(const FontFile&) = delete;
    FontFile& operator=(const FontFile&) = delete;

    /// The number of the character's glyph; 0, the font's sign for what it lacks, if it has none.
    unsigned glyph(char32_t character) const;

    struct Shape {
        std::vector<CurvePiece> outline;  ///< closed loops, from the glyph's own origin
        double left = 0.0;                ///< least x
        double advance = 0.0;
    };
    Shape shape(unsigned glyph) const;
    /// What moves `second` towards `first` before it, from the font's horizontal table.
    double kerning(unsigned first, unsigned second) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rt
