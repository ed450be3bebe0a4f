// Bounds a law's derivatives everywhere.
#include <math.h>
#include "law/law.h"

// Returns the lowest order at which a law is discontinuous: 0 for its value, 1 for its slope, 2 for its curvature; 3 if
// none of them jumps. A law with too many jumps to read them all is taken to jump in its value.
static int first_jump(const YkLaw *law)
{
    enum { JUMPS_MAX = 64 };
    YkLawJump jumps[JUMPS_MAX];
    int order = 3;
    size_t count = yk_law_jumps(law, jumps, JUMPS_MAX);
    for (size_t k = 0; k < count && k < JUMPS_MAX; k++) order = jumps[k].order < order ? jumps[k].order : order;
    return count > JUMPS_MAX ? 0 : order;
}

YkLawBound yk_law_bound(const YkLaw *law)
{
    const double out = 1 + 1e-6; // peaks are exact up to rounding
    int jump = first_jump(law);
    bool is_smooth = yk_law_range(law).period > 0 && jump > 1;
    YkLawPeak slope = yk_law_peak(law, 1), curvature = yk_law_peak(law, 2);
    return (YkLawBound){jump > 0, out * fabs(slope.value), is_smooth ? out * fabs(curvature.value) : INFINITY};
}
