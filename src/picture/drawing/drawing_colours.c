// The colours of bodies in drawings.
#include "picture/drawing/drawing.h"

// Muted colours that readers with red-green colour blindness can distinguish (after Okabe & Ito 2008, toned down).
static const YkColour palette[] = {
    {"#bcd5ea", "#1f5f99"}, {"#f4cfa8", "#b35a12"}, {"#bfe0cd", "#1d7350"}, {"#e3c6de", "#8a4480"},
    {"#f2e2a0", "#8f7400"}, {"#c4e2ef", "#2b7fa3"}, {"#f0c2b4", "#a93f22"}, {"#d3d0ea", "#554aa0"},
    {"#d5dfae", "#647a14"}, {"#d9d3cb", "#6a5a48"},
};

YkColour yk_drawing_colour(size_t body)
{
    if (body == 0) return (YkColour){"#e4e4e0", "#55585c"};
    return palette[(body - 1) % (sizeof palette / sizeof *palette)];
}
