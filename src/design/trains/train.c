// Analyses a gear train: from a model and a question to speeds, ratios and a shift table.
#include "design/trains/train.h"
#include <math.h>
#include <stdlib.h>

static const YkPlace nowhere = {0};

YkTrainOptions yk_default_train_options(void)
{
    return (YkTrainOptions){.efficiency = 1};
}

const char *yk_train_status_name(YkTrainStatus status)
{
    static const char *const names[] = {"ok", "free", "undetermined", "locked"};
    return names[status];
}

// --- The question

static bool find_lock(const YkTrain *train, const YkLock **lock, YkProblems *problems)
{
    *lock = NULL;
    return !train->options.lock || yk_model_find_lock(train->model, train->options.lock, lock, problems);
}

// Finds a body of the train by name; YK_NONE if none is asked for. Returns false (reported) for a wrong name.
static bool find_body(const YkTrain *train, const char *name, int32_t *body, YkProblems *problems)
{
    *body = YK_NONE;
    if (!name) return true;
    *body = yk_names_find(&train->model->body_names, name);
    if (*body > 0 && train->net.column_of[*body] >= 0) return true;
    yk_problem(problems, YK_CODE_NOT_OF_TRAIN, nowhere,
               *body == YK_NONE ? "there is no body %q"
               : *body == 0     ? "%q stands still; it is neither input nor output"
                                : "%q is not part of the gear train",
               name);
    return false;
}

static int32_t find_named(const YkTrain *train, const char *const *names)
{
    for (; *names; names++) {
        int32_t body = yk_names_find(&train->model->body_names, *names);
        if (body > 0 && train->net.column_of[body] >= 0) return body;
    }
    return YK_NONE;
}

// Returns the driven body if there is one drive on the ground, otherwise the body that is called so.
static int32_t usual_input(const YkTrain *train)
{
    static const char *const names[] = {"input", "in", NULL};
    if (train->drive_count == 1 && !train->drives[0].shown.is_unit && !train->drives[0].shown.is_distance) {
        const YkCoordinate *coordinate = &train->model->coordinates[train->drives[0].coordinate];
        const int32_t *body = train->model->joints[coordinate->joint].body;
        if (body[0] == 0 || body[1] == 0) return body[body[0] == 0];
    }
    return find_named(train, names);
}

// --- Ratios

static const char *exact_of(const YkTrain *train, const YkFraction *value)
{
    YkText text = {0};
    if (!train->net.is_exact) return NULL;
    yk_fraction_write(value, &text);
    return yk_train_keep(train->arena, &text);
}

// Finds the turns of `in` per turn of `out` when nothing else drives. Returns false when out of memory or on overflow.
static bool ratio_alone(YkTrain *train, const YkLock *lock, YkTrainRatio *ratio, YkTrainCase *one)
{
    const YkTrainDrive unit = {.coordinate = YK_NONE,
                               .body = (int32_t)ratio->in,
                               .exact = {.is_exact = true, .numerator = 1, .denominator = 1},
                               .shown = {.name = train->model->bodies[ratio->in].name, .is_unit = true, .speed = 1}};
    int32_t out = train->net.column_of[ratio->out];
    if (!yk_train_case_solve(one, &train->net, lock, &unit, 1, train->arena)) return false;
    if (one->status == YK_TRAIN_STATUS_LOCKED || !yk_exact_is_determined(&one->system, out)) return true;
    const YkFraction *share = yk_train_case_share(one, out, 0);
    ratio->is_known = true;
    if (yk_fraction_is_zero(share)) {
        ratio->out_stands = true;
        ratio->value = HUGE_VAL;
        return true;
    }
    YkFraction inverse = yk_fraction_inverse(share);
    ratio->value = yk_fraction_value(&inverse);
    ratio->exact = exact_of(train, &inverse);
    ratio->formula = yk_train_formula(one, out, 0, true, train->arena);
    return true;
}

// Finds the ratio of two speeds that several drives produce together.
static void ratio_by_drives(YkTrain *train)
{
    YkTrainRatio *ratio = &train->ratio;
    const YkTrainBody *in = NULL, *out = NULL;
    for (int32_t c = 1; c < train->net.bodies; c++) {
        if (train->bodies[c - 1].body == ratio->in) in = &train->bodies[c - 1];
        if (train->bodies[c - 1].body == ratio->out) out = &train->bodies[c - 1];
    }
    if (!in || !out || !in->is_determined || !out->is_determined) return;
    ratio->is_known = ratio->is_by_drives = true;
    ratio->out_stands = out->speed == 0;
    ratio->value = in->speed / out->speed;
}

static bool find_ratio(YkTrain *train, const YkLock *lock, int32_t in, int32_t out)
{
    train->ratio = (YkTrainRatio){.in = in == YK_NONE ? YK_NOT_FOUND : (size_t)in,
                                  .out = out == YK_NONE ? YK_NOT_FOUND : (size_t)out};
    if (in == YK_NONE || out == YK_NONE) return true;
    YkTrainCase one;
    bool good = ratio_alone(train, lock, &train->ratio, &one);
    train->motion.system.overflow |= one.system.overflow;
    yk_train_case_free(&one);
    if (good && !train->ratio.is_known) ratio_by_drives(train);
    return good;
}

// --- The shift table

static bool fill_gear(YkTrain *train, size_t index)
{
    YkTrainGear *gear = &train->gears[index];
    const YkLock *lock = &train->model->locks[index];
    YkTrainCase one;
    bool good = yk_train_case_solve(&one, &train->net, lock, NULL, 0, train->arena);
    *gear = (YkTrainGear){.lock = lock->name, .freedom = good ? yk_train_case_freedom(&one) : 0, .ratio = train->ratio};
    train->motion.system.overflow |= one.system.overflow;
    yk_train_case_free(&one);
    if (!good) return false;
    gear->ratio = (YkTrainRatio){.in = train->ratio.in, .out = train->ratio.out};
    good = ratio_alone(train, lock, &gear->ratio, &one);
    gear->status = one.status;
    gear->message = one.message;
    if (gear->ratio.is_known && gear->status == YK_TRAIN_STATUS_UNDETERMINED) { // others may spin freely
        gear->status = YK_TRAIN_STATUS_OK;
    }
    train->motion.system.overflow |= one.system.overflow;
    yk_train_case_free(&one);
    return good;
}

static bool fill_shift_table(YkTrain *train)
{
    if (train->options.lock || train->ratio.in == YK_NOT_FOUND || train->ratio.out == YK_NOT_FOUND) return true;
    train->gears = YK_NEW(train->arena, YkTrainGear, train->model->lock_count + 1);
    if (!train->gears) return false;
    for (size_t i = 0; i < train->model->lock_count; i++, train->gear_count++)
        if (!fill_gear(train, i)) return false;
    return true;
}

// --- Speeds

static void fill_speed(YkTrain *train, int32_t column, YkFraction *shares)
{
    const YkTrainCase *one = &train->motion;
    YkTrainBody *body = &train->bodies[column - 1];
    *body = (YkTrainBody){.body = (size_t)train->net.body_of[column], .speed = NAN};
    if (one->status == YK_TRAIN_STATUS_LOCKED || !yk_exact_is_determined(&one->system, column)) return;
    body->is_determined = true;
    body->speed = 0;
    for (int32_t k = 0; k < train->drive_count; k++) {
        YkTrainShare *share = &train->shares[(size_t)(column - 1) * (size_t)train->drive_count + (size_t)k];
        shares[k] = *yk_train_case_share(one, column, k);
        share->value = yk_fraction_value(&shares[k]);
        share->exact = exact_of(train, &shares[k]);
        share->formula = yk_train_formula(one, column, k, false, train->arena);
        if (share->value != 0) body->speed += share->value * train->drives[k].shown.speed;
    }
    body->exact = yk_train_exact_speed(train, shares, train->drive_count, false);
}

static bool fill_speeds(YkTrain *train)
{
    size_t count = (size_t)train->net.bodies, inputs = (size_t)train->drive_count;
    train->bodies = YK_NEW(train->arena, YkTrainBody, count);
    train->shares = YK_NEW(train->arena, YkTrainShare, count * inputs + 1);
    YkFraction *shares = calloc(inputs + 1, sizeof *shares);
    bool good = train->bodies && train->shares && shares;
    for (int32_t c = 1; good && c < train->net.bodies; c++) fill_speed(train, c, shares);
    free(shares);
    return good;
}

static bool fill_rack_speeds(YkTrain *train)
{
    const YkModel *model = train->model;
    size_t first = model->gear_count + model->belt_count;
    train->rack_speeds = YK_NEW(train->arena, double, (size_t)train->net.mesh_count + 1);
    if (!train->rack_speeds) return false;
    for (size_t m = 0; m < (size_t)train->net.mesh_count; m++) train->rack_speeds[m] = NAN;
    for (size_t r = 0; r < model->rack_count; r++) {
        int32_t column = train->net.bodies + (int32_t)r;
        if (train->motion.status == YK_TRAIN_STATUS_LOCKED || !yk_exact_is_determined(&train->motion.system, column))
            continue;
        train->rack_speeds[first + r] = 0;
        for (int32_t k = 0; k < train->drive_count; k++)
            train->rack_speeds[first + r] +=
                yk_fraction_value(yk_train_case_share(&train->motion, column, k)) * train->drives[k].shown.speed;
    }
    return true;
}

// Writes "(sun - arm)*N1 = -(planet - arm)*N2", in which the names stand for speeds.
static bool write_willis(YkTrain *train)
{
    const YkTrainNet *net = &train->net;
    train->willis = YK_NEW(train->arena, const char *, (size_t)net->mesh_count + 1);
    for (size_t m = 0; train->willis && m < (size_t)net->mesh_count; m++) {
        YkTrainMesh mesh = yk_train_mesh(train, m);
        YkText text = {0};
        const char *a = train->model->bodies[mesh.body[0]].name, *b = train->model->bodies[mesh.body[1]].name;
        const char *c = train->model->bodies[mesh.carrier].name;
        bool is_ground = mesh.carrier == 0, is_rack = mesh.kind == YK_TRAIN_KIND_RACK;
        yk_text_format(&text, is_ground ? "%s" : "(%s - %s)", a, c);
        yk_text_format(&text, "*%s = ", mesh.symbol[0]);
        const YkTrainRow *row = yk_train_mesh_row(net, (int32_t)m);
        if (is_rack ? row->terms[2].sign > 0 : row->terms[1].sign > 0) yk_text_puts(&text, "-");
        yk_text_format(&text, is_rack ? "rate of %s" : is_ground ? "%s" : "(%s - %s)", b, c);
        if (!is_rack) yk_text_format(&text, "*%s", mesh.symbol[1]);
        train->willis[m] = yk_train_keep(train->arena, &text);
    }
    return !yk_arena_failed(train->arena);
}

// --- The whole

static bool count_freedom(YkTrain *train, const YkLock *lock)
{
    YkTrainCase one;
    bool good = yk_train_case_solve(&one, &train->net, lock, NULL, 0, train->arena);
    if (good) train->freedom = yk_train_case_freedom(&one);
    train->motion.system.overflow |= one.system.overflow;
    yk_train_case_free(&one);
    return good;
}

static bool is_possible(const YkTrain *train, YkProblems *problems)
{
    double efficiency = train->options.efficiency;
    if (train->net.mesh_count == 0) {
        yk_problem(problems, YK_CODE_NO_TRAIN, nowhere, "the model has no gears, racks or belts");
        return false;
    }
    if (efficiency > 0 && efficiency <= 1) return true;
    yk_problem(problems, YK_CODE_BAD_EFFICIENCY, nowhere, "an efficiency of %g is not above 0 and up to 1", efficiency);
    return false;
}

// Runs all steps in turn. Returns false when out of memory, beyond the exact numbers, or for a problem that is
// reported.
static bool analyse(YkTrain *train, YkProblems *problems)
{
    static const char *const outputs[] = {"output", "out", NULL};
    const YkLock *lock = NULL;
    int32_t in, out;
    if (!find_lock(train, &lock, problems) || !find_body(train, train->options.in, &in, problems) ||
        !find_body(train, train->options.out, &out, problems) || !count_freedom(train, lock))
        return false;
    if (!yk_train_drives(train, in)) return false;
    if (in == YK_NONE) in = usual_input(train);
    if (out == YK_NONE) out = find_named(train, outputs);
    if (train->drive_count == 0 && in != YK_NONE && !yk_train_drives(train, in)) return false;
    return yk_train_case_solve(&train->motion, &train->net, lock, train->drives, train->drive_count, train->arena) &&
           fill_speeds(train) && fill_rack_speeds(train) && find_ratio(train, lock, in, out) &&
           fill_shift_table(train) && write_willis(train) && yk_train_tables(train) && yk_train_remarks(train) &&
           yk_train_torques(train, problems);
}

YkTrain *yk_train_new(const YkModel *model, const YkTrainOptions *options, YkProblems *problems)
{
    size_t errors = yk_problems_error_count(problems);
    YkArena *arena = yk_arena_new();
    YkTrain *train = arena ? YK_NEW(arena, YkTrain, 1) : NULL;
    bool good = train != NULL;
    if (train) {
        *train = (YkTrain){.model = model, .arena = arena, .options = options ? *options : yk_default_train_options()};
        good =
            yk_train_net_build(&train->net, model, arena) && is_possible(train, problems) && analyse(train, problems);
        if (!good && train->motion.system.overflow)
            yk_problem(problems, YK_CODE_TRAIN_OVERFLOW, nowhere, "the train's exact ratios are beyond 2048 bits");
        good = good && !yk_arena_failed(arena);
    }
    if (good) return train;
    if (problems && yk_problems_error_count(problems) == errors)
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, nowhere, "out of memory while analysing the gear train");
    if (train) yk_train_case_free(&train->motion);
    yk_arena_free(arena);
    return NULL;
}

void yk_train_free(YkTrain *train)
{
    if (!train) return;
    yk_train_case_free(&train->motion);
    yk_arena_free(train->arena);
}
