// Many copies of an open tree, stepped together: what loads them, and blocks of lanes.
#include <stdlib.h>
#include <yoke/lanes.h>
#include "base/memory.h"
#include "equations/kernels_links.h"
#include "simulate/simulation.h"

struct YkLanes {
    YkArena *arena;
    YkTreeLinks links;
    YkLinkLanes kernel;
    YkLinkLoad *load; // [input]
    double *effort;   // [input]: the simulation's own
    double step;
    bool (*goes_on)(void *context, double time);
    void *context;
};

// The copies of a block that move.
typedef struct Movers {
    size_t copy[YK_TREE_LANES], count;
    double end[YK_TREE_LANES]; // times at the end of the span
} Movers;

// --- making

static bool is_constant(const YkLoadValue *value)
{
    return !value->formula && !value->law;
}

static bool item_fits(const YkLoadItem *item)
{
    bool is_known = item->kind == YK_LOAD_EFFORT || item->kind == YK_LOAD_VISCOUS || item->kind == YK_LOAD_ALONG;
    return is_known && is_constant(&item->value[0]);
}

static bool is_free_tree(const YkSimulation *sim)
{
    const YkMechanism *mech = sim->mech;
    const YkModel *model = mech->model;
    const YkLoads *loads = sim->dynamics->loads;
    bool fits = sim->options.integrator == YK_INTEGRATOR_RK4 && mech->loop_count == 0 && model->drive_count == 0 &&
                mech->input_count == mech->coordinate_count && mech->relation_count == 0 && model->cam_count == 0 &&
                loads->handle_count == 0 && !sim->sampling.control && sim->watch_count == 0;
    for (size_t k = 0; fits && k < loads->item_count; k++) fits = item_fits(&loads->items[k]);
    return fits;
}

static void load_input(YkLanes *lanes, const YkMechanism *mech, const YkLoadItem *item)
{
    int32_t coordinate = item->coordinate;
    if (coordinate == YK_NONE) coordinate = yk_tree_coordinate(mech, item->joint, item->is_distance);
    size_t input = (size_t)mech->coordinates[coordinate].input;
    YkLinkLoad *load = &lanes->load[input];
    if (item->kind == YK_LOAD_EFFORT) {
        lanes->effort[input] += item->value[0].constant;
        return;
    }
    load->damping += item->damping;
    if (item->kind == YK_LOAD_VISCOUS) return;
    load->stiffness += item->stiffness;
    load->constant += item->stiffness * item->length - item->value[0].constant;
}

static YkFew *rows_of(YkLanes *lanes)
{
    return yk_arena_alloc(lanes->arena, lanes->kernel.input_count + 1, sizeof(YkFew));
}

static void make_block(YkLanes *lanes)
{
    lanes->kernel.block = (YkLinkBlock){.q = rows_of(lanes),
                                        .v = rows_of(lanes),
                                        .effort = rows_of(lanes),
                                        .at_q = rows_of(lanes),
                                        .at_v = rows_of(lanes),
                                        .a = rows_of(lanes),
                                        .torque = rows_of(lanes),
                                        .sum_q = rows_of(lanes),
                                        .sum_v = rows_of(lanes)};
}

static bool build(YkLanes *lanes, const YkSimulation *sim)
{
    const YkMechanism *mech = sim->mech;
    size_t inputs = mech->input_count;
    if (!lanes->arena || !yk_tree_links_build(&lanes->links, mech, lanes->arena)) return false;
    size_t count = lanes->links.count;
    lanes->load = YK_NEW(lanes->arena, YkLinkLoad, inputs + 1);
    lanes->effort = YK_NEW(lanes->arena, double, inputs + 1);
    lanes->kernel = (YkLinkLanes){.links = &lanes->links, .load = lanes->load, .input_count = inputs};
    lanes->kernel.found = yk_arena_alloc(lanes->arena, count, sizeof(YkLinkFound));
    make_block(lanes);
    if (yk_arena_failed(lanes->arena)) return false;
    for (size_t k = 0; k < sim->dynamics->loads->item_count; k++)
        load_input(lanes, mech, &sim->dynamics->loads->items[k]);
    yk_link_lanes_start(&lanes->kernel, mech->model->gravity);
    return true;
}

YkLanes *yk_lanes_new(YkSimulation *sim, bool *fits)
{
    *fits = is_free_tree(sim);
    YkLanes *lanes = *fits ? malloc(sizeof *lanes) : NULL;
    if (!lanes) return NULL;
    *lanes = (YkLanes){.arena = yk_arena_new(),
                       .step = sim->options.step,
                       .goes_on = sim->options.goes_on,
                       .context = sim->options.context};
    if (build(lanes, sim)) return lanes;
    yk_lanes_free(lanes);
    return NULL;
}

void yk_lanes_free(YkLanes *lanes)
{
    if (!lanes) return;
    yk_arena_free(lanes->arena);
    free(lanes);
}

size_t yk_lanes_input_count(const YkLanes *lanes)
{
    return lanes->kernel.input_count;
}

// --- stepping

static bool has_good_efforts(const YkLanes *lanes, const YkLanesCase *asked, size_t copy)
{
    for (size_t i = 0; asked->efforts && i < lanes->kernel.input_count; i++)
        if (asked->efforts[i] && !isfinite(asked->efforts[i][copy])) return false;
    return true;
}

static Movers find_movers(const YkLanes *lanes, const YkLanesCase *asked, size_t from, size_t to, double span)
{
    Movers movers = {.count = 0};
    for (size_t copy = from; copy < to; copy++) {
        if (asked->status[copy] < 0) continue;
        bool is_good = has_good_efforts(lanes, asked, copy);
        asked->status[copy] = is_good ? YK_OK : YK_BAD_ARGUMENT;
        if (!is_good) continue;
        movers.copy[movers.count] = copy;
        movers.end[movers.count++] = asked->times[copy] + span;
    }
    return movers;
}

static void gather(YkLanes *lanes, const YkLanesCase *asked, const Movers *movers)
{
    YkLinkBlock *b = &lanes->kernel.block;
    for (size_t i = 0; i < lanes->kernel.input_count; i++) {
        const double *q = asked->states[2 * i], *v = asked->states[2 * i + 1];
        const double *effort = asked->efforts ? asked->efforts[i] : NULL;
        for (size_t k = 0; k < movers->count; k++) {
            size_t copy = movers->copy[k];
            b->q[i][k] = q[copy];
            b->v[i][k] = v[copy];
            b->effort[i][k] = effort ? effort[copy] : lanes->effort[i];
        }
    }
}

static void scatter(const YkLanes *lanes, const YkLanesCase *asked, const Movers *movers)
{
    const YkLinkBlock *b = &lanes->kernel.block;
    for (size_t i = 0; i < lanes->kernel.input_count; i++)
        for (size_t k = 0; k < movers->count; k++) {
            if (b->ok[k] == 0) continue;
            asked->states[2 * i][movers->copy[k]] = b->q[i][k];
            asked->states[2 * i + 1][movers->copy[k]] = b->v[i][k];
        }
}

// Sets the times of those that made the step, and leaves the others behind.
static void keep_good(const YkLanes *lanes, const YkLanesCase *asked, Movers *movers, double left)
{
    size_t kept = 0;
    for (size_t k = 0; k < movers->count; k++) {
        size_t copy = movers->copy[k];
        bool is_good = lanes->kernel.block.ok[k] != 0;
        if (!is_good) asked->status[copy] = YK_NOT_CONVERGED;
        if (!is_good) continue;
        asked->times[copy] = movers->end[k] - left;
        movers->copy[kept] = copy;
        movers->end[kept++] = movers->end[k];
    }
    movers->count = kept;
}

// Steps a block over the span. A remainder of rounding size belongs to the step before, as in num/ode.
static YkStatus step_block(YkLanes *lanes, const YkLanesCase *asked, Movers *movers, double span)
{
    for (double even = 0;; even++) {
        double left = span - even * lanes->step;
        bool is_last = left <= lanes->step * (1 + 1e-9);
        if (movers->count == 0 || span == 0) return YK_OK;
        gather(lanes, asked, movers);
        yk_lanes_links_step(&lanes->kernel, is_last ? left : lanes->step, movers->count);
        scatter(lanes, asked, movers);
        keep_good(lanes, asked, movers, is_last ? 0 : left - lanes->step);
        bool goes_on =
            movers->count == 0 || !lanes->goes_on || lanes->goes_on(lanes->context, asked->times[movers->copy[0]]);
        if (!goes_on) return YK_STOPPED;
        if (is_last) return YK_OK;
    }
}

YkStatus yk_lanes_step(YkLanes *lanes, const YkLanesCase *asked, size_t from, size_t to, double span)
{
    YkStatus worst = YK_OK;
    if (!(span >= 0 && span <= 1e14 * lanes->step)) return YK_BAD_ARGUMENT;
    for (size_t at = from; at < to; at += YK_TREE_LANES) {
        size_t end = to - at < YK_TREE_LANES ? to : at + YK_TREE_LANES;
        Movers movers = find_movers(lanes, asked, at, end, span);
        YkStatus status = step_block(lanes, asked, &movers, span);
        for (size_t copy = at; copy < end; copy++)
            if (asked->status[copy] < worst) worst = asked->status[copy];
        if (status == YK_STOPPED) return status;
    }
    return worst;
}
