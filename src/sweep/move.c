// Moves to a pose: straight, or on a way round.
#include <yoke/move.h>
#include <stdlib.h>
#include <string.h>
#include "base/mix.h"
#include "sweep/turns.h"

YkMoveOptions yk_default_move_options(void)
{
    return (YkMoveOptions){.turn_max = 8 * YK_PI / 180, .detours = 200};
}

// One move in progress.
typedef struct Mover {
    YkState *state;
    const YkMoveOptions *options;
    YkMove *move;
    YkProblems *problems;
    double from, to, part; // of the present walk; the part that was reported last
} Mover;

// Reports how much of the way is done to those who watch.
static bool ask(void *context, double at)
{
    Mover *m = context;
    m->part = fmin(1, fmax(m->part, (at - m->from) / (m->to - m->from)));
    yk_pace_reach(m->state->pace, m->part);
    return !m->options->goes_on || m->options->goes_on(m->options->context, m->part);
}

static size_t goal_size(const YkState *s)
{
    return 3 * s->mech->input_count * sizeof(double);
}

static void keep_passes(YkMove *move, const YkWalk *walk, double from, double to)
{
    for (size_t k = 0; k < walk->event_count; k++) {
        const YkEvent *e = &walk->events[k];
        if (e->kind != YK_EVENT_CHANGE_POINT) continue;
        if (move->pass_count < YK_MOVE_PASSES)
            move->passes[move->pass_count] = (YkPass){e->block, (e->at - from) / (to - from)};
        move->pass_count++;
    }
    move->pass_count += walk->skipped_passes < 1e15 ? (size_t)walk->skipped_passes : (size_t)1e15;
}

static YkStatus arrive(YkWalk *w, double to, double way)
{
    yk_walk_arrive(w, way);
    YkStatus status = yk_path_probe(&w->path, to, false);
    status = yk_walk_clear_rates(w, to, way, status);
    return status == YK_SINGULAR ? yk_walk_take_limits(w, to, way) : status;
}

// Goes from `from` to `to` on the walk's path; the state ends there with the motion's own rates.
static YkStatus go(Mover *m, YkWalk *w, double from, double to)
{
    double at = from, period = w->path.is_line ? yk_turns_period(&w->path) : 0;
    m->from = from, m->to = to;
    w->arrived = ask;
    w->context = m;
    w->problems = m->problems;
    w->from = from;
    if (period == 0 && yk_walk_refuses(w, from, to)) return w->status;
    YkStatus status = yk_path_probe(&w->path, from, true);
    if (status == YK_LIMIT && w->path.is_line && from == 0) status = YK_SINGULAR; // the state stands there, to rounding
    bool ok = status >= 0;
    if (ok && period > 0) at = yk_turns_skip(w, period);
    ok = ok && at >= 0 && yk_walk_go(w, at, to);
    keep_passes(m->move, w, from, to);
    if (w->failed) return YK_NO_MEMORY;
    if (ok) return arrive(w, to, to > from ? 1 : -1);
    if (!yk_state_is_stopped(m->state)) yk_path_settle(&w->path);
    m->move->part = (w->path.last - from) / (to - from);
    m->move->block = w->limit_block;
    return w->status < 0 ? w->status : status < 0 ? status : YK_LIMIT;
}

static YkStatus walk(Mover *m, YkPath path, double from, double to)
{
    YkWalk w;
    YkStatus status = yk_walk_start(&w, path, m->options->turn_max) ? go(m, &w, from, to) : YK_NO_MEMORY;
    yk_walk_end(&w);
    return status;
}

// --- in a straight line

static bool is_there(const YkState *s, const double *goal)
{
    for (size_t i = 0; i < s->mech->input_count; i++)
        if (s->valid_input[3 * i] != goal[3 * i]) return false;
    return true;
}

// Moves straight. Without loops nothing can fail to close; if already at the goal, only the rates are new.
static YkStatus move_straight(Mover *m, const double *goal)
{
    YkState *s = m->state;
    if (s->mech->block_count == 0 || is_there(s, goal)) {
        memcpy(s->input, goal, goal_size(s));
        YkStatus status = yk_state_solve_unless_clear(s);
        if (status >= 0) yk_state_refer(s);
        return status;
    }
    YkPath path;
    yk_path_start_line(&path, s, goal);
    return walk(m, path, 0, 1);
}

// --- ways round

// A tree of poses that the machine can reach, grown towards random poses (LaValle 1998): from each new pose it tries
// the goal.
typedef struct Tree {
    YkState **nodes;
    size_t count;
    double *target; // scratch: [3 * input + k]
    uint64_t seed;
} Tree;

static const double BACK_OFF = 0.8, WORTH_IT = 0.02; // shares of the way to a limit

static double input_size(const YkMechanism *mech, size_t input)
{
    return mech->coordinates[mech->inputs[input]].is_distance ? mech->size : YK_PI;
}

// Chooses a point in the box round start and goal, widened by half a turn or the machine's size.
static void choose_target(Tree *tree, const double *from, const double *goal)
{
    const YkMechanism *mech = tree->nodes[0]->mech;
    for (size_t i = 0; i < mech->input_count; i++) {
        double size = input_size(mech, i), low = fmin(from[3 * i], goal[3 * i]) - size;
        double high = fmax(from[3 * i], goal[3 * i]) + size;
        tree->target[3 * i] = low + (high - low) * yk_mix_unit(&tree->seed);
        tree->target[3 * i + 1] = tree->target[3 * i + 2] = 0;
    }
}

static size_t nearest_node(const Tree *tree)
{
    const YkMechanism *mech = tree->nodes[0]->mech;
    size_t nearest = 0;
    double least = INFINITY;
    for (size_t k = 0; k < tree->count; k++) {
        double sum = 0;
        for (size_t i = 0; i < mech->input_count; i++) {
            double off = (tree->nodes[k]->valid_input[3 * i] - tree->target[3 * i]) / input_size(mech, i);
            sum += off * off;
        }
        if (sum < least) nearest = k;
        least = fmin(least, sum);
    }
    return nearest;
}

// Lets the witness remember what it received on the way to a node; one more than all nodes stands for the straight
// way.
static void remember(const Mover *m, size_t node)
{
    if (m->state->witness) m->state->witness->keep(m->state->witness, node);
}

// Stands at a node again, and lets the witness forget what it has received since.
static void go_back(const Mover *m, const YkState *node, size_t number)
{
    yk_state_take(m->state, node);
    if (m->state->witness) m->state->witness->recall(m->state->witness, number);
}

// Grows the tree from its nearest pose towards the target, up to a little before a limit.
static YkStatus grow(Mover *m, Tree *tree)
{
    size_t from = nearest_node(tree);
    const YkState *node = tree->nodes[from];
    go_back(m, node, from);
    YkStatus status = move_straight(m, tree->target);
    double part = BACK_OFF * m->move->part;
    if (status != YK_LIMIT || part < WORTH_IT) return status;
    for (size_t i = 0; i < node->mech->input_count; i++)
        tree->target[3 * i] = node->valid_input[3 * i] + part * (tree->target[3 * i] - node->valid_input[3 * i]);
    go_back(m, node, from);
    return move_straight(m, tree->target);
}

static bool add_node(Tree *tree, const YkState *state)
{
    YkState *node = yk_state_new(state->mech);
    if (!node) return false;
    yk_state_take(node, state);
    tree->nodes[tree->count++] = node;
    return true;
}

static YkStatus search(Mover *m, Tree *tree, const YkState *home, const double *goal)
{
    YkStatus status = add_node(tree, home) ? YK_LIMIT : YK_NO_MEMORY;
    for (size_t k = 0; k < m->options->detours && status == YK_LIMIT; k++) {
        choose_target(tree, home->valid_input, goal);
        status = grow(m, tree);
        if (status < 0) continue;
        remember(m, tree->count);
        status = add_node(tree, m->state) ? move_straight(m, goal) : YK_NO_MEMORY;
    }
    return status;
}

// Moves round a blocked straight way. The state is where that way ends, and returns there if there is no way round.
static YkStatus move_round(Mover *m, const YkState *home, const double *goal)
{
    YkState *s = m->state, *end = yk_state_new(s->mech);
    YkMove straight = *m->move;
    Tree tree = {.nodes = calloc(m->options->detours + 1, sizeof(YkState *)), .seed = 1};
    tree.target = calloc(3 * s->mech->input_count, sizeof *tree.target);
    YkStatus status = YK_NO_MEMORY;
    if (end && tree.nodes && tree.target) {
        yk_state_take(end, s);
        remember(m, m->options->detours + 1);
        status = search(m, &tree, home, goal);
        *m->move = straight;
        if (status >= 0) {
            m->move->is_detour = true;
            m->move->pass_count = 0;
        } else if (status == YK_LIMIT) {
            go_back(m, end, m->options->detours + 1);
        }
    }
    for (size_t k = 0; k < tree.count; k++) yk_state_free(tree.nodes[k]);
    free(tree.nodes);
    free(tree.target);
    yk_state_free(end);
    return status;
}

// --- the door

static YkStatus finish(YkState *s, YkMove *move, YkStatus status)
{
    if (yk_state_is_stopped(s)) status = YK_STOPPED;
    move->status = status;
    if (status >= 0) {
        move->part = 1;
        yk_path_refer_state(s);
    }
    return status;
}

static YkStatus move_to(Mover *m, const double *goal)
{
    YkState *s = m->state;
    bool may_go_round = s->mech->input_count > 1 && m->options->detours > 0;
    YkState *home = may_go_round ? yk_state_new(s->mech) : NULL;
    if (may_go_round && !home) return YK_NO_MEMORY;
    if (home) {
        yk_state_take(home, s);
        remember(m, 0);
    }
    YkStatus status = move_straight(m, goal);
    if (home && status == YK_LIMIT) status = move_round(m, home, goal);
    yk_state_free(home);
    return finish(s, m->move, status);
}

static YkMove new_move(void)
{
    return (YkMove){.block = -1};
}

YkStatus yk_state_move_to(YkState *s, const YkMotion *goal, const YkMoveOptions *options, YkMove *move)
{
    YkMoveOptions defaults = yk_default_move_options();
    YkMove unseen;
    Mover m = {.state = s, .options = options ? options : &defaults, .move = move ? move : &unseen};
    *m.move = new_move();
    double *to = calloc(3 * s->mech->input_count + 1, sizeof *to);
    if (!to) return m.move->status = YK_NO_MEMORY;
    bool good = s->has_pose && m.options->turn_max > 0;
    for (size_t i = 0; i < s->mech->input_count; i++) {
        to[3 * i] = goal[i].position;
        to[3 * i + 1] = goal[i].velocity;
        to[3 * i + 2] = goal[i].acceleration;
        good = good && isfinite(to[3 * i]) && isfinite(to[3 * i + 1]) && isfinite(to[3 * i + 2]);
    }
    bool is_own = yk_state_begin(s);
    YkStatus status = yk_state_end(s, is_own, good ? move_to(&m, to) : YK_BAD_ARGUMENT);
    free(to);
    return m.move->status = status;
}

// Returns whether all moving inputs do so at a constant rate: the way through time is then a straight line.
static bool is_steady(const YkState *s)
{
    for (size_t i = 0; i < s->mech->input_count; i++) {
        int32_t drive = s->mech->coordinates[s->mech->inputs[i]].drive;
        if (drive != YK_NONE && !s->is_held[3 * i] && !yk_model_drive_is_steady(s->mech->model, (size_t)drive))
            return false;
    }
    return true;
}

static YkStatus move_in_time(Mover *m, double time)
{
    YkState *s = m->state;
    double from = s->time;
    YkPath path;
    if (from == time || s->mech->block_count == 0) {
        YkStatus status = yk_state_set_time(s, time, m->problems);
        if (status >= 0) status = yk_state_solve_unless_clear(s);
        return finish(s, m->move, status);
    }
    if (!is_steady(s)) {
        yk_path_start(&path, s, -1);
        return finish(s, m->move, walk(m, path, from, time));
    }
    double *goal = calloc(3 * s->mech->input_count + 1, sizeof *goal);
    YkStatus status = goal ? yk_state_set_time(s, time, m->problems) : YK_NO_MEMORY;
    if (status >= 0) {
        memcpy(goal, s->input, goal_size(s));
        s->time = from;
        status = move_straight(m, goal);
        s->time = status >= 0 ? time : from + m->move->part * (time - from);
    }
    free(goal);
    return finish(s, m->move, status);
}

YkStatus yk_state_move_time(YkState *s, double time, const YkMoveOptions *options, YkMove *move, YkProblems *problems)
{
    YkMoveOptions defaults = yk_default_move_options();
    YkMove unseen;
    Mover m = {
        .state = s, .options = options ? options : &defaults, .move = move ? move : &unseen, .problems = problems};
    *m.move = new_move();
    bool good = s->has_pose && isfinite(time) && m.options->turn_max > 0;
    bool is_own = yk_state_begin(s);
    return m.move->status = yk_state_end(s, is_own, good ? move_in_time(&m, time) : YK_BAD_ARGUMENT);
}
