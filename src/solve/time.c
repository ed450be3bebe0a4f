// Sets the inputs at a time: the values of the drives, and how well these are known after many turns.
#include "solve/state.h"
#include "base/number.h"
#include "base/problems.h"

#define FAR 1024      // rad: up to this an angle is known to 1e-13
#define UNSURE 1e-9   // rad, or lengths over the size: from this on rounding is reported
#define UNKNOWN 0.125 // from this on no digit is left

void yk_state_place_phases(YkState *s)
{
    for (size_t i = 0; i < s->mech->input_count; i++) {
        const YkPhase *phase = &s->phases[i];
        s->input_lanes[3 * i] = s->input[3 * i] == phase->value ? &phase->angle : &s->input[3 * i];
    }
}

// Returns whether an input has a phase; gears and cams follow the angle itself, with all its turns.
static bool has_phase(YkState *s, size_t i, double angle)
{
    const YkTreeCoordinate *c = &s->mech->coordinates[s->mech->inputs[i]];
    YkPhase phase = {NAN, 0};
    bool good = fabs(angle) > FAR && !c->is_distance && s->mech->relation_count == 0 &&
                yk_model_drive_phase(s->mech->model, (size_t)c->drive, s->time, &phase.angle);
    if (good) phase.value = angle;
    s->phases[i] = phase;
    s->has_phases = s->has_phases || good;
    return good;
}

static void tell(const YkState *s, const YkTreeCoordinate *c, YkProblems *problems, double rounding)
{
    const YkDrive *drive = &s->mech->model->drives[c->drive];
    char number[YK_NUMBER_SIZE];
    const char *unit = c->is_distance ? "m" : "rad";
    yk_number_write_digits(rounding, 2, number);
    if (rounding < UNKNOWN * (c->is_distance ? s->mech->size : 1)) {
        yk_problem(problems, YK_CODE_DRIVE_UNSURE, drive->place,
                   "at this time the drive of %q is known only to %s %s, because its expression rounds", c->name,
                   number, unit);
    } else {
        yk_problem(problems, YK_CODE_DRIVE_UNKNOWN, drive->place,
                   "at this time no digit of the drive of %q is left: its expression rounds off %s %s", c->name, number,
                   unit);
    }
    yk_problem_hint(problems, "ask for an earlier time; after so many turns only drives `a + b*t` of linkages without "
                              "gears, cams and laws keep their digits");
}

// Checks the digits of a value; without a list for problems it checks only what is plain from the value.
static YkStatus look_at_digits(const YkState *s, const YkTreeCoordinate *c, double value, YkProblems *problems)
{
    double size = c->is_distance ? s->mech->size : 1;
    if (!problems && !(fabs(value) > FAR / UNSURE * size)) return YK_OK;
    double rounding = yk_model_drive_rounding(s->mech->model, (size_t)c->drive, s->time);
    if (problems && !(rounding < UNSURE * size)) tell(s, c, problems, rounding);
    return rounding < UNKNOWN * size ? YK_OK : YK_BAD_MODEL;
}

static YkStatus set_driven(YkState *s, size_t i, YkProblems *problems)
{
    const YkTreeCoordinate *c = &s->mech->coordinates[s->mech->inputs[i]];
    YkJet jet;
    YkStatus status = yk_model_drive(s->mech->model, (size_t)c->drive, s->time, &jet, problems);
    if (status == YK_OK && !s->is_held[3 * i] && !has_phase(s, i, jet.d[0]))
        status = look_at_digits(s, c, jet.d[0], problems);
    if (status != YK_OK) return status;
    for (int k = 0; k < 3; k++) s->input[3 * i + (size_t)k] = jet.d[k];
    return YK_OK;
}

// Sets the rates of coordinates that are held and not driven.
static void set_start_rates(YkState *s)
{
    const YkModel *model = s->mech->model;
    for (size_t k = 0; k < model->start_count; k++) {
        const YkCoordinate *c = &model->coordinates[model->starts[k].coordinate];
        int32_t q = model->starts[k].is_rate ? yk_tree_coordinate(s->mech, c->joint, c->is_distance) : YK_NONE;
        if (q == YK_NONE || s->mech->coordinates[q].drive != YK_NONE || s->mech->coordinates[q].input == YK_NONE)
            continue;
        s->input[3 * s->mech->coordinates[q].input + 1] = model->starts[k].value;
    }
}

YkStatus yk_state_set_time(YkState *s, double time, YkProblems *problems)
{
    YkStatus status = YK_OK;
    s->time = time;
    for (size_t i = 0; i < s->mech->input_count; i++) {
        int32_t coordinate = s->mech->inputs[i];
        if (s->mech->coordinates[coordinate].drive != YK_NONE) {
            YkStatus one = set_driven(s, i, problems);
            if (one != YK_OK) status = one;
            continue;
        }
        s->input[3 * i] = s->guess[coordinate];
        s->input[3 * i + 1] = s->input[3 * i + 2] = 0;
    }
    set_start_rates(s);
    for (size_t k = 0; k < 3 * s->mech->input_count; k++)
        if (s->is_held[k]) s->input[k] = s->held[k];
    return status;
}
