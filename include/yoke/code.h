// Code: C for one machine, printed from the steps that the engine runs.
#ifndef YOKE_CODE_H
#define YOKE_CODE_H

#include <yoke/progress.h>
#include <yoke/state.h>
#include <yoke/status.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkCSourceOptions {
    const char *prefix;        // starts every name in the file; NULL: made from the model's name
    bool single;               // float instead of double
    bool kinematics;           // only motion, no forces
    const char *const *inputs; // coordinates that are inputs, by name, before the file's drives
    size_t input_count;
    const YkState *pose; // gives the configuration in which the machine begins; NULL: assembled as `start:` says
    YkProgress progress; // watches the printing; {NULL}: not watched
} YkCSourceOptions;
YK_API YkCSourceOptions yk_default_c_source_options(void);

typedef struct YkCSource YkCSource;
// Prints C11 for the machine: its parameters as a struct, kinematics, forces, residuals, batches, and a self-test with
// poses computed by the engine. Returns NULL with problems added if the machine cannot be assembled or has a part that
// cannot be printed (E0660), or if it was stopped. The model may be freed afterwards. Cost: linear in the steps,
// quadratic in the freedoms.
YK_API YkCSource *yk_c_source_new(const YkModel *model, const YkCSourceOptions *options, YkProblems *problems);
YK_API const char *yk_c_source_text(const YkCSource *code);   // the whole file
YK_API const char *yk_c_source_prefix(const YkCSource *code); // the beginning of its names
YK_API void yk_c_source_free(YkCSource *code);

#ifdef __cplusplus
}
#endif

#endif
