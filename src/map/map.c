// Maps the motion of a machine with one freedom: the public functions.
#include "map/map.h"
#include "map/meshed.h"
#include <stdlib.h>
#include "base/problems.h"
#include "solve/state.h"

// --- the domain

static bool read_domain(YkMap *map, YkProblems *problems)
{
    YkTracer *t = &map->tracer;
    const double aside = 0.0123456789; // so that no domain ends where machines are special
    t->is_angle = !map->mech->coordinates[map->coordinate].is_distance;
    t->scale = t->is_angle ? 1 : map->mech->size;
    if (!t->is_angle) {
        t->high = yk_tracer_reach(map->mech) * (1 + aside);
        t->low = -t->high;
        return true;
    }
    t->period = yk_tracer_period(t);
    if (t->period == 0) return yk_map_refuse(problems, "it does not repeat after any number of turns up to 720", NULL);
    t->low = -YK_PI + aside;
    t->high = t->low + t->period;
    return true;
}

// --- making

void yk_map_free(YkMap *map)
{
    if (!map) return;
    for (size_t k = 0; map->strand_rows && k < map->leaves->count; k++) free(map->strand_rows[k].numbers);
    for (size_t k = 0; k < map->line_count; k++) free(map->lines[k].rows.numbers);
    for (size_t k = 0; k < map->mark_count; k++) free(map->marks[k].row);
    free(map->strand_rows);
    free(map->lines);
    free(map->marks);
    free(map->spans);
    free(map->circuit_of);
    free(map->branch_of);
    free(map->turns);
    yk_text_free(&map->picture);
    free(map->inputs);
    yk_tracer_end(&map->tracer);
    free(map);
}

// The input alone: one strand over the whole domain, tied to itself after its turns.
static void trace_input(YkTracer *t)
{
    YkStrand *root = yk_strand_new(t, 0, NULL);
    if (!root) return;
    // If nothing is followed on top of it, its own cells are the poses that are read.
    size_t cells = t->piece_count == 0 ? (size_t)((t->high - t->low) / (YK_TRACE_LONGEST * t->scale)) + 1 : 1;
    bool has_cells = true;
    for (size_t k = 0; k < cells && has_cells; k++) {
        double from = t->low + (t->high - t->low) * (double)k / (double)cells;
        double to = k + 1 == cells ? t->high : t->low + (t->high - t->low) * (double)(k + 1) / (double)cells;
        has_cells = yk_strand_add(t, root, (YkCell){.from = from, .to = to}, NULL, NULL);
    }
    if (!has_cells || !yk_strand_keep(t, root)) {
        yk_strand_free(root);
        return;
    }
    t->event_count = 1;
    if (t->is_angle) yk_trace_tie(t, 0, (YkTie){.kind = YK_TIE_ROUND, .strand = {root, root}, .end = {1, 0}});
}

static void trace_all(YkTracer *t)
{
    trace_input(t);
    for (size_t level = 1; level <= t->piece_count && !t->out_of_memory; level++) {
        yk_pace_reach(t->pace, (double)(level - 1) / (double)t->piece_count);
        yk_trace_level(t, level);
        yk_trace_carry(t, level);
    }
    if (t->repeats && !t->out_of_memory && !yk_pace_is_stopped(t->pace)) yk_repeated_sift(t);
}

// Writes the state's pose as a row, without the joints' angles; its joints are those of the coordinates.
static void read_start(const YkMap *map, const YkState *start, double *row)
{
    row[0] = yk_state_coordinate(start, map->coordinate).position;
    for (size_t c = 0; c < map->mech->coordinate_count; c++) row[1 + c] = yk_state_coordinate(start, c).position;
    for (size_t j = 0; j < map->joints; j++) {
        YkJointAngle a = yk_joint_angle(map->mech, (int32_t)j);
        YkTurn from = yk_space_turn(&start->space, a.a), to = yk_space_turn(&start->space, a.b);
        YkVec p = a.a == 0 ? yk_vec(1, 0) : yk_vec(from.c[0], from.s[0]);
        YkVec q = a.b == 0 ? yk_vec(1, 0) : yk_vec(to.c[0], to.s[0]);
        YkVec turn = yk_mul(q, yk_conj(p));
        row[yk_map_joint_column(map, j)] = (a.a == a.b ? 0 : yk_atan2(turn.y, turn.x)) + a.offset;
    }
}

static void find_start(YkMap *map, const YkState *start)
{
    double *own = calloc(2 * map->width, sizeof *own);
    map->start_leaf = YK_NOT_FOUND;
    if (!own) {
        map->tracer.out_of_memory = true;
        return;
    }
    read_start(map, start, own);
    map->start_at = own[0];
    map->start_leaf = yk_map_find_leaf(map, own, own + map->width);
    free(own);
}

// Returns 0 for what is 0 as far as places where solutions meet are known.
static double without_noise(const YkTracer *t, double at)
{
    return fabs(at) < 1e-9 * t->scale ? 0 : at;
}

static void tell_singles(const YkTracer *t, YkText *text)
{
    const size_t most = sizeof t->single / sizeof *t->single;
    size_t count = t->single_count;
    yk_text_format(text, "all constraints may also close in %z single pose%s, out of which it cannot move: near ",
                   count, count == 1 ? "" : "s");
    for (size_t k = 0; k < count && k < most; k++)
        yk_text_format(text, "%s%e", k == 0 ? "" : ", ", without_noise(t, t->single[k]));
    yk_text_format(text, " %s%s", t->is_angle ? "rad" : "m", count > most ? " and others" : "");
}

// Says that wheels count over all turns that their meshes allow.
static void tell_meshes(const YkTracer *t, YkText *text)
{
    for (size_t p = 0; p < t->piece_count; p++) {
        const char *kind, *label = yk_tracer_label(t, p, &kind);
        if (!t->pieces[p].meshed) continue;
        if (t->pieces[p].meshed->is_listed)
            yk_text_format(text, "; the wheels of `%s` mesh in %z ways, each of which counts", label,
                           yk_meshed_count(&t->pieces[p]));
        else
            yk_text_format(text, "; wheels of the group of joint `%s` count over all turns that their meshes allow",
                           label);
    }
}

void yk_map_tell(YkMap *map)
{
    YkTracer *t = &map->tracer;
    YkText text = {0};
    const char *kind, *label = yk_tracer_label(t, t->unproved_block, &kind);
    map->is_complete = !t->is_unproved && !t->is_searched && t->single_count == 0 && map->lost == 0 && map->has_start;
    if (t->is_unproved)
        yk_text_format(&text, "not all is proved: near %e %s, at %s`%s`", without_noise(t, t->unproved_at),
                       t->is_angle ? "rad" : "m", kind, label);
    else if (!map->has_start)
        yk_text_puts(&text, "the machine's own configuration is on none of the circuits");
    else if (t->single_count > 0)
        tell_singles(t, &text);
    else if (t->is_searched)
        yk_text_format(
            &text,
            "all configurations of the group of joint `%s`, which has gears, belts or racks, are known at many "
            "inputs and followed from there with proof; a circuit that lies between two of these inputs may "
            "be missing",
            yk_tracer_label(t, t->searched_piece, &kind));
    else if (map->lost > 0)
        yk_text_format(&text, "%z dead points were not found on the circuits, or not all are known", map->lost);
    else
        yk_text_format(&text, "between its events the number of configurations is proved constant%s",
                       t->repeats ? "; the constraints that repeat others close along them, to rounding" : "");
    if (!t->is_unproved && map->has_start) tell_meshes(t, &text);
    t->out_of_memory |= text.failed;
    yk_text_move(&text, map->message, sizeof map->message);
}

static bool make(YkMap *map, YkState *start, YkProblems *problems)
{
    YkTracer *t = &map->tracer;
    if (!yk_tracer_read(t, problems) || !read_domain(map, problems)) return false;
    trace_all(t);
    if (t->out_of_memory || yk_pace_is_stopped(t->pace)) return false;
    map->leaves = &t->levels[t->piece_count];
    bool ok = yk_map_read_rows(map);
    if (ok) find_start(map, start);
    ok = ok && !t->out_of_memory && yk_map_find_circuits(map) && yk_map_find_events(map) && yk_map_find_turns(map);
    t->out_of_memory |= !ok;
    if (ok) yk_map_tell(map);
    return !t->out_of_memory;
}

static bool is_mappable(const YkState *start, size_t coordinate, YkProblems *problems)
{
    const YkMechanism *mech = start->mech;
    if (coordinate >= mech->coordinate_count || mech->coordinates[coordinate].input == YK_NONE)
        return yk_map_refuse(problems, "the mapped coordinate is not an input", NULL);
    return start->has_pose ||
           yk_map_refuse(problems, "it is not assembled, so that it has no circuit of its own", NULL);
}

static bool begin(YkMap *map, const YkState *start, size_t coordinate)
{
    const YkMechanism *mech = start->mech;
    map->mech = mech;
    map->coordinate = coordinate;
    map->joints = yk_model_joint_count(mech->model);
    map->points = yk_model_point_count(mech->model);
    map->width = 1 + mech->coordinate_count + map->joints + 2 * map->points;
    map->inputs = calloc(mech->input_count + 1, sizeof *map->inputs);
    if (!map->inputs || !yk_tracer_begin(&map->tracer, mech)) return false;
    for (size_t k = 0; k < mech->input_count; k++) map->inputs[k] = start->valid_input[3 * k];
    map->tracer.start = start;
    map->tracer.discs.mapped = map->tracer.over.mapped = mech->coordinates[coordinate].input;
    map->tracer.discs.others = map->tracer.over.others = map->inputs;
    return true;
}

YkMap *yk_map_new(YkState *start, size_t coordinate, YkProblems *problems)
{
    if (!start || !is_mappable(start, coordinate, problems)) return NULL;
    YkMap *map = calloc(1, sizeof *map);
    bool ok = map && begin(map, start, coordinate), ran_out = !ok;
    if (ok) {
        bool is_own = yk_state_begin(start);
        map->tracer.pace = start->pace;
        ok = make(map, start, problems);
        ran_out = map->tracer.out_of_memory;
        map->tracer.pace = NULL;
        if (yk_state_end(start, is_own, YK_OK) == YK_STOPPED) {
            yk_problem_stopped(problems);
            ok = ran_out = false;
        }
    }
    if (ran_out) yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory");
    if (ok) return map;
    yk_map_free(map);
    return NULL;
}
