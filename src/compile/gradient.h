// Derivatives of answers by the parameters of a variant, exact, and at a few transposed solutions of the loops for each
// answer, whatever the number of parameters.
//
// With the inputs given the loops R(x, p) = 0 hold over time, and so do their first and second derivatives R', R''
// along it, which are linear in x' and x'' with the same Jacobian J. An answer y(x, x', x'', p) has the derivatives
//
//     y_p - l2^T R''_p - l1^T R'_p - l0^T R_p:
//
// J^T l2 = y_x'', then J^T l1 = what y and l2^T R'' have by x', then J^T l0 = what y, R' and R'' have by x. All are
// sums of turned vectors, each with its derivatives by time (a jet), whose shares are handed backwards to angles,
// distances and the vectors, and by the recipe to points and lines of the model.
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

// Returns whether a channel of the mechanism has derivatives here: angles, distances and points with their rates and
// accelerations, and angles of transmission of dyads with three pins, or two and a line; no forces.
bool yk_gradient_covers(const YkMechanism *mech, YkChannel channel);
// Prepares the derivatives of a variant's machine, which must outlive them. Returns NULL when out of memory.
YkGradient *yk_gradient_new(const YkVariant *variant);
void yk_gradient_free(YkGradient *gradient);
// Takes the design that the variant has now. Returns false if an expression has no derivative there.
// Cost: that of the expressions, once for each parameter on which they depend; allocates nothing.
bool yk_gradient_design(YkGradient *gradient);
// Linearises the loops at a pose: x[yk_variable_count], as yk_closure takes them, and their rates and accelerations, or
// NULL if no answer depends on any. Returns false if the loops do not determine the pose: at a dead point. Cost
// O(variables^3).
bool yk_gradient_pose(YkGradient *gradient, const double *x, const double *rates, const double *accelerations);
// Adds the derivatives of an answer to slope[parameters of the variant]: start, take the share of each weighted channel
// or other value of the pose, and finish, which adds.
// Cost O(variables^2 + vectors that vary + points that vary * parameters).
void yk_gradient_start(YkGradient *gradient);
void yk_gradient_take(YkGradient *gradient, YkWeighted part);
void yk_gradient_finish(YkGradient *gradient, double *slope);
// The values, each with its derivatives by time, and the shares that answers have of them.
void yk_gradient_turn(const YkGradient *gradient, int32_t slot, double value[4]); // c, s, w, a
void yk_gradient_slide(const YkGradient *gradient, int32_t distance, double value[3]);
void yk_gradient_node(const YkGradient *gradient, int32_t node, double value[6]); // x, y, x', y', x'', y''
double yk_gradient_angle(const YkGradient *gradient, size_t coordinate);
void yk_gradient_take_turn(YkGradient *gradient, int32_t slot, const double share[4]);
void yk_gradient_take_slide(YkGradient *gradient, int32_t distance, const double share[3]);
void yk_gradient_take_node(YkGradient *gradient, int32_t node, const double share[6]);
void yk_gradient_take_angle(YkGradient *gradient, size_t coordinate, double share);
void yk_gradient_take_parameter(YkGradient *gradient, int32_t parameter, double share); // of the model

#endif
