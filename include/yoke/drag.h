// Dragging: moves a point of a body towards a target as far as the machine allows, by continuous motion from its
// present pose, and never on another branch.
#ifndef YOKE_DRAG_H
#define YOKE_DRAG_H

#include <yoke/state.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkDrag YkDrag;

// Takes hold of a point of a body: place[2] in the body's axes, m. Inputs with is_fixed[input] (which may be NULL) and
// those held by a lock stay as they are; all others follow, driven ones too. Use one per thread; the state must outlive
// it. Returns NULL if the body index is out of range or memory runs out.
YK_API YkDrag *yk_drag_new(YkState *state, size_t body, const double place[2], const bool *is_fixed);
YK_API void yk_drag_free(YkDrag *drag);

typedef enum YkDragEnd {
    YK_DRAG_REACHED, // the point is at the target
    YK_DRAG_NEAREST, // every way from here leads farther away
    YK_DRAG_LIMIT,   // a block does not close beyond: a limit position or a dead point
    YK_DRAG_STOP,    // a stop of the file (`stops:`)
    YK_DRAG_SPENT    // several inputs: it gave up where further steps brought it hardly nearer
} YkDragEnd;
typedef struct YkDragged {
    YkDragEnd end;
    double distance;   // from the point to the target, m
    int block;         // LIMIT; otherwise -1
    int coordinate;    // STOP: of the tree; otherwise -1
    size_t pass_count; // change points passed on the way
} YkDragged;

// Drags the point towards target[2], world axes, m. With one free input the state ends at the first pose from which the
// distance would grow, or at the end of the motion, to 1e-9 of the input; a rise that begins and ends within one step
// of 8 degrees may be passed over. With several it follows the descent of the distance. At stops and limits it slides
// along just inside them, as long as that soon brings it nearer, and may give up (SPENT) before the nearest of their
// poses. All inputs keep their rates. Returns YK_OK, wherever it ended; YK_STOPPED (yk_state_set_progress);
// YK_BAD_ARGUMENT for a target that is not finite or a state without a pose. Allocates nothing. Cost with one free
// input: a few solutions every 8 degrees of the way; with n free inputs, n solutions a step, at most 300 steps.
YK_API YkStatus yk_state_drag(YkDrag *drag, const double target[2], YkDragged *dragged);

#ifdef __cplusplus
}
#endif

#endif
