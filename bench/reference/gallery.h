// Machines of the gallery by closed forms written for each one alone, as SIMD loops: unknowns, rates and accelerations
// at input angles with one rate and acceleration. out[k][pose]; lengths m, angles rad.
#ifndef BENCH_GALLERY_H
#define BENCH_GALLERY_H
#include <stddef.h>

// in[0], in[1]: the inputs' positions.
typedef void (*GalleryForm)(const double *const *in, double w, double al, double *const *out, size_t n);
typedef struct GalleryMachine {
    const char *file, *channels; // examples/FILE.yaml; what out[] holds, by commas
    GalleryForm form;
    double from[2], to[2]; // of the inputs
    size_t inputs;
} GalleryMachine;
extern const GalleryMachine gallery_machines[];
extern const size_t gallery_count;

// The double pendulum, each state with its own lengths, masses and inertias: p[7] are l1 lc1 lc2 m1 m2 I1 I2.
void d1_batch(const double *const *p, const double *const *q, const double *const *v, double *const *a, size_t n);

#endif
