// Dry friction of joints that slide. All reactions are affine in the frictions: each friction is a right side of the
// balance of all bodies, and a call finds those that agree with the reactions which they change.
//
// f_k = -s_k c_k |N_k(f)|, with s_k the sense of the sliding and c_k = mu R, as in dynamics/forces. A joint at rest
// that drives move begins to slip as they accelerate it; any other holds within an interval, which dynamics/holding
// finds.
#include "base/problems.h"
#include "program/balance.h"

static const double AT_REST = 1e-11; // of the fastest motion, as in dynamics/holding

static YkRef size_of(YkGraph *g, YkRef value)
{
    return yk_graph_unary(g, YK_VALUE_SIZE, value);
}

static YkRef scaled(YkGraph *g, double factor, YkRef value)
{
    return yk_graph_multiply(g, yk_graph_number(g, factor), value);
}

// Returns 1 for angles and the machine's size for distances.
static double scale_of(const YkProgram *p, bool is_distance)
{
    return is_distance ? yk_program_size(p) : 1;
}

// Returns the largest rate or acceleration of all coordinates, over their scales. inputs: those of the inputs.
static YkRef largest_of(YkProgram *p, const YkRates *rates, const YkRef *inputs)
{
    YkGraph *g = &p->graph;
    YkRef largest = yk_graph_number(g, 0);
    for (size_t k = 0; k < p->mech->coordinate_count; k++) {
        const YkTreeCoordinate *c = &p->mech->coordinates[k];
        YkRef rate = c->input == YK_NONE ? yk_program_coordinate_rate(p, k, rates) : inputs[c->input];
        YkRef size = scaled(g, 1 / scale_of(p, c->is_distance), size_of(g, rate));
        largest = yk_graph_binary(g, YK_VALUE_LARGEST, largest, size);
    }
    return largest;
}

// Returns whether its acceleration depends on free inputs: at rest it may then stick.
static bool may_stick(const YkForces *f, const YkDryJoint *dry, bool is_forward)
{
    bool may = false;
    for (size_t i = 0; i < f->program->mech->input_count && is_forward; i++)
        may = may || (f->is_free[i] && !yk_graph_is_number(&f->program->graph, dry->along[i], 0));
    return may;
}

// Returns the friction for 1 N in the joint: against a rate.
static YkRef against(YkGraph *g, YkRef rate, YkRef limit)
{
    return yk_graph_choose(g, rate, limit, yk_graph_minus(g, limit));
}

typedef struct Scales { // rates and accelerations that count as 0
    YkRef rate, acceleration;
} Scales;

static Scales find_scales(YkBalanceSystem *w, const YkRef *accelerations)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    YkRef *rates = YK_NEW(p->arena, YkRef, p->mech->input_count + 1);
    if (!rates) {
        p->failed = true;
        return (Scales){0, 0};
    }
    for (size_t i = 0; i < p->mech->input_count; i++) rates[i] = p->input[i].velocity;
    YkRef fastest = largest_of(p, &w->velocities, rates), hardest = largest_of(p, &w->accelerations, accelerations);
    hardest = yk_graph_binary(g, YK_VALUE_LARGEST, hardest, yk_graph_multiply(g, fastest, fastest));
    Scales none = {.rate = scaled(g, AT_REST, fastest)};
    none.acceleration = scaled(g, AT_REST, hardest);
    return none;
}

// Returns a joint's friction for 1 N in it; 0 if it is at rest. Notes in w->f->dry_result.moves whether none is.
static YkRef sliding(YkBalanceSystem *w, const YkDryJoint *dry, const Scales *none, bool is_forward)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    double scale = scale_of(p, dry->slides);
    YkRef rate = yk_program_joint_rate(p, dry->joint, dry->slides, &w->velocities);
    YkRef least = scaled(g, scale, none->rate);
    YkRef slow = yk_graph_subtract(g, least, size_of(g, rate)); // below 0: it slides
    YkRef begins = yk_graph_number(g, 0), moves = yk_graph_minus(g, slow), *all = &w->f->dry_result.moves;
    if (!may_stick(w->f, dry, is_forward)) {
        YkRef change = yk_program_joint_rate(p, dry->joint, dry->slides, &w->accelerations);
        least = scaled(g, scale, none->acceleration);
        YkRef steady = yk_graph_subtract(g, least, size_of(g, change));
        begins = yk_graph_choose(g, steady, against(g, change, dry->limit), begins);
        moves = yk_graph_binary(g, YK_VALUE_LARGEST, moves, yk_graph_minus(g, steady));
    }
    YkRef has_none = yk_graph_minus(g, dry->limit);
    moves = yk_graph_choose(g, has_none, moves, yk_graph_number(g, 1)); // without friction it may rest
    *all = *all == YK_NONE ? moves : yk_graph_binary(g, YK_VALUE_LEAST, *all, moves);
    return yk_graph_choose(g, slow, against(g, rate, dry->limit), begins);
}

// --- the call

// Returns the force in a joint on a right side: its two components, or its one.
static YkRefVec bearing(const YkBalanceSystem *w, int32_t joint, size_t side)
{
    YkRef zero = yk_graph_number(&w->f->program->graph, 0), parts[2] = {zero, zero};
    for (size_t c = 0, found = 0; c < w->count && found < 2; c++) {
        const YkUnknown *u = &w->columns[c];
        if (u->relation == YK_NONE && u->joint == joint && u->input == YK_NONE && !u->is_couple)
            parts[found++] = w->solution[c * w->sides + side];
    }
    return (YkRefVec){parts[0], parts[1]};
}

// Writes a row of the call: how large the force is that joint `dry`, or the teeth of an unknown, bear.
static void write_row(YkBalanceSystem *w, YkRef *row, YkRef factor, const YkDryJoint *dry, size_t unknown)
{
    YkGraph *g = &w->f->program->graph;
    YkRef zero = yk_graph_number(g, 0);
    *row++ = factor;
    for (size_t side = 0; side < w->sides; side++) {
        bool is_radial = side > 0 && side < w->first_dry;
        YkRefVec v = {w->solution[unknown * w->sides + side], zero};
        if (dry) v = bearing(w, dry->joint, side);
        if (!dry && is_radial) v.x = zero; // the forces along the line of centres do not load the teeth
        if (is_radial) v = yk_graph_vec_scale(g, yk_graph_number(g, -1), v);
        *row++ = v.x;
        *row++ = v.y;
    }
}

// Finds the frictions, and the forces of teeth with them: w->factor of all right sides.
static bool settle(YkBalanceSystem *w, const YkRef *sliding_of)
{
    YkProgram *p = w->f->program;
    YkGraph *g = &p->graph;
    size_t n = w->sides - 1, radials = w->first_dry - 1, width = 1 + 2 * w->sides;
    YkRef *rows = YK_NEW(p->arena, YkRef, n * width + 1);
    w->factor = YK_NEW(p->arena, YkRef, w->sides);
    if (!rows || !w->factor) return false;
    for (size_t c = 0; c < w->count; c++)
        if (w->columns[c].radial > 0)
            write_row(w, rows + (w->columns[c].radial - 1) * width, yk_graph_number(g, 1), NULL, c);
    for (size_t k = 0; k < w->dry_count; k++)
        write_row(w, rows + (radials + k) * width, sliding_of[k], &w->f->dry[k], 0);
    int32_t call = yk_graph_call(g, (YkCall){.kind = YK_CALL_FRICTION,
                                             .n = (int32_t)n,
                                             .m = (int32_t)radials,
                                             .arguments = rows,
                                             .argument_count = n * width,
                                             .result_count = n * width + 2 * n + 1,
                                             .name = "dry"});
    w->factor[0] = yk_graph_number(g, 1);
    for (size_t k = 0; k < n; k++) {
        w->factor[1 + k] = yk_graph_result(g, call, n * width + k);
        if (k < radials) w->factor[1 + k] = yk_graph_minus(g, w->factor[1 + k]);
    }
    w->f->dry_result.settled = yk_graph_result(g, call, n * width + 2 * n);
    return true;
}

// --- inverse and forward dynamics

static bool refuse(YkForces *f)
{
    YkProgram *p = f->program;
    const YkJoint *joint = &p->model->joints[f->dry[0].joint];
    yk_problem(p->problems, YK_CODE_NOT_PRINTABLE, joint->friction.place,
               "joint %q has dry friction, which follows from its reaction, but the reactions are not printed: %s",
               joint->name, f->why_no_reactions);
    yk_problem_hint(p->problems, "`--kinematics` prints the motion alone; `yoke simulate` computes with it");
    p->failed = true;
    return false;
}

// Solves the balance for these accelerations of the inputs. Returns the frictions in w->factor.
static bool balance(YkBalanceSystem *w, YkForces *f, const YkRates *r, const YkRates *s, const YkRef *accelerations,
                    bool is_forward)
{
    YkProgram *p = f->program;
    YkRef *sliding_of = YK_NEW(p->arena, YkRef, f->dry_count + 1);
    if (!sliding_of) {
        p->failed = true;
        return false;
    }
    f->takes_least = f->balances_dry = true;
    bool made = yk_balance_make(w, f, r, s, yk_program_size(p)), solved = made && yk_balance_solve(w);
    f->balances_dry = false;
    if (made && !solved && !w->ran_out)
        f->why_no_reactions = "constraints repeat others, so that they are not determined";
    if (!solved && f->why_no_reactions && !p->graph.failed && !yk_arena_failed(p->arena)) return refuse(f);
    f->dry_result = (YkDryResult){.moves = YK_NONE, .settled = YK_NONE, .determinant = f->determinant};
    yk_graph_section(&p->graph, "Dry friction, against the sliding: it agrees with the reactions that it changes.");
    Scales none = find_scales(w, accelerations);
    for (size_t k = 0; k < f->dry_count && solved && !p->failed; k++)
        sliding_of[k] = sliding(w, &f->dry[k], &none, is_forward);
    if (!solved || p->failed || !settle(w, sliding_of)) p->failed = true;
    return !p->failed;
}

static bool find_inverse(YkForces *f, const YkRates *r, const YkRates *s)
{
    YkProgram *p = f->program;
    YkGraph *g = &p->graph;
    YkBalanceSystem w;
    YkRef *accelerations = YK_NEW(p->arena, YkRef, p->mech->input_count + 1);
    for (size_t i = 0; accelerations && i < p->mech->input_count; i++) accelerations[i] = p->input[i].acceleration;
    if (!accelerations || !balance(&w, f, r, s, accelerations, false) || !yk_balance_read(&w)) return false;
    for (size_t i = 0; i < p->mech->input_count; i++)
        for (size_t k = 0; k < f->dry_count; k++) {
            YkRef part = yk_graph_multiply(g, w.factor[w.first_dry + k], f->dry[k].along[i]);
            f->effort[i] = yk_graph_subtract(g, f->effort[i], part);
        }
    f->dry_inverse = f->dry_result;
    return true;
}

static bool find_forward(YkForces *f)
{
    YkProgram *p = f->program;
    YkGraph *g = &p->graph;
    YkBalanceSystem w;
    for (size_t k = 0; k < f->dry_count; k++)
        if (!(f->dry[k].response = yk_forces_response(f, f->dry[k].along))) return false;
    YkRates accelerations = yk_program_accelerations(p, &f->velocities, f->acceleration);
    YkRef *reaction = f->reaction;
    if (p->failed || !balance(&w, f, &f->velocities, &accelerations, f->acceleration, true)) return false;
    f->reaction = reaction;
    for (size_t i = 0; i < p->mech->input_count; i++)
        for (size_t k = 0; k < f->dry_count && f->is_free[i]; k++) {
            YkRef part = yk_graph_multiply(g, w.factor[w.first_dry + k], f->dry[k].response[i]);
            f->acceleration[i] = yk_graph_add(g, f->acceleration[i], part);
        }
    f->dry_forward = f->dry_result;
    return true;
}

bool yk_forces_dry(YkForces *f, const YkRates *r, const YkRates *s)
{
    YkProgram *p = f->program;
    for (size_t k = 0; k < f->dry_count; k++) {
        YkDryJoint *dry = &f->dry[k];
        dry->along = YK_NEW(p->arena, YkRef, p->mech->input_count + 1);
        for (size_t i = 0; dry->along && i < p->mech->input_count; i++)
            dry->along[i] = yk_program_joint_rate(p, dry->joint, dry->slides, &f->column[i]);
        p->failed |= !dry->along;
    }
    if (p->failed) return false;
    bool good = find_inverse(f, r, s);
    YkRef determinant = f->determinant;
    good = good && (f->free_count == 0 || find_forward(f));
    f->determinant = determinant; // of the inverse problem, to which the reactions belong
    p->failed |= !good;
    return good;
}
