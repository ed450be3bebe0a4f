// A machine from a file or a text, assembled at a time.
#ifndef TESTS_DESIGN_ASSEMBLED_H
#define TESTS_DESIGN_ASSEMBLED_H
#include "check.h"
#include <yoke/yoke.h>

typedef struct Assembled {
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
} Assembled;

// Returns false if the machine cannot be assembled; assembled_close frees it in any case.
static inline bool assembled_open(Assembled *m, const char *path, const char *text, double time)
{
    *m = (Assembled){0};
    m->model = path ? yk_model_load(path, NULL, NULL) : yk_model_parse(text, strlen(text), "test.yaml", NULL, NULL);
    m->mech = m->model ? yk_mechanism_compile(m->model, NULL, NULL) : NULL;
    m->state = m->mech ? yk_state_new(m->mech) : NULL;
    return m->state && yk_state_set_time(m->state, time, NULL) >= 0 && yk_state_assemble(m->state) >= 0;
}

static inline void assembled_close(Assembled *m)
{
    yk_state_free(m->state);
    yk_mechanism_free(m->mech);
    yk_model_free(m->model);
}

#endif
