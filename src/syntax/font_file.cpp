#include "syntax/font_file.h"

#include <ft2build.h>

#include <stdexcept>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

namespace rt {

struct FontFile::State {
    std::string bytes;
    FT_Library library = nullptr;
    FT_Face face = nullptr;

    explicit State(std::string b) : bytes(std::move(b)) {
        if (FT_Init_FreeType(&library) != 0) throw std::invalid_argument("FreeType cannot be used");
        const auto size = static_cast<FT_Long>(bytes.size());
        if (FT_New_Memory_Face(library, reinterpret_cast<const FT_Byte*>(bytes.data()), size, 0, &face) != 0 || !FT_IS_SCALABLE(face) ||
            face->units_per_EM == 0) {
            release();
            throw std::invalid_argument("not a font of outlines");
        }
        if (face->charmap == nullptr && face->num_charmaps > 0) FT_Set_Charmap(face, face->charmaps[0]);
    }
    ~State() { release(); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    void release() {
        if (face) FT_Done_Face(face);
        if (library) FT_Done_FreeType(library);
        face = nullptr;
        library = nullptr;
    }
    double ems(FT_Pos units) const { return static_cast<double>(units) / face->units_per_EM; }
};

namespace {

/// One contour of a TrueType outline: points on the curve, and points that bend it. Between two of the latter lies one of the former, half
/// way.
class Contour {
public:
    Contour(const FT_Outline& outline, int first, int last, double em)
        : outline_(outline), first_(first), count_(last - first + 1), em_(em) {}

    void add_to(std::vector<CurvePiece>& pieces) const {
        if (count_ < 2) return;
        const Vec2 start = on(0) ? point(0) : on(count_ - 1) ? point(count_ - 1) : 0.5 * (point(0) + point(count_ - 1));
        Vec2 from = start;
        const int begin = on(0) ? 1 : 0, end = on(0) || !on(count_ - 1) ? count_ : count_ - 1;
        for (int i = begin; i < end; ++i) {
            if (on(i)) {
                if (point(i) != from) pieces.push_back(CurvePiece::line(from, point(i)));
                from = point(i);
                continue;
            }
            const bool last = i + 1 == end;
            const Vec2 to = last ? start : on(i + 1) ? point(i + 1) : 0.5 * (point(i) + point(i + 1));
            pieces.push_back(CurvePiece::quadratic(from, point(i), to));
            from = to;
            if (!last && on(i + 1)) ++i;
        }
        if (from != start) pieces.push_back(CurvePiece::line(from, start));
    }

private:
    Vec2 point(int i) const {
        const FT_Vector& p = outline_.points[first_ + i];
        return {static_cast<double>(p.x) / em_, static_cast<double>(p.y) / em_};
    }
    bool on(int i) const { return FT_CURVE_TAG(outline_.tags[first_ + i]) == FT_CURVE_TAG_ON; }

    const FT_Outline& outline_;
    int first_, count_;
    double em_;
};

}  // namespace

FontFile::FontFile(std::string bytes) : state_(std::make_unique<State>(std::move(bytes))) {}
FontFile::~FontFile() = default;

unsigned FontFile::glyph(char32_t character) const { return FT_Get_Char_Index(state_->face, character); }

FontFile::Shape FontFile::shape(unsigned glyph) const {
    Shape shape;
    const FT_Face face = state_->face;
    if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_SCALE | FT_LOAD_NO_BITMAP) != 0 || face->glyph->format != FT_GLYPH_FORMAT_OUTLINE)
        return shape;
    shape.advance = state_->ems(face->glyph->metrics.horiAdvance);
    shape.left = state_->ems(face->glyph->metrics.horiBearingX);
    const FT_Outline& outline = face->glyph->outline;
    int first = 0;
    for (int i = 0; i < outline.n_contours; ++i) {
        const int last = outline.contours[i];
        Contour(outline, first, last, face->units_per_EM).add_to(shape.outline);
        first = last + 1;
    }
    return shape;
}

double FontFile::kerning(unsigned first, unsigned second) const {
    FT_Vector by{};
    if (FT_Get_Kerning(state_->face, first, second, FT_KERNING_UNSCALED, &by) != 0) return 0.0;
    return state_->ems(by.x);
}

}  // namespace rt
