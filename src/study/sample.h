// Values of designs drawn from distributions. A value is a pure function of seed, design and parameter: the same on any
// thread, in any order, and after an interruption.
#ifndef STUDY_SAMPLE_H
#define STUDY_SAMPLE_H
#include <stdbool.h>
#include <stddef.h>
#include <yoke/study.h>

// The distribution function of the standard normal distribution and its inverse (Wichura 1988, algorithm AS 241:
// relative error about 1e-16).
double yk_normal_below(double x);
double yk_normal_quantile(double p);

#endif
