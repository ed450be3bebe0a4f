// Writes DXF.
#include "picture/dxf.h"
#include "base/number.h"

enum { DECIMALS = 9 };

// Writes a group: its code and its value, each on its own line.
static void group(YkText *dxf, int code, const char *value)
{
    yk_text_format(dxf, "%d\n%s\n", code, value);
}

static void number(YkText *dxf, int code, double value)
{
    char digits[YK_NUMBER_SIZE];
    yk_number_write_fixed(fabs(value) < 5e-10 ? 0 : value, DECIMALS, digits);
    group(dxf, code, digits);
}

static void point(YkText *dxf, int code, YkVec at)
{
    number(dxf, code, at.x);
    number(dxf, code + 10, at.y);
    number(dxf, code + 20, 0);
}

static void entity(YkText *dxf, const char *kind, const char *layer)
{
    group(dxf, 0, kind);
    group(dxf, 8, layer);
}

void yk_dxf_begin(YkText *dxf, const char *const *layers, size_t count)
{
    yk_text_puts(dxf, "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n9\n$MEASUREMENT\n70\n1\n0\nENDSEC\n");
    yk_text_format(dxf, "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n70\n%z\n", count);
    for (size_t i = 0; i < count; i++)
        yk_text_format(dxf, "0\nLAYER\n2\n%s\n70\n0\n62\n%d\n6\nCONTINUOUS\n", layers[i], (int)(i % 7) + 1);
    yk_text_puts(dxf, "0\nENDTAB\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n");
}

void yk_dxf_outline(YkText *dxf, const char *layer, const YkVec *points, size_t count)
{
    entity(dxf, "POLYLINE", layer);
    yk_text_puts(dxf, "66\n1\n70\n1\n"); // vertices follow; closed
    point(dxf, 10, yk_vec(0, 0));
    for (size_t i = 0; i < count; i++) {
        entity(dxf, "VERTEX", layer);
        point(dxf, 10, points[i]);
    }
    entity(dxf, "SEQEND", layer);
}

void yk_dxf_circle(YkText *dxf, const char *layer, YkVec center, double radius)
{
    entity(dxf, "CIRCLE", layer);
    point(dxf, 10, center);
    number(dxf, 40, radius);
}

void yk_dxf_line(YkText *dxf, const char *layer, YkVec a, YkVec b)
{
    entity(dxf, "LINE", layer);
    point(dxf, 10, a);
    point(dxf, 11, b);
}

void yk_dxf_end(YkText *dxf)
{
    yk_text_puts(dxf, "0\nENDSEC\n0\nEOF\n");
}
