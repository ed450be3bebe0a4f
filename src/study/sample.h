// Values of designs drawn from distributions. A value is a pure function of seed, design and parameter: the same on any
// thread, in any order, and after an interruption.
#ifndef STUDY_SAMPLE_H
#define STUDY_SAMPLE_H
#include <stdbool.h>
#include <stddef.h>
#include <yoke/study.h>

// Returns a uniform number in (0, 1), never an end: counter-based, two rounds of splitmix64 (Steele, Lea & Flood 2014).
double yk_uniform(uint64_t seed, uint64_t design, uint64_t parameter);
// The distribution function of the standard normal distribution and its inverse (Wichura 1988, algorithm AS 241:
// relative error about 1e-16).
double yk_normal_below(double x);
double yk_normal_quantile(double p);
// Returns the value below which a part p in (0, 1) of a distribution lies. Source (triangular): Evans et al. 2000.
double yk_distribution_quantile(const YkDistribution *distribution, double p);

#endif
