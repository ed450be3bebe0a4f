// Open trees of pins in SIMD lanes: the rows that the kernels work on, filled from parameters.
#ifndef STUDY_TREE_BATCH_H
#define STUDY_TREE_BATCH_H
#include <yoke/study.h>
#include "compile/variant.h"
#include "equations/kernels_tree.h"

typedef struct YkTreeBatch YkTreeBatch;
// Returns NULL if the machine is not of this kind (*fits false), or when out of memory.
YkTreeBatch *yk_tree_batch_new(YkVariant *variant, const YkState *state, size_t parameter_count, bool *fits);
void yk_tree_batch_free(YkTreeBatch *batch);
// States [from, to) of the case.
YkStatus yk_tree_batch_run(YkTreeBatch *batch, const YkMotionCase *asked, size_t from, size_t to,
                           double *const *accelerations, signed char *status);

#endif
