// The door for pages: one machine in one module, flat functions over it. Texts and numbers go in and out through two
// buffers; whoever calls looks at them anew after every call, since memory may have grown.
#ifndef CORE_CORE_H
#define CORE_CORE_H
#include <yoke/yoke.h>
#include "base/archive.h"
#include "base/text.h"
#include "picture/drawing/drawing.h"

enum { YK_GHOSTS = 16, YK_OVERRIDES = 64 };

// A value that a slider set, until the text is opened again.
typedef struct YkSlider {
    char *name, *value;
} YkSlider;

typedef struct YkCore {
    YkText text, input; // what goes out; what came in
    YkText message;     // about the last pose
    double *numbers;
    size_t number_count, number_capacity;
    YkText source, name; // the machine's text and the name of its file
    YkSlider sliders[YK_OVERRIDES];
    size_t slider_count;
    // The machine: all of it or nothing.
    YkSketch *sketch;
    const YkModel *model;    // of the sketch
    const YkMechanism *mech; // of the sketch, or `other`
    YkMechanism *other;      // the same machine with other inputs
    YkState *start, *state;  // as assembled; now. Of `mech`
    YkState *drawn;          // as the drawing was made; of the sketch's mechanism
    YkDrawing *drawing;      // at two poses: the one shown, and the scene's
    double scale;            // of the scene, px per metre; 0: as large as a page
    bool is_scheduled;       // the drives brought the state where it is
    YkDrag *drag;
    size_t drag_body;
    double drag_place[2];
    YkState *ghosts[YK_GHOSTS];
    size_t ghost_count;
    YkSimulation *simulation;
} YkCore;

extern YkCore yk_core;

// Makes room for numbers that go in or out. NULL when out of memory.
double *yk_core_room(size_t count);
// Lets everything go that holds on to the present state or mechanism: a drag, ghosts, a simulation.
void yk_core_settle(void);
void yk_core_close(void); // the machine
void yk_core_forget_sliders(void);
// Writes the present pose: numbers x, y, angle of each body, then each coordinate; text: the scene's parts. Says
// `message`, or why the state has the status.
int yk_core_tell(const YkState *state, YkStatus status, const char *message);
// Returns the state of the simulation and its time, s (may be NULL); NULL unless the machine was let go. core.wasm has
// no simulations (small/still.c).
const YkState *yk_core_simulated(double *time);
void yk_core_stop(void); // ends the simulation, and leaves the machine where it was let go
// Returns the state that is shown: the simulation's, or the present one.
const YkState *yk_core_shown(void);
// Returns where the model has what is drawn at a place of a body, m: drawings show a cam's follower where it rides.
YkVec yk_core_in_model(size_t body, YkVec drawn);
// Makes `names` inputs of the machine; the pose stays. Adds to problems (may be NULL).
YkStatus yk_core_use_inputs(const char *const *names, size_t count, YkProblems *problems);
// Makes the machine of the source and of the sliders; `from` (or NULL) is the machine before, whose assembly it takes.
// `drawn` (or NULL) holds the state at which to draw it.
bool yk_core_make(YkCore *made, const YkCore *from, YkArchive *drawn, YkProblems *problems);
// Writes a state, or reads it into one of the same mechanism.
void yk_core_walk_state(YkArchive *archive, YkState *state);
void yk_core_take(const YkCore *made);                        // puts it in the place of the present machine
void yk_core_release(YkCore *core);                           // frees what yk_core_make made
void yk_core_write(const YkCore *core, YkProblems *problems); // the results of opening, as JSON

#endif
