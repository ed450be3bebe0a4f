// The stored start system of Alt's problem: generic places, and a solution of every triple of cognates there.
#ifndef SYNTHESIS_ALT_START_H
#define SYNTHESIS_ALT_START_H
#include "synthesis/nine_points/alt.h"

// Characters of a solution: 16 numbers of 32 bits (floats, real and imaginary parts of the unknowns in order), six bits
// a character (RFC 4648, table 1), without padding.
enum { YK_ALT_START_LENGTH = 86 };

extern const YkVec yk_alt_start_at[YK_ALT_PLACES];
extern const char yk_alt_start_text[YK_ALT_TRIPLES][YK_ALT_START_LENGTH + 1];

#endif
