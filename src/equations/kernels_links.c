// The recursion of open trees over the states of one machine, and steps of Runge-Kutta.
#include "equations/kernels_links.h"
#include "elementary/elementary.h"
#include "elementary/turn.h"
#include "equations/tree_noise.h"

void yk_link_lanes_start(YkLinkLanes *lanes, YkVec gravity)
{
    YkLinkFound *ground = &lanes->found[0];
    *ground = (YkLinkFound){0};
    for (size_t i = 0; i < YK_TREE_LANES; i++) {
        ground->c[i] = 1;
        ground->a_x[i] = -gravity.x;
        ground->a_y[i] = -gravity.y;
    }
}

// --- a pose

// Repeats the lanes one by one if at least one is beyond the reduction's range.
YK_APART void turn_one_by_one(YkLinkFound *own, const YkLinkFound *parent, const double *q, double sense, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        YkVec e;
        yk_sincos(sense * q[i], &e.y, &e.x);
        e = yk_mul(yk_vec(parent->c[i], parent->s[i]), e);
        own->c[i] = e.x;
        own->s[i] = e.y;
    }
}

// Finds direction and rate of turning; see find_turn of kernels_tree.c.
YK_INLINE void turn(YkLinkFound *own, const YkLinkFound *parent, const double *q, const double *v, double sense,
                    size_t n)
{
    uint64_t far = 0;
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        double x = sense * q[i], s, c;
        sincos_near(x, &s, &c);
        far |= sincos_far_bits(x);
        YkVec e = yk_mul(yk_vec(parent->c[i], parent->s[i]), yk_vec(c, s));
        own->c[i] = e.x;
        own->s[i] = e.y;
        own->w[i] = parent->w[i] + sense * v[i];
    }
    if (sincos_is_far(far)) turn_one_by_one(own, parent, q, sense, n);
}

YK_INLINE void keep_turn(YkLinkFound *own, const YkLinkFound *parent, size_t n)
{
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        own->c[i] = parent->c[i];
        own->s[i] = parent->s[i];
        own->w[i] = parent->w[i];
    }
}

// Places the joint, and the link by itself. liner: the link that has the line; d, rate: NULL without a slide.
YK_INLINE void place(const YkTreeLink *link, YkLinkFound *own, const YkLinkFound *parent, const YkLinkFound *liner,
                     const double *d, const double *rate, bool slides, size_t n)
{
    double mine = link->line_is_own ? 1 : 0, theirs = 1 - mine;
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        double w_p = parent->w[i], w = own->w[i];
        YkVec along = yk_scale(slides ? d[i] : 0, link->line), shift = yk_scale(-mine, along);
        YkVec at = yk_sub(link->at, yk_vec(parent->shift_x[i], parent->shift_y[i]));
        YkVec arm = yk_mul(yk_vec(parent->c[i], parent->s[i]), yk_add(at, yk_scale(theirs, along)));
        YkVec bias = yk_scale(-w_p * w_p, arm), e = yk_vec(own->c[i], own->s[i]);
        if (slides) {
            YkVec line = yk_mul(yk_vec(liner->c[i], liner->s[i]), link->line);
            bias = yk_add(bias, yk_scale(2 * liner->w[i] * rate[i], yk_quarter(line)));
            own->line_x[i] = line.x, own->line_y[i] = line.y;
        }
        YkVec center = yk_sub(link->center, shift), moment = yk_mul(e, yk_scale(link->mass, center));
        double inertia = link->inertia + link->mass * yk_dot(center, center);
        own->shift_x[i] = shift.x, own->shift_y[i] = shift.y;
        own->arm_x[i] = arm.x, own->arm_y[i] = arm.y;
        own->bias_x[i] = bias.x, own->bias_y[i] = bias.y;
        YkInertia alone = {.J = inertia, .h = yk_quarter(moment), .xx = link->mass, .yy = link->mass};
        yk_inertia_write(&own->inertia, i, alone);
        own->f_x[i] = -w * w * moment.x, own->f_y[i] = -w * w * moment.y;
        own->n[i] = 0;
        yk_inertia_write(&own->noise, i, (YkInertia){.J = inertia, .xx = link->mass, .yy = link->mass});
    }
}

// --- inwards

YK_INLINE YkArticulated read(const YkLinkFound *own, size_t i)
{
    return (YkArticulated){yk_inertia_read(&own->inertia, i), yk_vec(own->f_x[i], own->f_y[i]), own->n[i]};
}

YK_INLINE void add(YkInertiaFew *rows, const YkInertia *more, size_t i)
{
    YkInertia sum = yk_inertia_read(rows, i);
    yk_inertia_add(&sum, more);
    yk_inertia_write(rows, i, sum);
}

YK_INLINE void pass(YkLinkFound *parent, const YkArticulated *A, const YkInertia *noise, size_t i)
{
    add(&parent->inertia, &A->of, i);
    add(&parent->noise, noise, i);
    parent->f_x[i] += A->f.x, parent->f_y[i] += A->f.y;
    parent->n[i] += A->n;
}

// Releases the freedoms of a joint under what acts along them, and passes the rest to the parent, unless that is the
// ground.
YK_INLINE void inward(const YkTreeLink *link, YkLinkFound *own, YkLinkFound *parent, const double *torque,
                      const double *force, bool turns, bool slides, double *ok, size_t n)
{
    bool has_parent = link->parent != 0;
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        YkArticulated A = read(own, i);
        YkVec arm = yk_vec(own->arm_x[i], own->arm_y[i]), bias = yk_vec(own->bias_x[i], own->bias_y[i]);
        YkInertia noise = yk_inertia_read(&own->noise, i);
        double good = ok[i];
        if (turns) {
            good = A.of.J > YK_LEAST_OVER_NOISE * noise.J ? good : 0;
            double trace = yk_inertia_trace(&A.of);
            YkAnswer found = yk_articulated_release_turn(&A, link->sense * torque[i]);
            own->turn_by[i] = found.by, own->turn_x[i] = found.on.x, own->turn_y[i] = found.on.y;
            yk_noise_release_turn(&noise, found.on, trace);
        }
        A.f = yk_add(A.f, yk_inertia_times(&A.of, bias));
        A.n += yk_dot(A.of.h, bias);
        if (slides) {
            YkVec line = yk_vec(own->line_x[i], own->line_y[i]);
            double pivot = yk_dot(line, yk_inertia_times(&A.of, line));
            good = pivot > YK_LEAST_OVER_NOISE * yk_noise_along(&noise, line) ? good : 0;
            const YkArticulated before = A;
            YkAnswer found = yk_articulated_release_slide(&A, line, force[i]);
            own->slide_by[i] = found.by, own->slide_turn[i] = found.turn;
            own->slide_x[i] = found.on.x, own->slide_y[i] = found.on.y;
            yk_noise_release_slide(&noise, line, found, &before);
        }
        ok[i] = good;
        if (has_parent) {
            YkArticulated moved = yk_articulated_move(&A, arm);
            YkInertia there = yk_noise_move(&noise, yk_quarter(arm), yk_inertia_trace(&A.of));
            pass(parent, &moved, &there, i);
        }
    }
}

// --- outwards

YK_INLINE void outward(const YkTreeLink *link, YkLinkFound *own, const YkLinkFound *parent, double *angle_out,
                       double *distance_out, bool turns, bool slides, size_t n)
{
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        double alpha = parent->alpha[i];
        YkVec bias = yk_vec(own->bias_x[i], own->bias_y[i]), arm = yk_vec(own->arm_x[i], own->arm_y[i]);
        YkVec rigid = yk_add(yk_vec(parent->a_x[i], parent->a_y[i]), yk_scale(alpha, yk_quarter(arm)));
        YkVec a = yk_add(rigid, bias);
        if (slides) { // released with the bias included, so its answer is to accelerations without it
            double slide =
                own->slide_by[i] - own->slide_turn[i] * alpha - yk_dot(yk_vec(own->slide_x[i], own->slide_y[i]), rigid);
            a = yk_add(a, yk_scale(slide, yk_vec(own->line_x[i], own->line_y[i])));
            distance_out[i] = slide;
        }
        if (turns) {
            double turn = own->turn_by[i] - yk_dot(yk_vec(own->turn_x[i], own->turn_y[i]), a);
            angle_out[i] = link->sense * (turn - alpha);
            alpha = turn;
        }
        own->a_x[i] = a.x, own->a_y[i] = a.y;
        own->alpha[i] = alpha;
    }
}

// --- accelerations

YK_INLINE void find_torques(const YkLinkLanes *lanes, size_t n)
{
    const YkLinkBlock *b = &lanes->block;
    for (size_t k = 0; k < lanes->input_count; k++) {
        YkLinkLoad load = lanes->load[k];
        const double *q = b->at_q[k], *v = b->at_v[k], *effort = b->effort[k];
        double *torque = b->torque[k];
        YK_EACH_LANE
        for (size_t i = 0; i < n; i++)
            torque[i] = (effort[i] + load.constant) - load.stiffness * q[i] - load.damping * v[i];
    }
}

YK_INLINE void place_all(YkLinkLanes *lanes, size_t n)
{
    const YkLinkBlock *b = &lanes->block;
    for (size_t k = 1; k < lanes->links->count; k++) {
        const YkTreeLink *link = &lanes->links->link[k];
        YkLinkFound *own = &lanes->found[k], *parent = &lanes->found[link->parent];
        if (link->angle != YK_NONE)
            turn(own, parent, b->at_q[link->angle], b->at_v[link->angle], link->sense, n);
        else
            keep_turn(own, parent, n);
        if (link->distance != YK_NONE)
            place(link, own, parent, link->line_is_own ? own : parent, b->at_q[link->distance], b->at_v[link->distance],
                  true, n);
        else
            place(link, own, parent, parent, NULL, NULL, false, n);
    }
}

YK_INLINE void release_all(YkLinkLanes *lanes, size_t n)
{
    YkLinkBlock *b = &lanes->block;
    for (size_t k = lanes->links->count - 1; k > 0; k--) {
        const YkTreeLink *link = &lanes->links->link[k];
        YkLinkFound *own = &lanes->found[k], *parent = &lanes->found[link->parent];
        if (link->distance == YK_NONE)
            inward(link, own, parent, b->torque[link->angle], NULL, true, false, b->ok, n);
        else if (link->angle == YK_NONE)
            inward(link, own, parent, NULL, b->torque[link->distance], false, true, b->ok, n);
        else
            inward(link, own, parent, b->torque[link->angle], b->torque[link->distance], true, true, b->ok, n);
    }
}

YK_INLINE void answer_all(YkLinkLanes *lanes, size_t n)
{
    const YkLinkBlock *b = &lanes->block;
    for (size_t k = 1; k < lanes->links->count; k++) {
        const YkTreeLink *link = &lanes->links->link[k];
        YkLinkFound *own = &lanes->found[k];
        const YkLinkFound *parent = &lanes->found[link->parent];
        if (link->distance == YK_NONE)
            outward(link, own, parent, b->a[link->angle], NULL, true, false, n);
        else if (link->angle == YK_NONE)
            outward(link, own, parent, NULL, b->a[link->distance], false, true, n);
        else
            outward(link, own, parent, b->a[link->angle], b->a[link->distance], true, true, n);
    }
}

// --- a step

// Adds a stage to the sums, and goes on to where the next one is evaluated: h times `node` from the step's start.
YK_INLINE void add_stage(YkLinkBlock *b, size_t inputs, double weight, double node, double h, bool is_first, size_t n)
{
    for (size_t k = 0; k < inputs; k++) {
        const double *q = b->q[k], *v = b->v[k], *a = b->a[k];
        double *at_q = b->at_q[k], *at_v = b->at_v[k], *sum_q = b->sum_q[k], *sum_v = b->sum_v[k];
        YK_EACH_LANE
        for (size_t i = 0; i < n; i++) {
            double rate = at_v[i];
            sum_q[i] = (is_first ? 0 : sum_q[i]) + weight * rate;
            sum_v[i] = (is_first ? 0 : sum_v[i]) + weight * a[i];
            at_q[i] = q[i] + node * h * rate;
            at_v[i] = v[i] + node * h * a[i];
        }
    }
}

YK_INLINE void accelerate(YkLinkLanes *lanes, size_t n)
{
    find_torques(lanes, n);
    place_all(lanes, n);
    release_all(lanes, n);
    answer_all(lanes, n);
}

YK_INLINE void begin(YkLinkBlock *b, size_t inputs, size_t n)
{
    for (size_t i = 0; i < n; i++) b->ok[i] = 1;
    for (size_t k = 0; k < inputs; k++)
        for (size_t i = 0; i < n; i++) {
            b->at_q[k][i] = b->q[k][i];
            b->at_v[k][i] = b->v[k][i];
        }
}

YK_INLINE void finish(YkLinkBlock *b, size_t inputs, double h, size_t n)
{
    for (size_t k = 0; k < inputs; k++) {
        double *q = b->q[k], *v = b->v[k], *ok = b->ok;
        const double *sum_q = b->sum_q[k], *sum_v = b->sum_v[k];
        YK_EACH_LANE
        for (size_t i = 0; i < n; i++) {
            q[i] += h * sum_q[i];
            v[i] += h * sum_v[i];
            double zero = (q[i] - q[i]) + (v[i] - v[i]);
            ok[i] = zero == 0 ? ok[i] : 0;
        }
    }
}

YK_INLINE void yk_lanes_links_step_body(YkLinkLanes *lanes, double h, size_t n)
{
    static const double weight[] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}, node[] = {0.5, 0.5, 1, 0};
    begin(&lanes->block, lanes->input_count, n);
    for (int stage = 0; stage < 4; stage++) {
        accelerate(lanes, n);
        add_stage(&lanes->block, lanes->input_count, weight[stage], node[stage], h, stage == 0, n);
    }
    finish(&lanes->block, lanes->input_count, h, n);
}
YK_KERNEL(yk_lanes_links_step, (YkLinkLanes * lanes, double h, size_t n), (lanes, h))
