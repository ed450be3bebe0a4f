// Maps two freedoms: the public functions.
#include "map/workspace/regions.h"
#include <math.h>
#include <stdlib.h>
#include "base/problems.h"
#include "solve/state.h"

YkRegionsOptions yk_default_regions_options(void)
{
    return (YkRegionsOptions){.tolerance = 1e-3};
}

// --- making

void yk_regions_free(YkRegions *r)
{
    if (!r) return;
    for (size_t k = 0; k < r->count; k++) {
        for (size_t o = 0; o < r->parts[k].outline_count; o++) free(r->parts[k].outlines[o].points);
        free(r->parts[k].outlines);
        free(r->parts[k].bounds);
    }
    free(r->parts);
    yk_runs_end(&r->runs);
    free(r->inputs);
    yk_text_free(&r->picture);
    yk_field_end(&r->field);
    free(r);
}

static bool is_mappable(const YkState *start, const size_t *coordinate, double tolerance, YkProblems *problems)
{
    const YkMechanism *mech = start->mech;
    for (int k = 0; k < 2; k++)
        if (coordinate[k] >= mech->coordinate_count || mech->coordinates[coordinate[k]].input == YK_NONE)
            return yk_map_refuse(problems, "the mapped coordinate is not an input", NULL);
    if (coordinate[0] == coordinate[1])
        return yk_map_refuse(problems, "it is to be mapped over the same coordinate twice", NULL);
    if (!(tolerance >= 1e-4 && tolerance <= 0.1))
        return yk_map_refuse(problems, "the tolerance is not between 0.0001 and 0.1", NULL);
    if (mech->block_count + 1 >= YK_BOX_LEVELS) return yk_map_refuse(problems, "it has too many blocks", NULL);
    return start->has_pose || yk_map_refuse(problems, "it is not assembled", NULL);
}

static bool begin(YkRegions *r, const YkState *start, const size_t *coordinate)
{
    const YkMechanism *mech = start->mech;
    YkTracer *t = &r->field.tracer;
    r->mech = mech;
    r->inputs = calloc(mech->input_count + 1, sizeof *r->inputs);
    if (!yk_tracer_begin(t, mech) || !r->inputs) return false;
    for (size_t k = 0; k < mech->input_count; k++) r->inputs[k] = start->valid_input[3 * k];
    for (int k = 0; k < 2; k++) {
        r->coordinate[k] = coordinate[k];
        r->field.is_angle[k] = !mech->coordinates[coordinate[k]].is_distance;
        r->start[k] = r->inputs[mech->coordinates[coordinate[k]].input];
    }
    t->discs.mapped = mech->coordinates[coordinate[0]].input;
    t->discs.second = mech->coordinates[coordinate[1]].input;
    t->discs.others = r->inputs;
    return true;
}

// Returns the cell of a pose; false outside of the domain.
static bool find_cell(const YkRegions *r, double first, double second, size_t *cell)
{
    const YkField *f = &r->field;
    double at[2] = {first, second};
    size_t index[2];
    for (int k = 0; k < 2; k++) {
        double place = (at[k] - f->low[k]) / f->step[k];
        if (!(place >= 0 && place <= (double)f->n)) return false;
        index[k] = place < (double)f->n ? (size_t)place : f->n - 1;
    }
    *cell = index[1] * f->n + index[0];
    return true;
}

static void find_start(YkRegions *r)
{
    size_t cell;
    for (int k = 0; k < 2; k++) {
        double length = r->field.high[k] - r->field.low[k];
        if (r->field.is_angle[k]) r->start[k] -= length * floor((r->start[k] - r->field.low[k]) / length);
    }
    if (!find_cell(r, r->start[0], r->start[1], &cell)) return;
    uint32_t part = yk_runs_part(&r->runs, cell % r->field.n, cell / r->field.n);
    if (part > 0) r->parts[part - 1].region.contains_start = true;
}

static int compare(const void *a, const void *b)
{
    const YkTract *p = a, *q = b;
    if (p->region.contains_start != q->region.contains_start) return p->region.contains_start ? -1 : 1;
    if (p->region.area != q->region.area) return p->region.area > q->region.area ? -1 : 1;
    return p->cell < q->cell ? -1 : p->cell > q->cell;
}

// Rounds a place to the decimals to which it is known: it was found on poses a tenth of a cell apart.
static double known(const YkField *f, int axis, double at)
{
    double tens = 1;
    while (tens < 1e4 / f->step[axis]) tens *= 10;
    return rint(at * tens) / tens + 0.0; // -0 becomes 0
}

// Lists the places of one kind, if there are any.
static void tell_places(const YkRegions *r, bool is_touch, const char *what, YkText *text)
{
    enum { SHOWN = 4 };
    const YkField *f = &r->field;
    size_t count = 0;
    for (size_t k = 0; k < f->fold_count; k++) {
        const YkFoldPlace *p = &f->folds[k];
        if (p->is_touch != is_touch || count++ >= SHOWN) continue;
        yk_text_format(text, "%sjoint `%s` at %e %s, %e %s", count == 1 ? what : "; ",
                       r->mech->blocks[f->tracer.pieces[p->level].block].label, known(f, 0, p->at[0]),
                       f->is_angle[0] ? "rad" : "m", known(f, 1, p->at[1]), f->is_angle[1] ? "rad" : "m");
    }
    if (count > SHOWN) yk_text_format(text, "; and %z others", count - SHOWN);
}

static void tell_proved(const YkRegions *r, double percent, YkText *text)
{
    yk_text_format(text, "the number of configurations is proved in %g %% of the map, all but strips along the curves",
                   percent);
    tell_places(r, false, " and places where a dyad of equal links turns freely: ", text);
    tell_places(r, true, " and single places where two configurations meet: ", text);
}

static void tell(YkRegions *r)
{
    YkField *f = &r->field;
    YkText text = {0};
    size_t stray = yk_field_stray(f);
    double percent = floor(10000 * (double)f->proved / ((double)f->n * (double)f->n)) / 100;
    r->is_complete = stray == f->n * f->n && f->lost == 0 && !f->tracer.is_unproved;
    if (f->tracer.is_unproved)
        yk_text_format(&text, "the complex solutions of the group of joint `%s` were not all known from the start",
                       r->mech->blocks[f->tracer.pieces[f->tracer.unproved_block].block].label);
    else if (f->lost > 0)
        yk_text_format(&text, "the number of configurations could not be found in %z squares", f->lost);
    else if (stray < f->n * f->n)
        yk_text_format(
            &text,
            "the number of configurations is proved in %g %% of the map; away from the curves, near %e %s, %e %s, "
            "it is not: configurations may meet there, or the tolerance is too wide",
            percent, yk_field_center(f, 0, stray % f->n), f->is_angle[0] ? "rad" : "m",
            yk_field_center(f, 1, stray / f->n), f->is_angle[1] ? "rad" : "m");
    else
        tell_proved(r, percent, &text);
    f->tracer.out_of_memory |= text.failed;
    yk_text_move(&text, r->message, sizeof r->message);
}

// Reads what is followed. Returns false with a problem if the machine cannot be mapped.
static bool read_pieces(YkRegions *r, YkProblems *problems)
{
    YkTracer *t = &r->field.tracer;
    bool has_angle = r->field.is_angle[0] || r->field.is_angle[1];
    if (!yk_tracer_read(t, problems)) return false;
    if (t->repeats) return yk_map_refuse(problems, "some of its constraints repeat others", NULL);
    if (has_angle && yk_tracer_period(t) == 0)
        return yk_map_refuse(problems, "it does not repeat after any number of turns up to 720", NULL);
    return true;
}

YkRegions *yk_regions_begin(const YkState *start, size_t first, size_t second, double tolerance, YkProblems *problems)
{
    const size_t coordinate[2] = {first, second};
    if (!start || !is_mappable(start, coordinate, tolerance, problems)) return NULL;
    YkRegions *r = calloc(1, sizeof *r);
    bool has_room = r && begin(r, start, coordinate);
    if (has_room && read_pieces(r, problems)) return r;
    if (!has_room) yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory");
    yk_regions_free(r);
    return NULL;
}

static bool make(YkRegions *r, double tolerance)
{
    YkTracer *t = &r->field.tracer;
    if (!yk_field_begin(&r->field, r->start) || !yk_field_fill(&r->field, tolerance)) return false;
    if (!yk_regions_trace(r)) t->out_of_memory = true;
    if (t->out_of_memory || yk_pace_is_stopped(t->pace)) return false;
    find_start(r);
    tell(r);
    if (r->count > 0) qsort(r->parts, r->count, sizeof *r->parts, compare);
    return !t->out_of_memory;
}

static void tell_source(YkStatus status, YkProblems *problems)
{
    yk_problem(problems, YK_CODE_NO_MAP, (YkPlace){0}, "the tiles of the map did not come: %s", yk_status_name(status));
}

YkRegions *yk_regions_new(YkState *start, size_t first, size_t second, const YkRegionsOptions *options,
                          YkProblems *problems)
{
    YkRegionsOptions own = options ? *options : yk_default_regions_options();
    YkRegions *r = yk_regions_begin(start, first, second, own.tolerance, problems);
    if (!r) return NULL;
    YkField *f = &r->field;
    bool is_own = yk_state_begin(start);
    f->tracer.pace = start->pace;
    f->source = own.tiles.get ? &own.tiles : NULL;
    bool ok = make(r, own.tolerance);
    f->tracer.pace = NULL;
    f->source = NULL;
    bool is_stopped = yk_state_end(start, is_own, f->status) == YK_STOPPED, ran_out = f->tracer.out_of_memory;
    ran_out |= f->status == YK_NO_MEMORY;
    if (is_stopped)
        yk_problem_stopped(problems);
    else if (ran_out)
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory");
    else if (f->status < 0)
        tell_source(f->status, problems);
    if (ok && !is_stopped && !ran_out) return r;
    yk_regions_free(r);
    return NULL;
}

// --- answers

bool yk_regions_are_complete(const YkRegions *r)
{
    return r && r->is_complete;
}

const char *yk_regions_message(const YkRegions *r)
{
    return r ? r->message : "";
}

size_t yk_regions_coordinate(const YkRegions *r, int axis)
{
    return r && axis >= 0 && axis < 2 ? r->coordinate[axis] : YK_NOT_FOUND;
}

YkRange yk_regions_domain(const YkRegions *r, int axis)
{
    if (!r || axis < 0 || axis > 1) return (YkRange){NAN, NAN};
    return (YkRange){r->field.low[axis], r->field.high[axis]};
}

double yk_regions_tolerance(const YkRegions *r, int axis)
{
    return r && axis >= 0 && axis < 2 ? r->field.step[axis] : NAN;
}

double yk_regions_proved(const YkRegions *r)
{
    return r ? (double)r->field.proved / ((double)r->field.n * (double)r->field.n) : 0;
}

int yk_regions_at(const YkRegions *r, double first, double second, bool *proved)
{
    size_t cell;
    if (proved) *proved = false;
    if (!r || !find_cell(r, first, second, &cell)) return -1;
    if (proved) *proved = r->field.state[cell] & YK_CELL_PROVED;
    return r->field.count[cell];
}

size_t yk_regions_count(const YkRegions *r)
{
    return r ? r->count : 0;
}

YkRegion yk_regions_region(const YkRegions *r, size_t region)
{
    return r && region < r->count ? r->parts[region].region : (YkRegion){0};
}

const double *yk_regions_outline(const YkRegions *r, size_t region, size_t outline, size_t *count)
{
    if (count) *count = 0;
    if (!r || region >= r->count || outline >= r->parts[region].outline_count) return NULL;
    const YkBorder *o = &r->parts[region].outlines[outline];
    if (count) *count = o->count;
    return o->points;
}

YkRegionBound yk_regions_bound(const YkRegions *r, size_t region, size_t bound)
{
    if (!r || region >= r->count || bound >= r->parts[region].region.bounds) return (YkRegionBound){.block = -1};
    return r->parts[region].bounds[bound];
}
