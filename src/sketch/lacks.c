// Lists what is missing: bodies, freedom, drives.
#include "sketch/sketch.h"

static void find_body(YkSketch *sketch)
{
    YkLack *lack = sketch->model->body_count == 1 ? yk_sketch_add(sketch, YK_LACK_BODY) : NULL;
    if (!lack) return;
    lack->text = "there is no body but the ground";
    lack->mend = "add a body that can move, and a joint that holds it to the ground";
}

static void find_freedom(YkSketch *sketch)
{
    bool is_still = sketch->model->body_count > 1 && yk_sketch_freedom(sketch) <= 0;
    YkLack *lack = is_still ? yk_sketch_add(sketch, YK_LACK_FREEDOM) : NULL;
    if (!lack) return;
    lack->text = "nothing can move: the joints take as many freedoms as the bodies have";
    lack->mend = "take out a joint or a body, or put a pin or pin-slot where a weld or slide is";
}

// Every input without a drive is a freedom of its own.
static void find_drives(YkSketch *sketch)
{
    bool has_masses = yk_model_loads(sketch->model).masses > 0;
    for (size_t i = 0; i < yk_input_count(sketch->mech); i++) {
        size_t coordinate = yk_input_coordinate(sketch->mech, i);
        YkCoordinateInfo info = yk_coordinate_info(sketch->mech, coordinate);
        YkLack *lack = info.has_drive || info.is_held ? NULL : yk_sketch_add(sketch, YK_LACK_DRIVE);
        if (!lack) continue;
        lack->is_optional = has_masses;
        lack->freedom = 1;
        lack->coordinate = coordinate;
        lack->path = yk_sketch_words(sketch, "drives/%s", info.name);
        lack->value = info.is_distance ? "0.1 m/s * t" : "1 rad/s * t";
        lack->text = yk_sketch_words(
            sketch, has_masses ? "nothing drives %q: masses and loads move it" : "nothing drives %q", info.name);
        lack->mend = yk_sketch_words(sketch, "drive it, as in `drives: {%s: %s}`%s", info.name, lack->value,
                                     has_masses ? "" : ", or give the bodies mass and let loads move them");
    }
}

void yk_sketch_find_lacks(YkSketch *sketch)
{
    find_body(sketch);
    yk_sketch_find_connections(sketch);
    find_freedom(sketch);
    find_drives(sketch);
    yk_sketch_find_ends(sketch);
}
