// Motion programs and cams in symbols: what the files of the section share.
#ifndef DERIVE_CAMS_CAMS_H
#define DERIVE_CAMS_CAMS_H
#include "derive/derive.h"
#include "law/law.h"
#include "model/laws/laws.h"

enum { YK_DERIVE_ORDERS = 4 }; // s, v, a, j

// A law that is being written, segment by segment.
typedef struct YkDeriveLaw {
    YkDerivation *d;
    YkPage *page;
    const YkModelLaw *law;
    const YkPoisson *theta; // its argument
    const char *theta_name;
    const YkPoisson *shown[YK_DERIVE_ORDERS];
    const YkPoisson *position;   // how shown[0] is written: the follower's coordinate if there is only one
    const YkPoisson *at, *value; // where the next segment starts; NULL: not mentioned
    const char *ending;          // of names in the present segment: "" or its number
    size_t index;                // of the segment
} YkDeriveLaw;

// A segment's own variable: u = (theta - from) / beta, or backwards (to - theta) / beta, 0 to 1.
typedef struct YkDeriveSpan {
    const YkPoisson *from, *to, *beta, *u; // beta: a symbol
    const YkPoisson *length;               // what beta is
} YkDeriveSpan;

// Returns a symbol of the section, made once under `key`; other pages find it again. *is_new: just made (cams.c).
int32_t yk_derive_once(YkDerivation *d, const char *key, const char *name, YkRingClass kind, bool is_angle,
                       bool *is_new);
// Does the same for a positive root whose square is `square`.
const YkPoisson *yk_derive_once_root(YkDerivation *d, const char *key, const char *name, const YkPoisson *square);
// Returns stem + the segment's ending, standing for `meaning`, and writes its line; `meaning` itself if it is a symbol.
const YkPoisson *yk_derive_call(YkDeriveLaw *law, const char *stem, const YkPoisson *meaning);
bool yk_derive_span(YkDeriveLaw *law, const YkPoisson *from, const YkPoisson *to, bool is_backwards,
                    YkDeriveSpan *span);
// Makes a symbol a constant with this value.
bool yk_derive_fix(YkDerivation *d, int32_t symbol, double value);
// Returns a constant of a cam, named by its stem and, if there are several cams, the cam.
int32_t yk_derive_cam_symbol(YkDerivation *d, const YkCam *cam, const char *stem, bool is_angle, bool *is_new);
// Returns the value of an element made only of parameters and constants.
double yk_derive_fixed(YkDerivation *d, const YkPoisson *a);
// Writes factor [...], with the inside by ascending powers of u if it is a polynomial in it.
void yk_derive_put_bracket(YkPage *page, YkLine *line, const YkPoisson *factor, const YkPoisson *inside,
                           const YkPoisson *u);
// Ends a line shown[order] = ...: its value, where it holds (`within` is in 0 to 1 there), its name in C.
void yk_derive_end_line(YkDeriveLaw *law, YkLine *line, int order, const YkPoisson *value, const YkPoisson *within,
                        const char *zone);
YkLine *yk_derive_begin_line(YkDeriveLaw *law, int order, const char *remark);

// Write one segment each (polynomial.c, rise.c).
void yk_derive_put_polynomial(YkDeriveLaw *law, const YkLawPart *part, YkLawSegment segment);
void yk_derive_put_rise(YkDeriveLaw *law, const YkLawPart *part);
// Writes the pitch curve, pressure angle and curvature of a cam (shape.c).
void yk_derive_put_cam(YkDerivation *d, YkPage *page, size_t cam);

#endif
