// Evens out the structural error of a function generator.
#ifndef SYNTHESIS_EVEN_H
#define SYNTHESIS_EVEN_H
#include "synthesis/tasks/task.h"

// A four-bar on a ground of 1: its links, and the angles of input and output where the range begins. For a slider-crank
// `output` is the offset of the slider's line, with a sign, and psi the place of the slider along it.
typedef struct YkGenerator {
    double input, coupler, output, phi, psi;
} YkGenerator;

enum { YK_EVEN_ROWS = 181 };
// Evens out the errors of a machine that meets five points of the function: its six largest become alike, with
// alternating signs, and the least largest error is found nearby. Gives the five pairs that it then meets, f->pair, and
// the largest error before, rad or m, with all errors before over the inputs, [input, error]. Returns false, and
// changes nothing, where the errors do not alternate or it does not close.
bool yk_even_out(const YkTask *task, YkFunctionTask *f, YkGenerator *bar, double *before,
                 double errors[2 * YK_EVEN_ROWS]);

#endif
