// Derivatives of positions by the parameters of a variant, exact, and at one transposed solution of the loops for each
// answer, whatever the number of parameters.
//
// With the inputs held the loops Phi(x, p) = 0 give J dx + Phi_p dp = 0. So an answer y(x, p) has the derivatives
// y_p - lambda^T Phi_p with J^T lambda = y_x. Both terms are sums over the points and directions of the model, whose
// derivatives by the parameters are those of their expressions; they are collected backwards along the tree.
// Source: Giles & Pierce 2000, Flow, Turbulence and Combustion 65; Griewank & Walther 2008, Evaluating Derivatives.
#ifndef COMPILE_GRADIENT_H
#define COMPILE_GRADIENT_H
#include <yoke/variant.h>
#include "compile/mechanism.h"

typedef struct YkGradient YkGradient;
typedef struct YkWeighted { // a part of an answer
    YkChannel channel;
    double weight;
} YkWeighted;

// Returns whether a channel has derivatives here: angles, distances and points, but no rates, forces, or angles of
// transmission.
bool yk_gradient_covers(YkChannel channel);
// Prepares the derivatives of a variant's machine, which must outlive them. Returns NULL when out of memory.
YkGradient *yk_gradient_new(const YkVariant *variant);
void yk_gradient_free(YkGradient *gradient);
// Takes the design that the variant has now. Returns false if an expression has no derivative there.
// Cost: that of the expressions, once for each parameter on which they depend; allocates nothing.
bool yk_gradient_design(YkGradient *gradient);
// Linearises the loops at a pose: x[yk_variable_count], as yk_closure takes them. Returns false if the loops do not
// determine the pose: at a dead point. Cost O(variables^3).
bool yk_gradient_pose(YkGradient *gradient, const double *x);
// Adds the derivatives of the sum of weighted channels to slope[parameters of the variant].
// Cost O(variables^2 + points that vary * parameters).
void yk_gradient_add(YkGradient *gradient, const YkWeighted *sum, size_t count, double *slope);

#endif
