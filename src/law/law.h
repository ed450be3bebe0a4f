// Scalar laws of motion: a value and its first four derivatives with respect to the argument (a cam angle, time, a
// coordinate). Made once, then constant; evaluation allocates nothing.
#ifndef LAW_LAW_H
#define LAW_LAW_H
#include <stdbool.h>
#include <stddef.h>

enum { YK_LAW_ORDER = 4 };

typedef struct YkLaw YkLaw;

// d[0] = the value, d[k] = the k-th derivative at x. A law with a period takes x modulo the period; one without keeps
// its end values outside its range (derivatives 0). At a joint of segments: what holds just after it. Cost O(log segments).
void yk_law_eval(const YkLaw *law, double x, double d[YK_LAW_ORDER + 1]);

#endif
