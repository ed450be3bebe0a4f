// Runs forward dynamics of open trees of pins in SIMD lanes.
#include "study/tree_batch.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "equations/short_chain.h"
#include "expr/formula.h"
#include "solve/kernels/kernels.h"
#include "solve/state.h"

enum { LANES = YK_FORMULA_LANES };

// Rows of a link: the kernel's, and for a rod its vector from end to end.
enum { ROD_X = YK_GIVEN_COUNT, ROD_Y, ROW_COUNT };

// A row that follows the parameters: lanes = sum of sign * value over up to two values of the model.
typedef struct Part {
    const YkFormula *formula; // NULL: constant
    int32_t variable;         // the variable that the formula is, or YK_NONE
    double constant, sign;
} Part;
typedef struct Given {
    int32_t link, row;
    Part part[2];
    size_t parts;
    bool is_constant; // filled once
    int32_t variable; // a parameter with a sign, read where it stands; or YK_NONE
} Given;

typedef struct Link {
    double *row[ROW_COUNT]; // of its own
    int32_t input;
    bool is_rod;
} Link;

struct YkTreeBatch {
    YkArena *arena;
    YkVariant *variant;
    size_t parameter_count, link_count, input_count;
    bool is_chain;    // a short one
    YkAxis axis;      // of its links
    double side;      // see YkTreeLanes
    Link *link;       // parents before children
    YkTreeRows *rows; // of the links, as the kernel reads them
    YkTreeFound *found;
    Given *given;
    size_t given_count;
    const YkFormula **effort; // [input], NULL: none
    const double **variable;  // [parameter of the model]
    const double **checked;   // parameters and what is derived from them
    size_t checked_count;
    double *gravity[2], *none; // none: of no torque
    Part gravity_part[2];
    double *scratch, *ok, *own; // own: [3 * input][LANES] constants for NULL arrays
    double **derived;           // rows of derived parameters
    double **chosen;            // rows of parameters that a case omits
};

// --- does it fit?

static bool is_pinned_tree(const YkMechanism *mech)
{
    const YkModel *model = mech->model;
    bool fits = mech->loop_count == 0 && mech->input_count == mech->coordinate_count && model->drive_count == 0 &&
                model->force_count == 0 && model->spring_count == 0 && model->stop_count == 0 &&
                mech->relation_count == 0;
    for (size_t j = 0; fits && j < model->joint_count; j++)
        fits = model->joints[j].kind == YK_PIN && !model->joints[j].has_friction;
    bool has_mass = false;
    for (size_t b = 1; b < model->body_count; b++) has_mass = has_mass || model->bodies[b].has_mass;
    return fits && has_mass;
}

// --- what follows what

static Part part_of(const YkTreeBatch *b, const double *value, double sign)
{
    Part part = {yk_redesign_formula(b->variant->redesign, value), YK_NONE, *value, sign};
    double own = 1;
    if (part.formula) part.variable = yk_formula_variable(part.formula, &own);
    if (part.variable != YK_NONE) part.sign *= own;
    return part;
}

static void give(YkTreeBatch *b, int32_t link, int32_t row, const double *first, const double *second)
{
    Given *g = &b->given[b->given_count++];
    const double *value[] = {first, second};
    *g = (Given){.link = link, .row = row, .is_constant = true, .variable = YK_NONE};
    for (int k = 0; k < 2; k++) {
        if (!value[k]) continue;
        Part part = part_of(b, value[k], k ? -1 : 1);
        if (!part.formula && part.constant == 0) continue;
        g->part[g->parts++] = part;
        g->is_constant &= !part.formula;
    }
    for (size_t k = 0, p; g->is_constant && k < LANES; k++)
        for (p = 0; p < g->parts; p++) b->link[link].row[row][k] += g->part[p].sign * g->part[p].constant;
    bool is_one = g->parts == 1 && !b->link[link].is_rod; // of a rod: see finish_rod
    if (!is_one || (row >= YK_GIVEN_MASS && g->part[0].sign < 0)) return;
    g->variable = g->part[0].variable;
    if (row < YK_GIVEN_MASS && g->variable != YK_NONE) b->rows[link].sign[row] = g->part[0].sign;
}

// Returns the coordinates of a joint's point on one of its sides; NULL: an origin.
static const YkVec *point_of(const YkModel *model, const YkJoint *joint, int side)
{
    return joint->point[side] == YK_NONE ? NULL : &model->points[joint->point[side]].at;
}

// Makes the rows of a link: its pin on the parent, relative to the parent's own pin; its centre, relative to its pin.
static void give_link(YkTreeBatch *b, int32_t k, int32_t body, const int32_t *link_of_body)
{
    const YkMechanism *mech = b->variant->mech;
    const YkModel *model = mech->model;
    const YkBody *own = &model->bodies[body];
    int32_t j = mech->tree.joint[body], parent = mech->tree.parent[body];
    const YkJoint *joint = &model->joints[j];
    int side = joint->body[0] == body ? 0 : 1;
    const YkVec *here = point_of(model, joint, side), *there = point_of(model, joint, 1 - side), *before = NULL;
    if (parent != 0) {
        const YkJoint *up = &model->joints[mech->tree.joint[parent]];
        before = point_of(model, up, up->body[0] == parent ? 0 : 1);
    }
    bool is_rod = own->rod[0] != YK_NONE && own->rod[1] != YK_NONE;
    int32_t input = mech->coordinates[yk_tree_coordinate(mech, j, false)].input;
    b->link[k].input = input;
    b->link[k].is_rod = is_rod;
    b->rows[k] = (YkTreeRows){.parent = parent == 0 ? -1 : link_of_body[parent],
                              .sense = side == 0 ? -1 : 1,
                              .has_mass = own->mass_expr != NULL};
    for (int r = 0; r < YK_GIVEN_COUNT; r++) b->rows[k].given[r] = b->link[k].row[r];
    for (int r = 0; r < YK_GIVEN_MASS; r++) b->rows[k].sign[r] = 1;
    give(b, k, YK_GIVEN_AT_X, there ? &there->x : NULL, before ? &before->x : NULL);
    give(b, k, YK_GIVEN_AT_Y, there ? &there->y : NULL, before ? &before->y : NULL);
    give(b, k, YK_GIVEN_MASS, &own->mass, NULL);
    if (is_rod) { // see finish_rod
        const YkVec *p = &model->points[own->rod[0]].at, *q = &model->points[own->rod[1]].at;
        give(b, k, ROD_X, &q->x, &p->x);
        give(b, k, ROD_Y, &q->y, &p->y);
        give(b, k, YK_GIVEN_CENTER_X, &p->x, here ? &here->x : NULL);
        give(b, k, YK_GIVEN_CENTER_Y, &p->y, here ? &here->y : NULL);
    } else {
        give(b, k, YK_GIVEN_CENTER_X, &own->center.x, here ? &here->x : NULL);
        give(b, k, YK_GIVEN_CENTER_Y, &own->center.y, here ? &here->y : NULL);
        give(b, k, YK_GIVEN_INERTIA, &own->inertia, NULL);
    }
}

static void find_constant(const Part *part, double *row)
{
    for (size_t k = 0; k < LANES; k++) row[k] = part->sign * part->constant;
}

// Finds out whether the vectors of all links of a short chain lie along one axis of theirs.
static YkAxis axis_of(const YkTreeBatch *b)
{
    bool has[2] = {false, false};
    for (size_t k = 0; k < b->given_count; k++) {
        int32_t row = b->given[k].row;
        bool is_x = row == YK_GIVEN_AT_X || row == YK_GIVEN_CENTER_X || row == ROD_X;
        bool is_y = row == YK_GIVEN_AT_Y || row == YK_GIVEN_CENTER_Y || row == ROD_Y;
        bool counts = b->given[k].parts > 0 && (b->given[k].link > 0 || (row != YK_GIVEN_AT_X && row != YK_GIVEN_AT_Y));
        has[0] |= is_x && counts;
        has[1] |= is_y && counts;
    }
    return !has[1] ? YK_AXIS_X : !has[0] ? YK_AXIS_Y : YK_AXIS_NONE;
}

// Returns YkTreeLanes.side, after all else is given.
static double side_of(const YkTreeBatch *b)
{
    int32_t along = b->axis == YK_AXIS_Y ? 1 : 0;
    double side = b->rows[0].sign[YK_GIVEN_CENTER_X + along];
    const Part *gravity = &b->gravity_part[0];
    bool is_plain = b->is_chain && b->link_count == 2 && b->axis != YK_AXIS_NONE;
    is_plain = is_plain && !gravity->formula && gravity->constant == 0;
    for (size_t k = 0; is_plain && k < 2; k++) is_plain = b->rows[k].sense == 1;
    is_plain = is_plain && b->rows[1].sign[YK_GIVEN_CENTER_X + along] == side &&
               b->rows[1].sign[YK_GIVEN_AT_X + along] == side;
    return is_plain ? side : 0;
}

static bool give_all(YkTreeBatch *b)
{
    const YkMechanism *mech = b->variant->mech;
    size_t bodies = mech->model->body_count;
    int32_t *link_of_body = YK_NEW(b->arena, int32_t, bodies);
    if (!link_of_body) return false;
    for (size_t k = 0; k < bodies; k++) {
        int32_t body = mech->tree_order[k];
        if (body == 0) continue;
        link_of_body[body] = (int32_t)b->link_count;
        give_link(b, (int32_t)b->link_count++, body, link_of_body);
    }
    for (size_t k = b->link_count; k-- > 0;) { // looked at from the last to the first
        YkTreeRows *rows = &b->rows[k];
        if (rows->parent < 0) continue;
        rows->is_first = !b->rows[rows->parent].has_children;
        b->rows[rows->parent].has_children = true;
    }
    b->is_chain = b->link_count <= YK_CHAIN_MOST;
    for (size_t k = 0; k < b->link_count; k++) b->is_chain &= b->rows[k].parent == (int32_t)k - 1;
    b->axis = axis_of(b);
    b->gravity_part[0] = part_of(b, &mech->model->gravity.x, 1);
    b->gravity_part[1] = part_of(b, &mech->model->gravity.y, 1);
    for (int c = 0; c < 2; c++) find_constant(&b->gravity_part[c], b->gravity[c]);
    b->side = side_of(b);
    return true;
}

// Makes the efforts, which depend only on parameters. Returns false if one needs more.
static bool give_efforts(YkTreeBatch *b)
{
    const YkMechanism *mech = b->variant->mech;
    const YkModel *model = mech->model;
    for (size_t k = 0; k < model->effort_count; k++) {
        const YkEffort *effort = &model->efforts[k];
        const YkCoordinate *c = &model->coordinates[effort->coordinate];
        int32_t q = yk_tree_coordinate(mech, c->joint, false);
        if (effort->strength.law != YK_NONE || !effort->strength.expr || q == YK_NONE) return false;
        const YkFormula *formula = yk_redesign_compile(b->variant->redesign, effort->strength.expr);
        if (!formula) return false;
        b->effort[mech->coordinates[q].input] = formula;
    }
    return true;
}

// --- making

static double *row_of(YkTreeBatch *b)
{
    return yk_arena_alloc(b->arena, LANES, sizeof(double));
}

static bool allocate(YkTreeBatch *b, const YkState *state)
{
    const YkModel *model = b->variant->mech->model;
    size_t bodies = model->body_count, inputs = b->input_count, parameters = model->parameter_count;
    b->link = YK_NEW(b->arena, Link, bodies);
    b->given = YK_NEW(b->arena, Given, 8 * bodies);
    b->rows = YK_NEW(b->arena, YkTreeRows, bodies);
    b->found = yk_arena_alloc(b->arena, bodies, sizeof(YkTreeFound));
    b->effort = YK_NEW(b->arena, const YkFormula *, inputs + 1);
    b->variable = YK_NEW(b->arena, const double *, parameters + 1);
    b->derived = YK_NEW(b->arena, double *, parameters + 1);
    b->chosen = YK_NEW(b->arena, double *, parameters + 1);
    b->checked = YK_NEW(b->arena, const double *, parameters + 1);
    b->scratch = YK_NEW(b->arena, double, YK_FORMULA_SCRATCH);
    b->ok = row_of(b);
    b->gravity[0] = row_of(b);
    b->gravity[1] = row_of(b);
    b->none = row_of(b);
    b->own = YK_NEW(b->arena, double, 3 * (inputs + 1) * LANES);
    for (size_t k = 0; b->derived && b->chosen && k <= parameters; k++)
        b->derived[k] = row_of(b), b->chosen[k] = row_of(b);
    for (size_t k = 0; b->link && k < bodies; k++)
        for (int r = 0; r < ROW_COUNT; r++) b->link[k].row[r] = row_of(b);
    if (yk_arena_failed(b->arena)) return false;
    for (size_t k = 0; k < LANES; k++) b->ok[k] = 1; // and again after each block
    for (size_t i = 0; i < inputs; i++)
        for (size_t k = 0; k < LANES; k++) {
            b->own[(3 * i) * LANES + k] = state->input[3 * i];
            b->own[(3 * i + 1) * LANES + k] = state->input[3 * i + 1];
        }
    return true;
}

YkTreeBatch *yk_tree_batch_new(YkVariant *variant, const YkState *state, size_t parameter_count, bool *fits)
{
    *fits = is_pinned_tree(variant->mech);
    YkTreeBatch *b = *fits ? calloc(1, sizeof *b) : NULL;
    if (!b) return NULL;
    b->arena = yk_arena_new();
    b->variant = variant;
    b->parameter_count = parameter_count;
    b->input_count = variant->mech->input_count;
    bool good = b->arena && allocate(b, state) && give_all(b);
    if (good && !give_efforts(b)) {
        good = false;
        *fits = yk_redesign_ran_out(variant->redesign); // otherwise an effort needs more than parameters
    }
    if (good && !yk_arena_failed(b->arena)) return b;
    yk_tree_batch_free(b);
    return NULL;
}

void yk_tree_batch_free(YkTreeBatch *b)
{
    if (!b) return;
    yk_arena_free(b->arena);
    free(b);
}

// --- a block of lanes

static void find_part(YkTreeBatch *b, const Part *part, bool adds, double *row, size_t n)
{
    double constant = part->sign * part->constant;
    if (part->variable != YK_NONE)
        yk_lanes_tree_part(row, b->variable[part->variable], part->sign, adds, n);
    else if (part->formula)
        yk_lanes_tree_part(row, yk_formula_lanes(part->formula, b->variable, b->scratch, n), part->sign, adds, n);
    else
        for (size_t i = 0; i < n; i++) row[i] = adds ? row[i] + constant : constant;
}

static void set_variable(YkTreeBatch *b, int32_t index, const double *row)
{
    b->variable[index] = row;
    b->checked[b->checked_count++] = row;
}

static void find_parameters(YkTreeBatch *b, const YkMotionCase *asked, size_t from, size_t n)
{
    const YkRedesign *redesign = b->variant->redesign;
    const YkFormula *formula = NULL;
    b->checked_count = 0;
    for (size_t p = 0; p < b->parameter_count; p++) {
        int32_t index = yk_redesign_parameter(redesign, p);
        bool is_asked = asked->parameters && asked->parameters[p];
        for (size_t i = 0; !is_asked && i < n; i++) b->chosen[p][i] = yk_redesign_value(redesign, p);
        set_variable(b, index, is_asked ? asked->parameters[p] + from : b->chosen[p]);
    }
    for (size_t k = 0;; k++) {
        int32_t index = yk_redesign_derived(redesign, k, &formula);
        if (index == YK_NONE) return;
        const double *value = yk_formula_lanes(formula, b->variable, b->scratch, n);
        memcpy(b->derived[k], value, n * sizeof *value);
        set_variable(b, index, b->derived[k]);
    }
}

// Finishes a uniform rod: its centre is half way, its inertia is m L^2 / 12.
static void finish_rod(const Link *link, double *ok, size_t n)
{
    const double *x = link->row[ROD_X], *y = link->row[ROD_Y], *mass = link->row[YK_GIVEN_MASS];
    for (size_t i = 0; i < n; i++) {
        double square = x[i] * x[i] + y[i] * y[i];
        link->row[YK_GIVEN_CENTER_X][i] += 0.5 * x[i];
        link->row[YK_GIVEN_CENTER_Y][i] += 0.5 * y[i];
        link->row[YK_GIVEN_INERTIA][i] = mass[i] * square / 12;
        ok[i] = square > 0 ? ok[i] : -1;
    }
}

static void find_row(YkTreeBatch *b, const Given *g, size_t n)
{
    double *row = b->link[g->link].row[g->row];
    if (g->variable != YK_NONE) {
        b->rows[g->link].given[g->row] = b->variable[g->variable];
        return;
    }
    if (g->parts == 0) memset(row, 0, n * sizeof *row);
    for (size_t p = 0; p < g->parts; p++) find_part(b, &g->part[p], p > 0, row, n);
}

static void find_links(YkTreeBatch *b, size_t n)
{
    for (size_t k = 0; k < b->given_count; k++)
        if (!b->given[k].is_constant || b->link[b->given[k].link].is_rod) find_row(b, &b->given[k], n);
    for (size_t k = 0; k < b->link_count; k++)
        if (b->link[k].is_rod) finish_rod(&b->link[k], b->ok, n);
    for (int c = 0; c < 2; c++)
        if (b->gravity_part[c].formula) find_part(b, &b->gravity_part[c], false, b->gravity[c], n);
}

// Returns the torque along an input: the case's, or the file's.
static const double *torque_of(YkTreeBatch *b, const YkMotionCase *asked, size_t i, size_t from, size_t n)
{
    double *own = b->own + (3 * i + 2) * LANES;
    if (asked->efforts) return asked->efforts[i] ? asked->efforts[i] + from : b->none;
    if (!b->effort[i]) return b->none;
    memcpy(own, yk_formula_lanes(b->effort[i], b->variable, b->scratch, n), n * sizeof *own);
    return own;
}

static void point_links(YkTreeBatch *b, const YkMotionCase *asked, double *const *accelerations, size_t from, size_t n)
{
    for (size_t k = 0; k < b->link_count; k++) { // every link has an input of its own
        size_t i = (size_t)b->link[k].input;
        const double *own = b->own + 3 * i * LANES;
        b->rows[k].q = asked->positions && asked->positions[i] ? asked->positions[i] + from : own;
        b->rows[k].v = asked->rates && asked->rates[i] ? asked->rates[i] + from : own + LANES;
        b->rows[k].torque = torque_of(b, asked, i, from, n);
        b->rows[k].a = accelerations[i] + from;
    }
}

static YkStatus run_block(YkTreeBatch *b, size_t from, size_t n, signed char *status)
{
    YkTreeLanes tree = {b->rows,    b->found,         b->link_count, {b->gravity[0], b->gravity[1]},
                        b->checked, b->checked_count, b->axis,       b->side};
    bool well;
    (b->is_chain ? yk_lanes_chain : yk_lanes_tree)(&well, &tree, b->ok, n);
    if (well) {
        if (status) memset(status + from, YK_OK, n);
        return YK_OK;
    }
    YkStatus worst = YK_OK;
    for (size_t k = 0; k < n; k++) {
        YkStatus one = b->ok[k] > 0 ? YK_OK : b->ok[k] < 0 ? YK_BAD_MODEL : YK_SINGULAR;
        b->ok[k] = 1;
        if (status) status[from + k] = (signed char)one;
        if (one < 0 || (worst == YK_OK && one > 0)) worst = one;
    }
    return worst;
}

YkStatus yk_tree_batch_run(YkTreeBatch *b, const YkMotionCase *asked, size_t from, size_t to,
                           double *const *accelerations, signed char *status)
{
    YkStatus worst = YK_OK;
    for (size_t at = from; at < to; at += LANES) {
        size_t n = to - at < LANES ? to - at : LANES;
        find_parameters(b, asked, at, n);
        find_links(b, n);
        point_links(b, asked, accelerations, at, n);
        YkStatus here = run_block(b, at, n, status);
        if (here < 0 || (worst == YK_OK && here > 0)) worst = here;
    }
    return worst;
}
