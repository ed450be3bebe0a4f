// A law as the file gives it: `laws:` is read into it, the law is built from it once all values are known, and
// derivations show it.
#ifndef MODEL_LAWS_LAWS_H
#define MODEL_LAWS_LAWS_H
#include "law/build.h"
#include "model/model.h"

typedef struct YkLawNumber {
    YkExpr *expr; // NULL if not given
    double value; // SI; NaN if it could not be determined (reported)
    YkPlace place;
} YkLawNumber;

// {at: ..., s: ..., v: ..., a: ..., j: ..., p: ...}
typedef struct YkLawGiven {
    YkPlace place;
    YkLawNumber at, d[YK_LAW_ORDER + 1];
} YkLawGiven;

typedef struct YkLawPart { // a segment
    YkLawKind kind;        // a rise or fall with `law: spline` is a rise or fall here as well
    YkPlace place;
    YkLawNumber to, by, v, blend, b, c, d, degree;
    YkRise rise;
    bool is_spline;    // rise, fall: `law: spline`
    YkLawGiven *given; // conditions of a polynomial or spline; points that a spline rise passes through
    size_t given_count;
    const YkExpr *formula; // of the law's argument, which is called `argument` in it
    const char *argument;
    const char *written, *called; // the formula and its argument as the file has them
    double formula_value;         // where a change of the formula's parameters is seen; holds no value
} YkLawPart;

// Begins the name that a law's argument has in its formulas; the law's own name follows.
#define YK_LAW_ARGUMENT "argument of law "

typedef struct YkLawSource {
    bool is_bad;  // has a mistake that is reported: is not built
    bool is_made; // not of the file: the lift of a cam whose surface is given by arcs
    YkLawNumber from, period;
    YkLawPart *parts; // of `segments`
    size_t part_count;
    YkLawNumber (*points)[2]; // of `table`
    size_t point_count;
    YkTableShape between;
} YkLawSource;

#endif
