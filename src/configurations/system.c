// Reads a group as a polynomial system, and evaluates it.
#include "configurations/system.h"
#include <string.h>
#include "num/complex.h"

// --- reading

static int32_t root_of(const YkMechanism *mech, int32_t slot)
{
    return slot == 0 ? 0 : mech->group_root[slot];
}

static int find(const YkMechanism *mech, const YkShape *shape, const YkBlock *block, bool is_distance, int32_t index)
{
    for (size_t k = 0; k < shape->unknowns; k++) {
        YkColumn c = mech->group_columns[block->first_column + shape->column[k]];
        if (c.is_distance == is_distance && c.index == index) return (int)k;
    }
    return -1;
}

// Notes which line each unknown slide follows. Returns false if one follows several.
static bool read_lines(YkShape *shape, const YkMechanism *mech, const YkBlock *block)
{
    int32_t slot[2 * YK_SYSTEM_LOOPS_MAX];
    for (size_t k = 0; k < shape->unknowns; k++) {
        slot[k] = YK_NONE;
        shape->turning[k] = -1;
    }
    for (size_t l = 0; l < block->loop_count; l++) {
        const YkSum *sum = &mech->group_loops[block->first_loop + l];
        for (uint32_t k = 0; k < sum->count; k++) {
            YkTerm t = mech->terms[sum->first + k];
            int unknown = t.distance == YK_NONE ? -1 : find(mech, shape, block, true, t.distance);
            if (unknown < 0) continue;
            if (slot[unknown] != YK_NONE && slot[unknown] != t.slot) return false;
            slot[unknown] = t.slot;
            shape->turning[unknown] = find(mech, shape, block, false, root_of(mech, t.slot));
        }
    }
    return true;
}

bool yk_shape_read_columns(YkShape *shape, const YkMechanism *mech, size_t index)
{
    const YkBlock *block = &mech->blocks[index];
    size_t count = 0;
    *shape = (YkShape){.loops = block->loop_count, .unknowns = block->column_count};
    if (shape->unknowns > 2 * YK_SYSTEM_LOOPS_MAX) return false;
    for (int slides = 0; slides < 2; slides++) {
        for (size_t k = 0; k < shape->unknowns; k++)
            if (mech->group_columns[block->first_column + k].is_distance == (slides == 1)) shape->column[count++] = k;
        if (slides == 0) shape->angles = count;
    }
    return read_lines(shape, mech, block);
}

YkOutside yk_shape_read(YkShape *shape, const YkMechanism *mech, size_t index)
{
    const YkBlock *block = &mech->blocks[index];
    *shape = (YkShape){.loops = block->loop_count, .unknowns = block->column_count};
    if (block->relation_count > 0) return YK_OUTSIDE_RELATIONS;
    if (shape->unknowns != 2 * shape->loops) return YK_OUTSIDE_REDUNDANT;
    if (shape->loops > YK_SYSTEM_LOOPS_MAX) return YK_OUTSIDE_LARGE;
    return yk_shape_read_columns(shape, mech, index) ? YK_OUTSIDE_NOT : YK_OUTSIDE_LINES;
}

// Returns the known unit vector of a slot; of one that turns with an unknown, relative to it.
static YkVec known_turn(const YkRun *run, int32_t slot, bool is_unknown)
{
    int32_t from = is_unknown ? run->mech->relative_slot[slot] : slot;
    if (from == 0) return yk_vec(1, 0);
    YkTurn t = yk_space_turn(run->space, from);
    return yk_vec(t.c[0], t.s[0]);
}

static YkVec node_at(const YkRun *run, int32_t node)
{
    if (node == YK_NONE) return yk_vec(0, 0);
    YkPlane p = yk_space_plane(run->space, node);
    return yk_vec(p.x[0], p.y[0]);
}

static void read_loop(const YkShape *shape, const YkRun *run, const YkBlock *block, const YkSum *sum, YkVec *row)
{
    const YkMechanism *mech = run->mech;
    double per_size = 1 / mech->size;
    YkVec known = yk_add(sum->constant, yk_sub(node_at(run, sum->plus), node_at(run, sum->minus)));
    row[shape->unknowns] = yk_scale(per_size, known);
    for (uint32_t k = 0; k < sum->count; k++) {
        YkTerm t = mech->terms[sum->first + k];
        int angle = find(mech, shape, block, false, root_of(mech, t.slot));
        int slide = t.distance == YK_NONE ? -1 : find(mech, shape, block, true, t.distance);
        YkVec v = yk_mul(known_turn(run, t.slot, angle >= 0), t.v);
        // An unknown distance counts sizes, so its direction has no length.
        if (slide < 0)
            v = yk_scale(per_size * (t.distance == YK_NONE ? 1 : yk_space_slide(run->space, t.distance).d[0]), v);
        size_t column = slide >= 0 ? (size_t)slide : angle >= 0 ? (size_t)angle : shape->unknowns;
        row[column] = yk_add(row[column], v);
    }
}

void yk_coefficients_read(const YkShape *shape, const YkRun *run, size_t index, YkVec *coefficients)
{
    const YkBlock *block = &run->mech->blocks[index];
    size_t width = shape->unknowns + 1, count = yk_coefficient_count(shape);
    memset(coefficients, 0, 2 * count * sizeof *coefficients);
    for (size_t l = 0; l < shape->loops; l++)
        read_loop(shape, run, block, &run->mech->group_loops[block->first_loop + l], coefficients + l * width);
    for (size_t k = 0; k < count; k++) coefficients[count + k] = yk_conj(coefficients[k]);
}

// --- evaluating

// Evaluates one row: a loop (inverse: false), or a conjugate, whose monomials have w = 1/z in place of z.
static YkVec evaluate_row(const YkShape *shape, const YkVec *A, const YkVec *x, const YkVec *w, bool inverse, YkVec *J)
{
    size_t n = shape->unknowns;
    const YkVec *z = inverse ? w : x;
    YkVec sum = A[n];
    for (size_t k = 0; k < n; k++) {
        int turning = shape->turning[k];
        YkVec monomial = k < shape->angles ? z[k] : turning < 0 ? x[k] : yk_mul(x[k], z[turning]);
        sum = yk_add_product(sum, A[k], monomial);
        if (!J) continue;
        J[k] = k < shape->angles || turning < 0 ? A[k] : yk_mul(A[k], z[turning]);
        if (turning >= 0) J[turning] = yk_add_product(J[turning], A[k], x[k]);
    }
    for (size_t k = 0; J && inverse && k < shape->angles; k++)
        J[k] = yk_scale(-1, yk_mul(J[k], yk_mul(w[k], w[k]))); // d(1/z) = -dz / z^2
    return sum;
}

double yk_unknown_size(const YkShape *shape, const YkVec *x, size_t unknown)
{
    double size = yk_sum_norm(x[unknown]);
    return unknown >= shape->angles ? fmax(1, size) : shape->relations > 0 ? 1 : size;
}

// Evaluates a loop in real unknowns, in x and in y.
static void evaluate_parts(const YkShape *shape, const YkVec *A, const YkVec *x, YkVec *F, YkVec *J)
{
    size_t n = shape->unknowns;
    YkVec sum = A[n], slope[2 * YK_SYSTEM_LOOPS_MAX] = {{0, 0}};
    for (size_t k = 0; k < n; k++) {
        int turning = shape->turning[k];
        bool is_angle = k < shape->angles;
        YkVec along = is_angle || turning >= 0 ? yk_mul(A[k], yk_unit(x[is_angle ? k : (size_t)turning].x)) : A[k];
        YkVec term = is_angle ? along : yk_scale(x[k].x, along);
        sum = yk_add(sum, term);
        slope[k] = yk_add(slope[k], is_angle ? yk_mul(yk_vec(0, 1), along) : along);
        if (turning >= 0) slope[turning] = yk_add(slope[turning], yk_mul(yk_vec(0, 1), term));
    }
    F[0] = yk_vec(sum.x, 0);
    F[1] = yk_vec(sum.y, 0);
    for (size_t k = 0; J && k < n; k++) {
        J[k] = yk_vec(slope[k].x, 0);
        J[n + k] = yk_vec(slope[k].y, 0);
    }
}

static void evaluate_real(const YkShape *shape, const YkVec *coefficients, const YkVec *x, YkVec *F, YkVec *J)
{
    size_t n = shape->unknowns, width = n + 1;
    for (size_t l = 0; l < shape->loops; l++)
        evaluate_parts(shape, coefficients + l * width, x, F + 2 * l, J ? J + 2 * l * n : NULL);
    for (size_t row = 2 * shape->loops; row < n; row++) {
        const YkVec *A = coefficients + row * width;
        double sum = A[n].x;
        bool turns = false; // in derivatives by the pose no unknown occurs, and no turn is taken away
        for (size_t k = 0; k < n; k++) {
            sum += A[k].x * x[k].x;
            turns |= A[k].x != 0 && row < 2 * shape->loops + shape->whole;
            if (J) J[row * n + k] = A[k];
        }
        F[row] = yk_vec(turns ? yk_nearest_turn(sum, 0) : sum, 0);
    }
}

void yk_system_evaluate(const YkShape *shape, const YkVec *coefficients, const YkVec *x, YkVec *F, YkVec *J)
{
    size_t n = shape->unknowns, width = n + 1;
    YkVec w[2 * YK_SYSTEM_LOOPS_MAX];
    if (shape->relations > 0) {
        evaluate_real(shape, coefficients, x, F, J);
        return;
    }
    for (size_t k = 0; k < shape->angles; k++) w[k] = yk_inverse(x[k]);
    for (size_t row = 0; row < n; row++)
        F[row] = evaluate_row(shape, coefficients + row * width, x, w, row >= shape->loops, J ? J + row * n : NULL);
}
