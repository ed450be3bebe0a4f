// Words of `yoke rest` for stability and modes, in all formats.
#include <math.h>
#include "verbs/rest/rest.h"

static const double full_turn = 6.28318530717958647692;

const char *yk_stability_word(YkStability stability)
{
    static const char *const words[] = {"stable", "unstable", "neutral", "none"};
    return words[stability];
}

double yk_mode_hertz(YkMode mode)
{
    return mode.frequency >= 0 ? mode.frequency / full_turn : (double)NAN;
}
