// Visits every configuration of a machine, and finds whether there are others.
#include <yoke/configurations.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"
#include "configurations/continuum.h"
#include "configurations/eliminate.h"
#include "configurations/exclude.h"
#include "configurations/group.h"
#include "configurations/namesakes.h"
#include "solve/assemble.h"
#include "solve/gap.h"
#include "solve/state.h"

enum { BOXES_MAX = 2000000 }; // of all exclusions of a call

// The group of one block: the data kept for it, its solutions at this pose, and room for the options of its level.
typedef struct Member {
    YkGroupKept kept;
    YkGroupSolutions solutions;
    YkExcluded excluded;
    double *options, *costs;
    uint16_t *order;
    size_t capacity;
} Member;

struct YkConfigurations {
    const YkMechanism *mech;
    Member *members; // [block]
    YkNamesakes namesakes;
    YkContinua continua;
    bool has_room; // for continua
    // of the present call:
    YkState *state;
    YkConfigurationsOptions options;
    YkConfigurationsReport report;
    size_t lacking; // solutions that the group of the report lacks
    bool out_of_memory, is_running, is_cut_short, is_left;
    bool is_excluded; // some group was
    bool has_left,
        has_unsettled; // some group is excluded but beside singular poses; some is neither counted nor excluded
    size_t boxes;
    bool is_in_doubt; // some group is not known to be complete
    YkContinuum here; // of the configuration that is shown
    YkPace enough;
    bool (*visit)(void *, YkState *);
    void *context;
};

YkConfigurationsOptions yk_default_configurations_options(void)
{
    return (YkConfigurationsOptions){.in_search_order = false};
}

const char *yk_complete_reason_name(YkCompleteReason reason)
{
    static const char *const names[] = {"none", "closed form", "counted", "excluded"};
    return (unsigned)reason < sizeof names / sizeof *names ? names[reason] : "?";
}

YkConfigurations *yk_configurations_new(const YkMechanism *mech)
{
    YkConfigurations *all = mech ? calloc(1, sizeof *all) : NULL;
    if (!all) return NULL;
    all->mech = mech;
    all->members = calloc(mech->block_count + 1, sizeof *all->members);
    if (!all->members) {
        free(all);
        return NULL;
    }
    for (size_t b = 0; b < mech->block_count; b++) {
        YkGroupKept *kept = &all->members[b].kept;
        if (mech->blocks[b].kind == YK_BLOCK_GROUP) kept->outside = yk_shape_read(&kept->shape, mech, b);
    }
    return all;
}

void yk_configurations_free(YkConfigurations *all)
{
    if (!all) return;
    for (size_t b = 0; b < all->mech->block_count; b++) {
        Member *m = &all->members[b];
        yk_group_kept_end(&m->kept);
        yk_group_solutions_end(&m->solutions);
        yk_excluded_end(&m->excluded);
        free(m->options);
        free(m->costs);
        free(m->order);
    }
    yk_namesakes_end(&all->namesakes);
    yk_continua_end(&all->continua);
    free(all->members);
    free(all);
}

// --- the options of a group

static bool make_room(Member *m, size_t count, size_t columns)
{
    if (count <= m->capacity) return true;
    size_t capacity = count + 32;
    double *options = malloc(capacity * columns * sizeof *options), *costs = malloc(capacity * sizeof *costs);
    uint16_t *order = malloc(capacity * sizeof *order);
    if (!options || !costs || !order) {
        free(options);
        free(costs);
        free(order);
        return false;
    }
    if (m->capacity > 0) memcpy(options, m->options, m->capacity * columns * sizeof *options);
    free(m->options);
    free(m->costs);
    free(m->order);
    m->options = options;
    m->costs = costs;
    m->order = order;
    m->capacity = capacity;
    return true;
}

static bool is_listed(const YkConfigurations *all, const YkBlock *block, const double *options, size_t count,
                      const double *x)
{
    const double same = 1e-7;
    size_t n = block->column_count;
    for (size_t s = 0; s < count; s++)
        if (yk_group_gap(all->mech, block, x, options + s * n) < same) return true;
    return false;
}

// Adds options that are not yet listed; proved solutions that a search found are the same. Returns the number listed.
static size_t add_options(YkConfigurations *all, Member *m, const YkBlock *block, size_t count, const double *from,
                          size_t from_count)
{
    size_t n = block->column_count;
    if (!make_room(m, count + from_count, n)) {
        all->out_of_memory = true;
        return count;
    }
    size_t before = count;
    for (size_t s = 0; s < from_count; s++)
        if (!is_listed(all, block, m->options, before, from + s * n))
            memcpy(m->options + count++ * n, from + s * n, n * sizeof *from);
    return count;
}

// Keeps one of several poses that a search found around one dead point, to half the digits. Those that are proved are
// none. Returns how many are left.
static size_t drop_twins(const YkConfigurations *all, const Member *m, const YkBlock *block, double *found,
                         size_t count)
{
    const double near = 1e-5;
    size_t n = block->column_count, left = 0;
    for (size_t s = 0; s < count; s++) {
        const double *x = found + s * n;
        bool is_twin = false;
        for (size_t k = 0; k < left && !is_twin; k++) is_twin = yk_group_gap(all->mech, block, x, found + k * n) < near;
        if (is_twin && !is_listed(all, block, m->solutions.real, m->solutions.real_count, x)) continue;
        memmove(found + left++ * n, x, n * sizeof *x);
    }
    return left;
}

static const char *reason_outside(YkOutside outside)
{
    switch (outside) {
    case YK_OUTSIDE_RELATIONS:
        return "gears, belts, cams or laws are solved together with its loops";
    case YK_OUTSIDE_REDUNDANT:
        return "it has not as many equations as unknowns";
    case YK_OUTSIDE_LARGE:
        return "it has more than seven loops";
    case YK_OUTSIDE_LINES:
        return "a distance runs along more than one line";
    default:
        return "elimination takes groups of up to four loops";
    }
}

// Notes a group at a pose; the report keeps the one that lacks most, or else the one with most solutions.
static void note(YkConfigurations *all, size_t index, const Member *m, YkGroupStatus status)
{
    YkConfigurationsReport *r = &all->report;
    const YkGroupSolutions *s = &m->solutions;
    size_t lacking = s->is_complete                  ? 0
                     : status == YK_GROUP_OUTSIDE    ? SIZE_MAX
                     : !s->is_counted                ? SIZE_MAX - 1
                     : s->expected > s->proved_count ? s->expected - s->proved_count
                                                     : 1;
    bool is_first = r->block<0, is_worse = lacking> all->lacking;
    if (!is_first && !is_worse && !(lacking == all->lacking && s->proved_count > r->proved)) return;
    all->lacking = lacking;
    r->block = (int)index;
    r->proved = status == YK_GROUP_OUTSIDE ? 0 : s->proved_count;
    r->expected = s->is_counted ? s->expected : 0;
}

// Finds all configurations of a group by exclusion. Returns false if that does not succeed. Where it succeeds but for
// boxes beside singular poses, these are counted, and the group is not complete.
static bool exclude(YkConfigurations *all, const YkRun *run, size_t index, YkPace *pace)
{
    YkGeared geared;
    YkExcluded *out = &all->members[index].excluded;
    YkOutside outside = all->members[index].kept.outside;
    bool can = outside == YK_OUTSIDE_NOT || outside == YK_OUTSIDE_RELATIONS || outside == YK_OUTSIDE_REDUNDANT;
    out->count = out->left = 0;
    out->is_complete = false;
    if (!can || all->boxes > BOXES_MAX || !yk_geared_read(&geared, run, index)) return false;
    all->out_of_memory |= !yk_exclude(&geared, pace, out);
    all->boxes += out->boxes;
    all->is_cut_short |= yk_pace_is_stopped(pace);
    if (!out->is_complete) out->count = 0;
    return !all->out_of_memory && out->is_complete;
}

static size_t list(void *context, const YkRun *run, size_t index, YkOptionRoom *room)
{
    YkConfigurations *all = context;
    Member *m = &all->members[index];
    const YkBlock *block = &all->mech->blocks[index];
    size_t count = 0;
    YkPace *pace = all->enough.progress.goes_on ? &all->enough : all->state->pace;
    if (pace == &all->enough && yk_pace_is_stopped(all->state->pace)) return 0;
    m->kept.solver = all->options.solver;
    bool is_large = m->kept.solver == YK_SOLVER_ELIMINATION && m->kept.shape.loops > YK_ELIMINATION_LOOPS_MAX;
    if (is_large) m->solutions.has_pose = m->solutions.is_complete = false;
    YkGroupStatus status = is_large ? YK_GROUP_OUTSIDE : yk_group_solve_all(&m->kept, run, index, pace, &m->solutions);
    all->is_cut_short |= status == YK_GROUP_STOPPED;
    all->out_of_memory |= status == YK_GROUP_NO_MEMORY;
    bool is_counted = status == YK_GROUP_SOLVED && m->solutions.is_complete, is_short = yk_pace_is_stopped(pace);
    bool is_settled = !is_counted && !is_large && !is_short && exclude(all, run, index, pace);
    bool is_excluded = is_settled && m->excluded.left == 0;
    if (is_settled && !is_excluded) all->has_left = true;
    if (!is_counted && !is_settled) all->has_unsettled = true;
    all->is_excluded |= is_excluded;
    if (is_excluded && all->report.block < 0) all->report.block = (int)index;
    if (!is_excluded) note(all, index, m, status);
    bool is_whole = is_excluded || is_counted;
    all->is_in_doubt |= !is_whole;
    bool is_searched = all->options.in_search_order || !is_whole;
    if ((status == YK_GROUP_OUTSIDE && !is_excluded) || (is_searched && !yk_pace_is_stopped(pace))) {
        size_t found = yk_group_search(run, index);
        if (status != YK_GROUP_OUTSIDE) found = drop_twins(all, m, block, run->groups->solutions, found);
        count = add_options(all, m, block, 0, run->groups->solutions, found);
    }
    if (is_settled) count = add_options(all, m, block, count, m->excluded.poses, m->excluded.count);
    if (!is_excluded && status != YK_GROUP_OUTSIDE)
        count = add_options(all, m, block, count, m->solutions.real, m->solutions.real_count);
    *room = (YkOptionRoom){m->options, m->costs, m->order};
    return count;
}

// --- the whole machine

// Looks for a continuum at the pose that is shown. Returns false if another pose of it has been shown.
static bool is_of_its_own(YkConfigurations *all, const YkState *state)
{
    YkConfigurationsReport *r = &all->report;
    bool is_new = true;
    all->here = (YkContinuum){0};
    if (!all->is_in_doubt && !(state->space.margin[0] <= YK_SINGULAR_MARGIN)) return true;
    if (!all->has_room) all->has_room = yk_continua_start(&all->continua, all->mech);
    all->out_of_memory |= !all->has_room || !yk_continuum_at(&all->continua, state, &all->here, &is_new);
    if (all->here.dimension == 0 || !is_new) return is_new;
    r->continua++;
    if (all->here.dimension > r->continuum.dimension) r->continuum = all->here;
    return true;
}

const YkContinuum *yk_configurations_continuum(const YkConfigurations *all)
{
    return all && all->is_running && all->here.dimension > 0 ? &all->here : NULL;
}

static bool show(void *context, YkState *state)
{
    YkConfigurations *all = context;
    if (!is_of_its_own(all, state)) return true;
    // Groups ask whether to go on while they are solved; for dyads it is asked here.
    bool goes_on = !all->enough.progress.goes_on || yk_pace_spend(&all->enough, 100 * all->mech->step_count);
    if (!goes_on && all->report.block < 0) {
        all->is_cut_short = true;
        return false;
    }
    if (++all->report.count > YK_CONFIGURATIONS_SHOWN) return true;
    if (!all->visit || all->visit(all->context, state)) return true;
    all->is_left = true;
    return false;
}

// Says which configurations are continua, and what of that is proved.
static void tell_continua(const YkConfigurationsReport *r, bool has_settled, YkText *text)
{
    const YkContinuum *c = &r->continuum;
    if (r->continua == 0 && has_settled) yk_text_puts(text, "a dyad turns freely, and was taken at one angle; ");
    if (r->continua == 0) return;
    if (r->continua == 1) yk_text_format(text, "one of them stands for a continuum of dimension %z", c->dimension);
    if (r->continua > 1)
        yk_text_format(text, "%z of them stand for continua (largest dimension: %z)", r->continua, c->dimension);
    bool is_bounded = c->at_most == c->dimension;
    if (r->continua == 1 && is_bounded && c->at_least == c->dimension) yk_text_puts(text, ", proved");
    if (r->continua == 1 && is_bounded && c->at_least < c->dimension)
        yk_text_puts(text, " (no more is proved, as much is measured)");
    yk_text_puts(text, "; ");
}

static void tell(YkConfigurations *all, bool whole, const YkLister *lister)
{
    YkConfigurationsReport *r = &all->report;
    YkText text = {0};
    size_t lost = lister->lost;
    bool has_continua = r->continua > 0 || lister->settled > 0;
    r->complete = whole && all->lacking == 0 && lost == 0 && !all->is_cut_short && !has_continua;
    r->reason = !r->complete       ? YK_INCOMPLETE
                : all->is_excluded ? YK_COMPLETE_BY_EXCLUSION
                : r->block < 0     ? YK_COMPLETE_BY_CLOSED_FORM
                                   : YK_COMPLETE_BY_COUNT;
    const char *label = r->block < 0 ? "" : all->mech->blocks[r->block].label;
    tell_continua(r, lister->settled > 0, &text);
    if (r->block < 0 && whole && !all->is_cut_short)
        yk_text_puts(&text, "every dyad is solved in closed form");
    else if (r->complete && all->is_excluded)
        yk_text_format(&text, "all other angles of the group of joint `%s` are proved not to close it%s", label,
                       r->count == 0 ? ", and none closes the machine" : "");
    else if (r->complete)
        yk_text_format(&text, "all %z complex solutions of the group of joint `%s` are proved%s", r->expected, label,
                       r->count == 0 ? ", and none closes the machine" : "");
    else if (!whole || (all->is_cut_short && r->block < 0))
        yk_text_puts(&text, "not all combinations of branches were visited");
    else if (all->is_cut_short)
        yk_text_format(
            &text, "stopped before all paths were followed; %z complex solutions of the group of joint `%s` are proved",
            r->proved, label);
    else if (all->has_left && !all->has_unsettled)
        yk_text_format(&text,
                       "all other angles of the group of joint `%s` are proved not to close it, but within 1.2 deg of "
                       "singular poses",
                       label);
    else if (all->lacking == SIZE_MAX)
        yk_text_format(&text, "the group of joint `%s` was searched, not enumerated: %s", label,
                       reason_outside(all->members[r->block].kept.outside));
    else if (all->lacking == SIZE_MAX - 1)
        yk_text_format(&text,
                       "the group of joint `%s` was enumerated, but not counted: %z complex solutions are proved",
                       label, r->proved);
    else if (all->lacking == 0 && lost == 0)
        yk_text_format(&text, "all solutions of the group of joint `%s` are proved", label);
    else if (all->lacking == 0)
        yk_text_format(&text, "%z proved solutions do not close in the machine's own steps", lost);
    else
        yk_text_format(&text, "%z of %z complex solutions of the group of joint `%s` are proved", r->proved,
                       r->expected, label);
    all->out_of_memory |= text.failed;
    yk_text_move(&text, r->message, sizeof r->message);
}

YkStatus yk_configurations_each(YkConfigurations *all, YkState *state, const YkConfigurationsOptions *options,
                                bool (*visit)(void *, YkState *), void *context, YkConfigurationsReport *report)
{
    if (report) *report = (YkConfigurationsReport){.block = -1};
    if (!all || !state || state->mech != all->mech || all->is_running) return YK_BAD_ARGUMENT;
    if (options && options->with_names && !yk_namesakes_are_ready(&all->namesakes, state)) {
        YkStatus status = yk_namesakes_prepare(&all->namesakes, all, state, options);
        if (status < 0) return status;
    }
    YkLister lister = {list, all, 0, 0};
    bool whole = false;
    all->state = state;
    all->options = options ? *options : yk_default_configurations_options();
    all->report = (YkConfigurationsReport){.block = -1};
    all->lacking = 0;
    all->out_of_memory = all->is_cut_short = all->is_left = all->is_excluded = all->is_in_doubt = false;
    all->has_left = all->has_unsettled = false;
    all->boxes = 0;
    all->continua.kept = 0;
    all->is_running = true;
    yk_pace_begin(&all->enough, all->options.enough);
    all->visit = visit;
    all->context = context;
    YkStatus status = yk_search_each(state, &lister, show, all, &whole);
    all->is_running = false;
    tell(all, whole && !all->is_left && status != YK_STOPPED && !all->out_of_memory, &lister);
    if (all->out_of_memory && status != YK_STOPPED) {
        status = YK_NO_MEMORY;
        all->report.complete = false;
        all->report.reason = YK_INCOMPLETE;
    }
    if (report) *report = all->report;
    return status;
}

YkStatus yk_configurations_name(YkConfigurations *all, const YkState *state, const YkConfigurationsOptions *options,
                                const char **name)
{
    if (name) *name = "";
    if (!name || !all || !state || state->mech != all->mech || !state->has_pose) return YK_BAD_ARGUMENT;
    bool is_ready = yk_namesakes_are_ready(&all->namesakes, state);
    if (!is_ready && all->is_running) return YK_BAD_ARGUMENT;
    YkStatus status = is_ready ? YK_OK : yk_namesakes_prepare(&all->namesakes, all, state, options);
    if (status >= 0) status = yk_namesakes_write(&all->namesakes, state);
    if (status >= 0) *name = yk_text_get(&all->namesakes.name);
    return status;
}
