// The gear train of a derivation: names of speeds and teeth, and the inputs in which all speeds are expressed.
#include "derive/gears/gears.h"
#include <string.h>
#include "base/problems.h"
#include "derive/inside.h"

// --- Names

// Returns the name behind "theta" of the coordinate that is the body's angle to the ground: omega1 belongs to theta1.
static const char *number_of(const YkDerivation *d, size_t body)
{
    const YkDeriveBody *b = &d->bodies[body];
    int32_t c = b->joint == YK_NONE ? YK_NONE : d->joint_angle[b->joint];
    if (c == YK_NONE || d->coordinates[c].position != b->angle) return NULL;
    const char *name = d->coordinates[c].name;
    return strncmp(name, "theta", 5) == 0 ? name + 5 : NULL;
}

static bool enter_speed(YkDerivation *d, size_t body)
{
    YkText name = {0};
    const char *number = number_of(d, body);
    if (number) yk_text_format(&name, "omega%s", number);
    if (!number || yk_derive_find(d, yk_text_get(&name)) >= 0) { // taken by a parameter of the file
        yk_text_clear(&name);
        yk_text_format(&name, "omega_%s", d->model->bodies[body].name);
    }
    d->failed |= name.failed;
    d->speeds[body] = yk_derive_symbol(d, yk_text_get(&name), YK_RING_RATE);
    yk_text_free(&name);
    return yk_derive_define(d, d->speeds[body], d->bodies[body].spin);
}

static bool is_carrier(const YkTrainNet *net, size_t body)
{
    for (int32_t m = 0; m < net->mesh_count; m++)
        if (net->rows[m].terms[2].column == net->column_of[body] && net->rows[m].kind != YK_ROW_RACK) return true;
    return false;
}

// Enters wheels first, then their carriers, so that differences print as omega_planet - omegaC. Bodies that never
// turn against each other share a name.
static bool enter_speeds(YkDerivation *d, const YkTrainNet *net)
{
    size_t count = d->model->body_count;
    d->speeds = YK_NEW(d->arena, int32_t, count);
    for (size_t b = 0; d->speeds && b < count; b++) d->speeds[b] = -1;
    for (int pass = 0; pass < 2; pass++) {
        for (size_t b = 1; d->speeds && b < count; b++) {
            if (net->column_of[b] < 0 || d->bodies[b].rate < 0 || is_carrier(net, b) != (pass == 1)) continue;
            for (size_t k = 1; k < count && d->speeds[b] < 0; k++)
                if (d->bodies[k].rate == d->bodies[b].rate) d->speeds[b] = d->speeds[k];
            if (d->speeds[b] < 0 && !enter_speed(d, b)) return false;
        }
    }
    return d->speeds != NULL;
}

static bool enter_teeth(YkDerivation *d, YkDeriveTrain *train)
{
    const YkTrainNet *net = &train->train->net;
    train->symbols = YK_NEW(d->arena, const YkPoisson *, (size_t)net->symbol_count + 1);
    for (int32_t s = 0; train->symbols && s < net->symbol_count; s++) {
        const YkTrainSymbol *of = &net->symbols[s];
        int32_t symbol =
            yk_names_find(&d->model->parameter_names, of->name) != YK_NONE ? yk_derive_find(d, of->name) : -1;
        if (symbol < 0) {
            symbol = yk_derive_symbol(d, of->name, YK_RING_CONSTANT);
            if (!yk_derive_define(d, symbol, yk_derive_expression(d, of->expr))) return false;
        }
        train->symbols[s] = yk_ring_of(d->ring, symbol);
    }
    return train->symbols != NULL;
}

// --- Inputs

static const YkPoisson *rate_of(YkDerivation *d, const YkDeriveCoordinate *c)
{
    const int32_t *body = d->model->joints[c->joint].body;
    if (!c->is_distance && body[0] == 0 && d->bodies[body[1]].rate == c->rate)
        return yk_derive_speed(d, (size_t)body[1]);
    return yk_ring_of(d->ring, c->rate);
}

// Makes the coordinate an input if the speeds do not follow without it. Returns false when out of memory or
// numbers.
static bool consider(YkDerivation *d, YkDeriveTrain *train, size_t coordinate)
{
    const YkDeriveCoordinate *c = &d->coordinates[coordinate];
    const YkTrainNet *net = &train->train->net;
    int32_t rank = train->motion.system.rank;
    if (rank == net->columns || !yk_train_has_joint(net, c->joint, c->is_distance)) return true;
    train->inputs[train->input_count] = (YkTrainDrive){.coordinate = YK_NONE,
                                                       .is_joint = true,
                                                       .joint = c->joint,
                                                       .shown = {.name = c->name, .is_distance = c->is_distance}};
    YkTrainCase next;
    bool good = yk_train_case_solve(&next, net, NULL, train->inputs, train->input_count + 1, d->arena);
    bool is_new = good && next.system.rank > rank;
    yk_train_case_free(is_new ? &train->motion : &next);
    if (!is_new) return good;
    train->motion = next;
    train->input_rates[train->input_count++] = rate_of(d, c);
    return true;
}

static bool choose_inputs(YkDerivation *d, YkDeriveTrain *train)
{
    train->inputs = YK_NEW(d->arena, YkTrainDrive, d->tree_count + 1);
    train->input_rates = YK_NEW(d->arena, const YkPoisson *, d->tree_count + 1);
    if (!train->inputs || !train->input_rates ||
        !yk_train_case_solve(&train->motion, &train->train->net, NULL, NULL, 0, d->arena))
        return false;
    for (int pass = 0; pass < 2; pass++)
        for (size_t k = 0; k < d->tree_count; k++)
            if (d->coordinates[k].is_input == (pass == 0) && !consider(d, train, k)) return false;
    return true;
}

// --- The whole

const YkDeriveTrain *yk_derive_train(YkDerivation *d)
{
    const YkModel *model = d->model;
    if (d->train || model->gear_count + model->belt_count + model->rack_count == 0) return d->train;
    YkProblems *said = yk_problems_new(); // problems of the train are reported elsewhere
    YkTrain *train = said ? yk_train_new(model, NULL, said) : NULL;
    d->failed |= !said || yk_problems_ran_out(said);
    yk_problems_free(said);
    if (!train) return NULL;
    YkDeriveTrain *made = YK_NEW(d->arena, YkDeriveTrain, 1);
    if (!made) {
        d->failed = true;
        yk_train_free(train);
        return NULL;
    }
    *made = (YkDeriveTrain){.train = train};
    d->train = made; // freed with the derivation
    if (enter_speeds(d, &train->net) && enter_teeth(d, made) && choose_inputs(d, made)) return made;
    d->failed = true;
    return NULL;
}

void yk_derive_train_free(YkDeriveTrain *train)
{
    if (!train) return;
    yk_train_case_free(&train->motion);
    yk_train_free(train->train);
}

const YkPoisson *yk_derive_speed(YkDerivation *d, size_t body)
{
    if (d->speeds && d->speeds[body] >= 0) return yk_ring_of(d->ring, d->speeds[body]);
    return d->bodies[body].spin;
}

int32_t yk_derive_column_symbol(const YkDerivation *d, int32_t column)
{
    const YkTrainNet *net = &d->train->train->net;
    if (column < net->bodies) return d->speeds[net->body_of[column]];
    return d->coordinates[d->joint_distance[d->model->racks[column - net->bodies].slide]].rate;
}

const YkPoisson *yk_derive_column(YkDerivation *d, int32_t column)
{
    int32_t symbol = yk_derive_column_symbol(d, column);
    return symbol < 0 ? yk_ring_rational(d->ring, 0, 1) : yk_ring_of(d->ring, symbol);
}

const YkPoisson *yk_derive_coefficient(YkDerivation *d, const YkTrainTerm *term)
{
    const YkPoisson *teeth = term->symbol < 0 ? yk_ring_rational(d->ring, 1, 1) : d->train->symbols[term->symbol];
    return yk_ring_scale(d->ring, teeth, term->sign, 1);
}

bool yk_derive_is_input(YkDerivation *d, int32_t column)
{
    for (int32_t k = 0; k < d->train->input_count; k++)
        if (yk_ring_is_same(d->train->input_rates[k], yk_derive_column(d, column))) return true;
    return false;
}

const YkPoisson *yk_derive_row_zero(YkDerivation *d, const YkTrainRow *row)
{
    const YkPoisson *sum = yk_ring_rational(d->ring, 0, 1);
    for (int32_t t = 0; t < row->count; t++) {
        const YkPoisson *factor = yk_derive_coefficient(d, &row->terms[t]);
        const YkPoisson *speed = yk_derive_column(d, row->terms[t].column);
        sum = yk_ring_add(d->ring, sum, yk_ring_multiply(d->ring, factor, speed));
    }
    return sum;
}
