// Makes the machine of a text: sketch, pose and drawing.
#include <stdlib.h>
#include "core.h"

enum { TOUR = 24, TOUR_BODIES = 200 };

// Takes the configuration of the machine before, at the inputs that it has.
static YkStatus take_assembly(YkState *state, const YkState *from)
{
    const YkMechanism *mech = yk_state_mechanism(state), *old = yk_state_mechanism(from);
    for (size_t i = 0; i < yk_input_count(mech); i++) {
        size_t k = yk_coordinate_find(old, yk_coordinate_info(mech, yk_input_coordinate(mech, i)).name);
        if (k != YK_NOT_FOUND) yk_state_set_input(state, i, yk_state_coordinate(from, k));
    }
    YkStatus status = yk_state_take_labels(state, from);
    if (status == YK_OK) return yk_state_solve(state);
    status = yk_state_guess(state, from);
    return status < 0 ? status : yk_state_assemble(state);
}

static bool make_states(YkCore *made, const YkCore *from, YkProblems *problems)
{
    made->start = yk_state_new(made->mech);
    made->state = yk_state_new(made->mech);
    if (!made->start || !made->state) return false;
    YkStatus status = yk_state_set_time(made->start, 0, problems);
    if (status >= 0) (void)yk_state_assemble(made->start);
    yk_state_copy(made->state, made->start);
    if (!from || !from->state || !yk_state_has_pose(from->state)) return true;
    return take_assembly(made->state, from->state) >= 0;
}

// Adds poses of one turn of the first input, so that the scene has room for the motion and rails are long enough.
static void tour(YkDrawing *drawing, const YkState *state)
{
    const YkMechanism *mech = yk_state_mechanism(state);
    bool is_short = yk_input_count(mech) == 0 || yk_model_body_count(yk_mechanism_model(mech)) > TOUR_BODIES;
    YkState *moving = is_short ? NULL : yk_state_new(mech);
    if (!moving) return;
    yk_state_copy(moving, state);
    YkMotion at = yk_state_input(state, 0);
    bool is_distance = yk_coordinate_info(mech, yk_input_coordinate(mech, 0)).is_distance;
    for (int k = 1; k < TOUR && !is_distance; k++) {
        yk_state_set_input_to(moving, 0, at.position + k * 2 * YK_PI / TOUR, at.velocity, at.acceleration);
        if (yk_state_solve(moving) >= 0) (void)yk_drawing_pose(drawing, moving);
    }
    yk_state_free(moving);
}

// Keeps the state at which the machine is drawn, so that another module can draw it alike.
static bool keep_drawn(YkCore *made, YkArchive *drawn)
{
    if (drawn) yk_core_walk_state(drawn, made->state);
    made->drawn = yk_state_new(made->mech);
    if (!made->drawn || (drawn && drawn->failed)) return false;
    return yk_state_copy(made->drawn, made->state) >= 0;
}

static bool make_drawing(YkCore *made)
{
    YkDrawOptions options = yk_default_draw_options();
    options.moving = true;
    if (!yk_state_has_pose(made->state)) return true;
    made->drawing = yk_drawing_new(made->mech, &options);
    if (!made->drawing) return false;
    made->drawing->fixed_scale = yk_core.scale;
    tour(made->drawing, made->state);
    for (int k = 0; k < 2; k++) {
        YkStatus status = yk_drawing_pose(made->drawing, made->state);
        if (status == YK_NO_MEMORY) return false;
        if (status >= 0) continue;
        yk_drawing_free(made->drawing); // a body without a place: it has no picture
        made->drawing = NULL;
        return true;
    }
    return true;
}

bool yk_core_make(YkCore *made, const YkCore *from, YkArchive *drawn, YkProblems *problems)
{
    YkOverride overrides[YK_OVERRIDES];
    YkLoadOptions options = yk_default_load_options();
    for (size_t k = 0; k < yk_core.slider_count; k++)
        overrides[k] = (YkOverride){yk_core.sliders[k].name, yk_core.sliders[k].value};
    options.parameters = overrides;
    options.parameter_count = yk_core.slider_count;
    made->sketch = yk_sketch_parse(yk_text_get(&yk_core.source), yk_core.source.length, yk_text_get(&yk_core.name),
                                   &options, problems);
    if (made->sketch) {
        made->model = yk_sketch_model(made->sketch);
        made->mech = yk_sketch_mechanism(made->sketch);
        if (make_states(made, from, problems) && keep_drawn(made, drawn) && make_drawing(made)) return true;
    }
    yk_core_release(made);
    return false;
}
