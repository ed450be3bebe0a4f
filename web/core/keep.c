// The machine that is kept: taking its place, leaving it, and its states as bytes.
#include <stdlib.h>
#include "core.h"
#include "solve/state.h"

void yk_core_settle(void)
{
    yk_drag_free(yk_core.drag);
    for (size_t k = 0; k < yk_core.ghost_count; k++) yk_state_free(yk_core.ghosts[k]);
    yk_core_stop();
    yk_core.drag = NULL;
    yk_core.ghost_count = 0;
}

void yk_core_release(YkCore *core)
{
    yk_drawing_free(core->drawing);
    yk_state_free(core->start);
    yk_state_free(core->state);
    yk_state_free(core->drawn);
    yk_mechanism_free(core->other);
    yk_sketch_free(core->sketch);
    core->drawing = NULL;
    core->start = core->state = core->drawn = NULL;
    core->other = NULL;
    core->mech = NULL;
    core->model = NULL;
    core->sketch = NULL;
}

void yk_core_forget_sliders(void)
{
    for (size_t k = 0; k < yk_core.slider_count; k++) {
        free(yk_core.sliders[k].name);
        free(yk_core.sliders[k].value);
    }
    yk_core.slider_count = 0;
}

void yk_core_close(void)
{
    yk_core_settle();
    yk_core_release(&yk_core);
}

void yk_core_take(const YkCore *made)
{
    yk_core_close();
    yk_core.sketch = made->sketch;
    yk_core.model = made->model;
    yk_core.mech = made->mech;
    yk_core.start = made->start;
    yk_core.state = made->state;
    yk_core.drawn = made->drawn;
    yk_core.drawing = made->drawing;
    yk_core.is_scheduled = true;
}

void yk_core_walk_state(YkArchive *a, YkState *state)
{
    size_t inputs = yk_input_count(yk_state_mechanism(state));
    yk_state_archive(state, a);
    yk_archive_numbers(a, state->arrival, inputs);
    yk_archive_numbers(a, state->heading, inputs);
}
