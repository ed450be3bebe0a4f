// Judges a design by its model file: the ordinary loader reads it, the ordinary engine assembles and drives it.
#include <math.h>
#include "synthesis/paths/path_bar.h"
#include <yoke/move.h>

typedef struct Trial {
    const YkDesign *design;
    const YkJourney *journey;
    YkModel *model;
    YkMechanism *mech;
    YkState *state, *first; // as it moves; at the first position
    size_t point, coupler, output, input_coordinate;
    double scale; // of lengths, m
    YkVerdict *verdict;
} Trial;

// A little more than a turn, so that an extreme at its very start is passed.
static const double turn_and_more = 2 + 1.0 / 90;
static const double met = 1e-6; // what a file of 12 digits may be off, near dead points, over the scale

static bool has_distance(const YkDesign *design)
{
    return design->kind == YK_DESIGN_SLIDER_CRANK || design->kind == YK_DESIGN_INVERTED;
}

static YkStatus stand(Trial *t, const char *text)
{
    t->model = yk_model_parse(text, strlen(text), "candidate", NULL, NULL);
    t->mech = t->model ? yk_mechanism_compile(t->model, NULL, NULL) : NULL;
    t->state = t->mech ? yk_state_new(t->mech) : NULL;
    t->first = t->mech ? yk_state_new(t->mech) : NULL;
    if (!t->state || !t->first || yk_input_count(t->mech) != 1) return YK_NO_MEMORY;
    bool has_dyad = yk_bar_size(t->design->kind) > YK_BAR_PLAIN;
    t->point = t->design->has_point ? yk_model_find_point(t->model, has_dyad ? "link.P" : "coupler.P") : 0;
    t->coupler = yk_model_find_body(t->model, has_dyad ? "link" : "coupler");
    t->output = yk_coordinate_find(t->mech, has_distance(t->design) ? "s" : "psi");
    t->input_coordinate = yk_input_coordinate(t->mech, 0);
    t->scale = yk_mechanism_size(t->mech);
    yk_state_set_time(t->state, 0, NULL);
    YkStatus status = yk_state_assemble(t->state);
    if (status == YK_NO_MEMORY) return status;
    if (status < 0) t->verdict->defect = YK_DEFECT_ASSEMBLY;
    return yk_state_copy(t->first, t->state);
}

// Adds how far the machine is from position k. Returns whether it is there.
static bool meets(Trial *t, size_t k)
{
    const YkJourney *journey = t->journey;
    double off = 0;
    if (journey->pose) {
        YkPointMotion p = yk_state_point(t->state, t->point);
        YkVec miss = yk_sub(yk_vec(p.position[0], p.position[1]), journey->pose[k].at);
        double angle = yk_state_body(t->state, t->coupler).position + t->design->turn - journey->pose[k].angle;
        double turned = t->scale * fabs(yk_remainder(angle, 2 * YK_PI));
        t->verdict->error += yk_dot(miss, miss) + turned * turned;
        t->verdict->worst = fmax(t->verdict->worst, yk_norm(miss));
        off = fmax(yk_norm(miss), turned) / t->scale;
    } else if (journey->point) {
        YkPointMotion p = yk_state_point(t->state, t->point);
        YkVec at = yk_vec(p.position[0], p.position[1]), miss = yk_sub(at, journey->point[k]);
        t->verdict->error += yk_dot(miss, miss);
        t->verdict->worst = fmax(t->verdict->worst, yk_norm(miss));
        off = yk_norm(yk_sub(at, journey->path[k])) / t->scale;
    } else if (journey->output && !isnan(journey->output[k])) {
        double miss = yk_state_coordinate(t->state, t->output).position - journey->output[k];
        off = fabs(has_distance(t->design) ? miss : yk_remainder(miss, 2 * YK_PI));
        t->verdict->error += off * off;
        t->verdict->worst = fmax(t->verdict->worst, off);
        if (has_distance(t->design)) off /= t->scale;
    }
    return off <= met;
}

// Returns whether the body passes position k in the direction of its rates there, whatever the input's own rate.
static bool passes(Trial *t, size_t k)
{
    const YkJourney *journey = t->journey;
    for (size_t i = 0; i < journey->rates; i++) {
        const YkPose *rate = &journey->pose[journey->count + i];
        if (journey->rate_of[i] != k) continue;
        yk_state_set_input_to(t->state, 0, journey->input[k], 1, 0);
        if (yk_state_solve(t->state) < 0 || !yk_state_has_rates(t->state)) return false;
        YkPointMotion p = yk_state_point(t->state, t->point);
        const double is[] = {p.velocity[0], p.velocity[1], t->scale * yk_state_body(t->state, t->coupler).velocity};
        const double wanted[] = {rate->velocity.x, rate->velocity.y, t->scale * rate->rate};
        double square = 0, other = 0, both = 0;
        for (size_t j = 0; j < 3; j++) {
            square += is[j] * is[j];
            other += wanted[j] * wanted[j];
            both += is[j] * wanted[j];
        }
        if (!(square * other - both * both <= met * met * square * other)) return false; // of the angle between them
    }
    return true;
}

// Drives the machine from position to position.
static YkStatus travel(Trial *t)
{
    const YkJourney *journey = t->journey;
    YkVerdict *verdict = t->verdict;
    for (size_t k = 0; k < journey->count; k++) {
        YkMotion goal = {.position = journey->input[k]};
        YkStatus status = yk_state_move_to(t->state, &goal, NULL, NULL);
        if (status == YK_NO_MEMORY) return status;
        if (status < 0 || status == YK_SINGULAR || ((!meets(t, k) || !passes(t, k)) && journey->exact)) {
            verdict->defect = k == 0 ? YK_DEFECT_ASSEMBLY : YK_DEFECT_BRANCH;
            return YK_OK;
        }
    }
    return YK_OK;
}

static void take_extreme(YkVerdict *verdict, const YkEvent *event)
{
    if (event->is_maximum && event->value > verdict->high) {
        verdict->high = event->value;
        verdict->high_at = event->at;
    } else if (!event->is_maximum && event->value < verdict->low) {
        verdict->low = event->value;
        verdict->low_at = event->at;
    }
}

// The transmission angle of a joint, from the angle of its two links, or of coupler and slider. Inverted slider-crank:
// that of the coupler's line and the line to the output pivot, from the distance along the coupler.
static double transmission_of(const YkDesign *design, double value)
{
    if (design->kind == YK_DESIGN_INVERTED) return fabs(yk_atan2(fabs(value), fabs(design->length[3])));
    double shift = design->kind == YK_DESIGN_SLIDER_CRANK ? design->along + YK_PI / 2 : 0;
    return yk_asin(fmin(fabs(yk_sin(value + shift)), 1));
}

static void take_transmission(const Trial *t, double value)
{
    double *range = t->verdict->transmission, folded = transmission_of(t->design, value);
    range[0] = fmin(range[0], folded);
    range[1] = fmax(range[1], folded);
}

// Returns which quarter turns lie between: where it changes, the transmission angle passes 0 or a right angle.
static double side_of(const Trial *t, double value)
{
    double shift = t->design->kind == YK_DESIGN_SLIDER_CRANK ? t->design->along + YK_PI / 2 : 0;
    return t->design->kind == YK_DESIGN_INVERTED ? 0 : floor((value + shift) / YK_PI - 0.5);
}

// Channels: a joint's angle, the point (or input and output), and the angle of a second loop's joint.
enum { JOINT, FIRST, SECOND, OTHER, CHANNELS };

static void take_joint(Trial *t, const YkSweep *sweep, size_t channel)
{
    for (size_t r = 0; r < yk_sweep_row_count(sweep); r++) {
        double value = yk_sweep_value(sweep, r, channel);
        take_transmission(t, value);
        if (r > 0 && side_of(t, value) != side_of(t, yk_sweep_value(sweep, r - 1, channel)))
            t->verdict->transmission[1] = YK_PI / 2;
    }
    for (size_t k = 0; k < yk_sweep_event_count(sweep); k++) {
        YkEvent event = yk_sweep_event(sweep, k);
        if (event.kind == YK_EVENT_EXTREME && event.channel == channel) take_transmission(t, event.value);
    }
}

static void take_rows(Trial *t, const YkSweep *sweep, size_t channels)
{
    YkVerdict *verdict = t->verdict;
    size_t rows = yk_sweep_row_count(sweep);
    verdict->transmission[0] = INFINITY;
    verdict->transmission[1] = 0;
    verdict->low = INFINITY;
    verdict->high = -INFINITY;
    take_joint(t, sweep, JOINT);
    if (channels > OTHER) take_joint(t, sweep, OTHER);
    for (size_t r = 0; r < rows && r < YK_CURVE_ROWS; r++) {
        verdict->curve[2 * r] = yk_sweep_value(sweep, r, 1);
        verdict->curve[2 * r + 1] = yk_sweep_value(sweep, r, 2);
        verdict->rows = r + 1;
    }
    for (size_t k = 0; k < yk_sweep_event_count(sweep); k++) {
        YkEvent event = yk_sweep_event(sweep, k);
        if (event.kind == YK_EVENT_EXTREME && event.channel == 2) take_extreme(verdict, &event);
    }
}

// Sweeps the whole motion for the transmission angle and the curve.
static YkStatus follow(Trial *t)
{
    const YkJourney *journey = t->journey;
    YkChannel channels[CHANNELS];
    YkDesignKind kind = t->design->kind;
    bool has_dyad = yk_bar_size(kind) > YK_BAR_PLAIN;
    size_t count = has_dyad && kind != YK_DESIGN_GEARED ? CHANNELS : OTHER;
    YkSweepOptions options = yk_default_sweep_options();
    const char *joint = kind == YK_DESIGN_GEARED ? "E.angle" : kind == YK_DESIGN_INVERTED ? "s" : "B.angle";
    const char *names[] = {joint, "theta", has_distance(t->design) ? "s" : "psi", "E.angle"};
    if (t->design->has_point) {
        names[FIRST] = has_dyad ? "link.P.x" : "coupler.P.x";
        names[SECOND] = has_dyad ? "link.P.y" : "coupler.P.y";
    }
    double low = journey->input[0], high = low;
    for (size_t k = 0; k < count; k++)
        if (yk_channel_parse(t->mech, names[k], &channels[k], NULL) != YK_OK) return YK_NO_MEMORY;
    for (size_t k = 0; k < journey->count; k++) {
        low = fmin(low, journey->input[k]);
        high = fmax(high, journey->input[k]);
    }
    bool is_backward = journey->input[journey->count - 1] < journey->input[0];
    options.coordinate = (int)t->input_coordinate;
    options.from = journey->turns ? journey->input[0] : is_backward ? high : low;
    options.to = journey->turns ? journey->input[0] + (is_backward ? -turn_and_more : turn_and_more) * YK_PI
                 : is_backward  ? low
                                : high;
    options.steps = YK_CURVE_ROWS - 1;
    YkMotion start = {.position = options.from};
    YkStatus status = yk_state_move_to(t->first, &start, NULL, NULL);
    YkSweep *sweep = status >= 0 ? yk_sweep_run(t->first, &options, channels, count, NULL) : NULL;
    if (!sweep) return status < 0 && status != YK_NO_MEMORY ? YK_OK : YK_NO_MEMORY;
    if (yk_sweep_status(sweep) < 0) t->verdict->defect = journey->turns ? YK_DEFECT_INPUT : YK_DEFECT_BRANCH;
    take_rows(t, sweep, count);
    yk_sweep_free(sweep);
    return YK_OK;
}

YkStatus yk_design_judge(const char *text, const YkDesign *design, const YkJourney *journey, YkVerdict *verdict)
{
    Trial trial = {.design = design, .journey = journey, .verdict = verdict};
    const YkGiven *transmission = &journey->task->transmission;
    verdict->defect = YK_DEFECT_NONE;
    verdict->error = verdict->worst = verdict->transmission[0] = verdict->transmission[1] = 0;
    verdict->rows = 0;
    YkStatus status = stand(&trial, text);
    if (status >= 0 && verdict->defect == YK_DEFECT_NONE) status = travel(&trial);
    if (status >= 0 && verdict->defect == YK_DEFECT_NONE) status = follow(&trial);
    if (verdict->defect == YK_DEFECT_NONE && transmission->is_given && verdict->transmission[0] < transmission->value)
        verdict->defect = YK_DEFECT_TRANSMISSION;
    yk_state_free(trial.state);
    yk_state_free(trial.first);
    yk_mechanism_free(trial.mech);
    yk_model_free(trial.model);
    return status < 0 ? YK_NO_MEMORY : YK_OK;
}
