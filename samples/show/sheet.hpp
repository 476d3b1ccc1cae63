// The page that every step picture shares: a title bar, one plain sentence, the area of the picture itself,
// and a panel with legend and numbers. Nothing overflows: long words end in "...", a long panel makes the
// page longer.
#pragma once
#include <string>
#include <vector>

#include "samples/show/canvas.hpp"

namespace relevo::show {

struct PanelRow {
    enum class Kind { Text, Quiet, Pair, Square, Line, Dashes, Dot, Ring, Ramp } kind = Kind::Text;
    std::string left, right;
    Rgba8 color = ink,
          other = ink;  // Square, Line, Dashes, Dot, Ring: the sample; Ramp: from `color` to `other`
};
struct PanelBlock {
    std::string title;
    std::vector<PanelRow> rows;
};

PanelRow words(std::string text);                    // wrapped
PanelRow quiet(std::string text);                    // wrapped, in grey
PanelRow pair(std::string name, std::string value);  // left and right
PanelRow sample(PanelRow::Kind kind, Rgba8 color, std::string name, std::string value = "");
PanelRow ramp(Rgba8 from, Rgba8 to, std::string low, std::string high);
std::vector<PanelRow> matrix_rows(const double (&rows)[4][4]);

struct Heading {
    int number = 1;  // 1..of
    int of = 17;
    std::string name;      // of the stage
    std::string sentence;  // what happens here
    std::string subject;   // scene and size
};

struct Page {
    Picture picture;
    Rect area;  // where the stage draws
};

// A page whose picture area is at least so big.
Page lay_out(const Heading& heading, const std::vector<PanelBlock>& panel, int area_width, int area_height);

// Words broken into lines of at most so many letters; a longer word is cut.
std::vector<std::string> wrapped(const std::string& text, int columns);

// A label with a light halo, so that it can be read on any drawing; kept inside the canvas's clip rectangle.
enum class Align { Left, Middle, Right };
void label(Canvas canvas, Spot at, const std::string& text, Rgba8 color, Align align = Align::Left);

inline constexpr int panel_columns = 32, page_margin = 20;
inline constexpr int diagram_width = 804, diagram_height = 800;  // pages of about 1280 x 960

}  // namespace relevo::show
