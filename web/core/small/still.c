// core.wasm draws and moves; it has no simulations, which are in panels.wasm.
#include "core.h"

const YkState *yk_core_simulated(double *time)
{
    (void)time;
    return NULL;
}

void yk_core_stop(void) {}
