// Evaluates what the loads exert at a pose.
#include <string.h>
#include "elementary/kernel.h"
#include "loads/point.h"

YkMotion yk_loads_coordinate(const YkState *state, const YkSpace *space, int32_t coordinate)
{
    int32_t input = state->mech->coordinates[coordinate].input;
    if (input != YK_NONE) return (YkMotion){state->input[3 * input], state->input[3 * input + 1], 0};
    return yk_coordinate_in(state, space, (size_t)coordinate);
}

YkMotion yk_joint_motion(const YkMechanism *mech, const YkSpace *space, int32_t joint, bool is_distance)
{
    YkMotion m = {0, 0, 0};
    if (is_distance) {
        YkSlide s = yk_space_slide(space, mech->joint_distance[joint]);
        return (YkMotion){s.d[0], s.v[0], s.a[0]};
    }
    YkJointAngle angle = yk_joint_angle(mech, joint);
    for (int end = 0; end < 2; end++) {
        int32_t slot = end ? angle.b : angle.a;
        if (slot == 0) continue;
        YkTurn t = yk_space_turn(space, slot);
        m.velocity += (end ? 1 : -1) * t.w[0];
        m.acceleration += (end ? 1 : -1) * t.a[0];
    }
    return m;
}

double yk_joint_rate(const YkMechanism *mech, const YkSpace *space, int32_t joint, bool is_distance)
{
    return yk_joint_motion(mech, space, joint, is_distance).velocity;
}

static double evaluate(const YkLoads *loads, const YkLoadValue *value)
{
    if (!value->formula && !value->law) return value->constant;
    double x = value->formula ? yk_formula_eval(value->formula, loads->value) : value->constant;
    if (!value->law || !isfinite(x)) return x;
    double d[YK_LAW_ORDER + 1];
    yk_law_eval(value->law, x, d);
    return d[0];
}

typedef struct Pose {
    YkLoads *loads;
    const YkMechanism *mech;
    const YkState *state;
    const YkSpace *space;
    YkLoad *load;
} Pose;

static YkLoadPoint point_of(const Pose *p, const YkLoadEnd *end)
{
    return yk_load_point(p->mech, p->space, end);
}

// Returns a vector given in a body's axes, by way of one of its points, in world axes.
static YkVec in_world(const Pose *p, int32_t body, const YkLoadPoint *point, YkVec v)
{
    return yk_mul(point->turn, yk_mul(p->mech->bodies[body].turn_unit, v));
}

static void push(YkLoad *load, int32_t body, YkVec arm, YkVec force)
{
    load[body].force = yk_add(load[body].force, force);
    load[body].moment += yk_cross(arm, force);
}

void yk_loads_add_effort(const YkMechanism *mech, const YkSpace *space, int32_t joint, bool is_distance, double effort,
                         YkLoad *load)
{
    const YkJoint *first = yk_joint_end(mech->model, (size_t)joint, 0),
                  *last = yk_joint_end(mech->model, (size_t)joint, 1);
    int32_t from = first->body[0], on = last->body[1];
    if (!is_distance) {
        load[on].moment += effort;
        load[from].moment -= effort;
        return;
    }
    Pose p = {.mech = mech, .space = space};
    YkLoadEnd ends[2] = {yk_load_end(mech, from, first->at[0]), yk_load_end(mech, on, last->at[1])};
    YkLoadPoint a = point_of(&p, &ends[0]), b = point_of(&p, &ends[1]);
    YkVec force = yk_scale(effort, in_world(&p, from, &a, mech->model->joints[joint].along));
    push(load, on, b.arm, force);
    push(load, from, yk_add(a.arm, yk_sub(b.at, a.at)), yk_scale(-1, force));
}

// Adds a moment about a pin; returns its power.
static double push_about(const Pose *p, const YkLoadItem *item, double effort)
{
    double rate = 0;
    p->load[item->body[1]].moment += effort;
    p->load[item->body[0]].moment -= effort;
    for (int end = 0; end < 2; end++)
        if (item->slot[end] != 0) rate += (end ? 1 : -1) * yk_space_turn(p->space, item->slot[end]).w[0];
    return effort * rate;
}

// Does the same along any joint's freedom.
static double push_along(const Pose *p, const YkLoadItem *item, double effort)
{
    if (!item->is_distance) return push_about(p, item, effort);
    yk_loads_add_effort(p->mech, p->space, item->joint, item->is_distance, effort, p->load);
    return effort * yk_joint_rate(p->mech, p->space, item->joint, item->is_distance);
}

static double push_force(const Pose *p, const YkLoadItem *item)
{
    YkLoadPoint at = point_of(p, &item->end[0]);
    YkVec force = yk_vec(evaluate(p->loads, &item->value[0]), evaluate(p->loads, &item->value[1]));
    double moment = evaluate(p->loads, &item->value[2]);
    if (item->in_body_axes) force = in_world(p, item->body[0], &at, force);
    push(p->load, item->body[0], at.arm, force);
    p->load[item->body[0]].moment += moment;
    return yk_dot(force, at.velocity) + moment * at.w;
}

// A share of the machine's size. Between ends that a joint holds together only rounding is left, without a direction.
static const double NO_LENGTH = 1e-14;

static void set_own(YkLoads *loads, double length, double rate)
{
    if (loads->own[0]) loads->value[loads->own[0]] = length;
    if (loads->own[1]) loads->value[loads->own[1]] = rate;
}

// Returns the pull that has no potential: of the damper, and by a law of the spring's own.
static double pull_of(const Pose *p, const YkLoadItem *item, double length, double rate)
{
    set_own(p->loads, length, rate);
    return item->damping * rate + evaluate(p->loads, &item->value[0]);
}

// Pulls the ends of a spring together by stiffness * (length - free length) + damping * d(length)/dt + its own law.
// Returns the power of the last two.
static double push_spring(const Pose *p, const YkLoadItem *item)
{
    YkLoadPoint a = point_of(p, &item->end[0]), b = point_of(p, &item->end[1]);
    YkVec line = yk_sub(b.at, a.at);
    double length = sqrt(yk_dot(line, line)), rate = 0, own = 0;
    YkVec pull = yk_scale(item->stiffness, line); // a free length of 0 needs no direction
    if (length > NO_LENGTH * p->mech->size) {
        YkVec along = yk_scale(1 / length, line);
        rate = yk_dot(yk_sub(b.velocity, a.velocity), along);
        own = pull_of(p, item, length, rate);
        pull = yk_scale(item->stiffness * (length - item->length) + own, along);
    }
    push(p->load, item->body[0], a.arm, pull);
    push(p->load, item->body[1], b.arm, yk_scale(-1, pull));
    return -own * rate;
}

// Does the same along a joint's angle or distance.
static double push_spring_along(const Pose *p, const YkLoadItem *item)
{
    YkMotion m = yk_loads_coordinate(p->state, p->space, item->coordinate);
    double own = pull_of(p, item, m.position, m.velocity);
    push_along(p, item, -item->stiffness * (m.position - item->length) - own);
    return -own * m.velocity;
}

// Returns the power that it delivers.
static double push_handle(const Pose *p, const YkHandle *handle)
{
    YkLoadPoint point = point_of(p, &handle->end);
    YkVec pull = yk_sub(yk_scale(handle->stiffness, yk_sub(handle->target, point.at)),
                        yk_scale(handle->damping, point.velocity));
    YkVec force = yk_add(handle->force, pull);
    push(p->load, handle->end.body, point.arm, force);
    return yk_dot(force, point.velocity);
}

static double push_item(const Pose *p, YkLoadItem *item)
{
    double rate;
    switch (item->kind) {
    case YK_LOAD_EFFORT:
        item->last = evaluate(p->loads, &item->value[0]);
        return push_along(p, item, item->last);
    case YK_LOAD_FORCE:
        return push_force(p, item);
    case YK_LOAD_SPRING:
        return push_spring(p, item);
    case YK_LOAD_ALONG:
        return push_spring_along(p, item);
    case YK_LOAD_VISCOUS:
        rate = yk_joint_rate(p->mech, p->space, item->joint, item->is_distance);
        return push_along(p, item, -item->damping * rate);
    case YK_LOAD_COULOMB:
    case YK_LOAD_STOP:
        return push_along(p, item, item->dry);
    }
    return 0;
}

static void read_variables(YkLoads *loads, const YkState *state, const YkSpace *space)
{
    loads->value[0] = state->time;
    for (size_t k = 1; k < loads->variable_count; k++) {
        if (loads->variables[k].coordinate == YK_NONE) continue; // each spring's own
        YkMotion m = yk_loads_coordinate(state, space, loads->variables[k].coordinate);
        loads->value[k] = loads->variables[k].is_rate ? m.velocity : m.position;
    }
}

bool yk_loads_add(YkLoads *loads, const YkState *state, const YkSpace *space, YkLoad *load, double *power,
                  size_t *culprit)
{
    Pose p = {loads, loads->mech, state, space, load};
    if (loads->varies) read_variables(loads, state, space);
    for (size_t k = 0; k < loads->item_count; k++) {
        double delivered = push_item(&p, &loads->items[k]);
        if (power) power[k] = delivered;
        if (isfinite(delivered)) continue;
        *culprit = k;
        return false;
    }
    loads->handle_power = 0;
    for (size_t k = 0; k < loads->handle_count; k++)
        if (loads->handles[k].is_on) loads->handle_power += push_handle(&p, &loads->handles[k]);
    return true;
}

// Evaluates efforts, of which some follow formulas or laws, into `last`.
YK_APART void evaluate_efforts(YkLoads *loads, const YkState *state)
{
    read_variables(loads, state, &state->space);
    for (size_t k = 0; k < loads->item_count; k++) loads->items[k].last = evaluate(loads, &loads->items[k].value[0]);
}

static size_t first_without_value(const YkLoads *loads)
{
    size_t k = 0;
    while (k + 1 < loads->item_count && isfinite(loads->items[k].last)) k++;
    return k;
}

bool yk_loads_efforts(YkLoads *loads, const YkState *state, const double *rate, double *effort, double *power,
                      size_t *culprit)
{
    double off = 0; // or NaN
    if (loads->varies) evaluate_efforts(loads, state);
    if (loads->item_count < loads->mech->input_count) memset(effort, 0, loads->mech->input_count * sizeof *effort);
    YkLoadItem *item = loads->items, *end = item + loads->item_count;
    for (bool varies = loads->varies; item < end; item++) {
        if (!varies) item->last = item->value[0].constant;
        double last = item->last;
        effort[item->input] = last;
        *power++ = last * rate[item->input];
        off += last - last;
    }
    if (off == 0) return true;
    *culprit = first_without_value(loads);
    return false;
}

// Finds what the law of a spring may depend on: its length or angle, and the rate of it.
static void read_own(const Pose *p, const YkLoadItem *item)
{
    double length, rate = 0;
    if (item->kind == YK_LOAD_SPRING) {
        YkLoadPoint a = point_of(p, &item->end[0]), b = point_of(p, &item->end[1]);
        YkVec line = yk_sub(b.at, a.at);
        length = sqrt(yk_dot(line, line));
        if (length > NO_LENGTH * p->mech->size) rate = yk_dot(yk_sub(b.velocity, a.velocity), line) / length;
    } else {
        YkMotion m = yk_loads_coordinate(p->state, p->space, item->coordinate);
        length = m.position;
        rate = m.velocity;
    }
    set_own(p->loads, length, rate);
}

double yk_loads_law_argument(YkLoads *loads, const YkState *state, const YkSpace *space, size_t item, size_t part)
{
    const YkLoadItem *load = &loads->items[item];
    const YkLoadValue *value = &load->value[part];
    Pose p = {.loads = loads, .mech = loads->mech, .state = state, .space = space};
    if (!value->law) return (double)NAN;
    if (!value->formula) return value->constant;
    read_variables(loads, state, space);
    if (load->kind == YK_LOAD_SPRING || load->kind == YK_LOAD_ALONG) read_own(&p, load);
    return yk_formula_eval(value->formula, loads->value);
}

double yk_loads_effort(const YkLoads *loads, int32_t coordinate)
{
    double sum = 0;
    for (size_t k = 0; k < loads->item_count; k++)
        if (loads->items[k].kind == YK_LOAD_EFFORT && loads->items[k].coordinate == coordinate)
            sum += loads->items[k].last;
    return sum;
}

double yk_loads_stored(const YkLoads *loads, const YkState *state, const YkSpace *space)
{
    Pose p = {.mech = loads->mech, .space = space};
    double sum = 0;
    for (size_t k = 0; k < loads->item_count; k++) {
        const YkLoadItem *item = &loads->items[k];
        double stretch = 0;
        if (item->kind == YK_LOAD_SPRING) {
            YkLoadPoint a = point_of(&p, &item->end[0]), b = point_of(&p, &item->end[1]);
            stretch = yk_norm(yk_sub(b.at, a.at)) - item->length;
        } else if (item->kind == YK_LOAD_ALONG) {
            stretch = yk_loads_coordinate(state, space, item->coordinate).position - item->length;
        }
        sum += 0.5 * item->stiffness * stretch * stretch;
    }
    return sum;
}
