// The tables of the elementary functions, as tools/make-elementary computes them.
#ifndef ELEMENTARY_TABLES_H
#define ELEMENTARY_TABLES_H
#include <stdint.h>

typedef struct YkPowerOfTwo {
    double value, rest; // 2^(i/128) = value (1 + rest)
} YkPowerOfTwo;
extern const YkPowerOfTwo yk_powers_of_two[128];

typedef struct YkLogStep {
    double per, high, low; // a short reciprocal 1/c, and log c
} YkLogStep;
extern const YkLogStep yk_log_steps[128];

extern const uint64_t yk_two_over_pi[21];

typedef struct YkErfcPiece {
    double center, rest, by_power[14];
} YkErfcPiece;
extern const YkErfcPiece yk_erfc_pieces[24];

#endif
