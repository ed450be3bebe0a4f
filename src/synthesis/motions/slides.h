// Dyads with a slide, and orthogonal vectors of monomials.
#ifndef SYNTHESIS_SLIDES_H
#define SYNTHESIS_SLIDES_H
#include "synthesis/motions/poses.h"

// Makes v orthogonal to base[count], twice because once leaves rounding. Returns its length, and scales it to 1.
double yk_monomials_orthogonalise(double v[YK_MONOMIALS], double base[][YK_MONOMIALS], size_t count);
// Finds the dyad of monomials with p_0 = 0. Returns false for points at infinity on both sides.
bool yk_slide_dyad(const double p[YK_MONOMIALS], const YkPoseRows *rows, const YkPose *first, YkDyad *dyad);

#endif
