// Lists the uses of laws that a pose can leave, and finds those that it has left.
#include "dynamics/law_uses.h"
#include <stdlib.h>
#include <string.h>
#include "dynamics/dynamics.h"

#define ROUNDING 1e-9 // over the law's range

// --- the list

static void add(YkLawWatch *watch, int32_t law, YkLawUse use)
{
    if (law == YK_NONE) return;
    const YkModelLaw *of = &watch->model->laws[law];
    YkLawRange range = yk_law_range(of->law);
    if (range.period > 0) return;
    use.law = of->law;
    use.told.law = of->name;
    use.told.from = range.from;
    use.told.to = range.to;
    watch->uses[watch->count++] = use;
}

static void add_drives(YkLawWatch *watch)
{
    const YkModel *model = watch->model;
    for (size_t k = 0; k < model->drive_count; k++) {
        const YkDrive *d = &model->drives[k];
        YkLawLeft told = {.user = YK_LAW_USER_DRIVE, .name = model->coordinates[d->coordinate].name, .place = d->place};
        add(watch, d->law, (YkLawUse){.told = told, .drive = (int32_t)k, .follow = YK_NONE});
    }
    for (size_t k = 0; k < model->follow_count; k++) {
        const YkFollow *f = &model->follows[k];
        YkLawLeft told = {.user = YK_LAW_USER_DRIVE, .name = model->coordinates[f->coordinate].name, .place = f->place};
        add(watch, f->law, (YkLawUse){.told = told, .drive = YK_NONE, .follow = (int32_t)k});
    }
}

// The items of the loads begin with the efforts, forces and springs of the model.
static void add_loads(YkLawWatch *watch)
{
    const YkModel *model = watch->model;
    size_t item = 0;
    for (size_t k = 0; k < model->effort_count; k++, item++) {
        const YkEffort *e = &model->efforts[k];
        YkLawLeft told = {
            .user = YK_LAW_USER_EFFORT, .name = model->coordinates[e->coordinate].name, .place = e->place};
        add(watch, e->strength.law, (YkLawUse){.told = told, .drive = YK_NONE, .follow = YK_NONE, .item = item});
    }
    for (size_t k = 0; k < model->force_count; k++, item++) {
        const YkForce *f = &model->forces[k];
        const YkStrength *const parts[] = {&f->x, &f->y, &f->moment};
        YkLawLeft told = {.user = YK_LAW_USER_FORCE, .name = f->name, .place = f->place};
        for (size_t part = 0; part < 3; part++)
            if (parts[part]->expr)
                add(watch, parts[part]->law,
                    (YkLawUse){.told = told, .drive = YK_NONE, .follow = YK_NONE, .item = item, .part = part});
    }
    for (size_t k = 0; k < model->spring_count; k++, item++) {
        const YkSpring *s = &model->springs[k];
        YkLawLeft told = {.user = YK_LAW_USER_SPRING, .name = s->name, .place = s->place};
        if (s->force.expr)
            add(watch, s->force.law, (YkLawUse){.told = told, .drive = YK_NONE, .follow = YK_NONE, .item = item});
    }
}

YkLawWatch *yk_law_watch_new(const YkModel *model)
{
    if (!model) return NULL;
    size_t most =
        model->drive_count + model->follow_count + model->effort_count + 3 * model->force_count + model->spring_count;
    YkLawWatch *watch = calloc(1, sizeof *watch);
    if (watch) watch->uses = calloc(most + 1, sizeof *watch->uses);
    if (!watch || !watch->uses) {
        free(watch);
        return NULL;
    }
    watch->model = model;
    add_drives(watch);
    add_loads(watch);
    return watch;
}

void yk_law_watch_free(YkLawWatch *watch)
{
    if (!watch) return;
    free(watch->uses);
    free(watch);
}

// --- a pose

// Returns the argument of a drive in time, if the input has the drive's value: otherwise something else moves it.
static double drive_argument(const YkState *s, size_t drive)
{
    const YkModel *model = s->mech->model;
    const YkDrive *d = &model->drives[drive];
    const YkCoordinate *c = &model->coordinates[d->coordinate];
    int32_t q = yk_tree_coordinate(s->mech, c->joint, c->is_distance);
    int32_t input = q == YK_NONE ? YK_NONE : s->mech->coordinates[q].input;
    YkJet value, argument;
    if (input == YK_NONE || s->is_held[3 * input]) return NAN;
    if (yk_model_drive(model, drive, s->time, &value, NULL) != YK_OK || value.d[0] != s->input[3 * input]) return NAN;
    return yk_model_eval(model, d->expr, s->time, &argument, NULL) == YK_OK ? argument.d[0] : NAN;
}

// Returns the argument of a relation's law, from the angles of bodies and the distances that stand.
static double follow_argument(const YkState *s, int32_t follow)
{
    const YkMechanism *mech = s->mech;
    for (size_t k = 0; k < mech->relation_count; k++) {
        const YkRelation *r = &mech->relations[k];
        if (r->kind != YK_RELATION_LAW || r->index != follow) continue;
        double sum = r->argument_constant;
        for (uint32_t i = r->first_argument; i < r->first_argument + r->argument_count; i++) {
            YkRelationTerm term = mech->relation_terms[i];
            int32_t body = term.is_distance ? 0 : mech->orientation_body[term.index];
            sum += term.factor * (term.is_distance ? yk_space_slide(&s->space, term.index).d[0]
                                                   : yk_state_body(s, (size_t)body).position - mech->bodies[body].turn);
        }
        return sum;
    }
    return NAN;
}

double yk_law_use_argument(const YkLawUse *use, const YkState *state, YkLoads *loads)
{
    if (use->drive != YK_NONE) return drive_argument(state, (size_t)use->drive);
    if (use->follow != YK_NONE) return follow_argument(state, use->follow);
    if (!loads || !state->has_rates) return NAN;
    return yk_loads_law_argument(loads, state, &state->space, use->item, use->part);
}

double yk_law_use_excess(const YkLawUse *use, double argument)
{
    double from = use->told.from, to = use->told.to;
    if (isnan(argument)) return NAN;
    return fmax(from - argument, argument - to) - ROUNDING * (to - from);
}

// Remembers that a use was found outside at a pose.
static void note_use(YkLawUse *use, double argument, double at)
{
    if (use->told.poses++ > 0) return;
    double d[YK_LAW_ORDER + 1];
    yk_law_eval(use->law, argument, d);
    use->told.argument = argument;
    use->told.value = d[0];
    use->told.at = at;
}

size_t yk_law_watch_look(YkLawWatch *watch, const YkState *state, YkDynamics *dynamics, double at)
{
    size_t outside = 0;
    if (!watch || !state || !state->has_pose) return 0;
    for (size_t k = 0; k < watch->count; k++) {
        double argument = yk_law_use_argument(&watch->uses[k], state, dynamics ? dynamics->loads : NULL);
        if (!(yk_law_use_excess(&watch->uses[k], argument) > 0)) continue;
        note_use(&watch->uses[k], argument, at);
        outside++;
    }
    return outside;
}

void yk_law_watch_note(YkLawWatch *watch, const char *name, double argument, double at)
{
    for (size_t k = 0; watch && name && k < watch->count; k++) {
        YkLawUse *use = &watch->uses[k];
        bool is_at_end = !(argument > use->told.from && argument < use->told.to);
        if (use->told.poses > 0 || !is_at_end || strcmp(use->told.name, name) != 0) continue;
        note_use(use, argument, at);
        return;
    }
}

// --- the answer

size_t yk_law_watch_count(const YkLawWatch *watch)
{
    size_t count = 0;
    for (size_t k = 0; watch && k < watch->count; k++) count += watch->uses[k].told.poses > 0;
    return count;
}

YkLawLeft yk_law_watch_get(const YkLawWatch *watch, size_t index)
{
    for (size_t k = 0; watch && k < watch->count; k++)
        if (watch->uses[k].told.poses > 0 && index-- == 0) return watch->uses[k].told;
    return (YkLawLeft){0};
}
