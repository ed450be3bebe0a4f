// Designs that a variant cannot follow - a parameter enters a wheel, a cam, a law, a constant angle - are machines of
// their own: the file is read and compiled anew with the design's values.
#ifndef STUDY_REMAKE_H
#define STUDY_REMAKE_H
#include "study/study.h"

// Takes what is needed to make the designs of a study. Returns false when out of memory.
bool yk_remake_start(YkStudy *study, const YkState *state, const YkStudyOptions *options);
void yk_remake_end(YkStudy *study);
// Solves a design with the worker's values and inputs: every pose, or their extents if the job asks for these.
YkStatus yk_remake_design(YkWorker *worker, const YkJob *job, size_t design);

#endif
