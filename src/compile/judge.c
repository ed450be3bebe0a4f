// Judges equations at a closed pose by the independence of columns and rows.
#include "compile/judge.h"
#include <string.h>

#define BLOCK_SINE 1e-6 // least sine between the columns of a dyad, and least arm over the machine's size
#define ROW_LEFT 1e-8   // the part of a row's length that must remain after subtracting the rows before

static double distance_at(const YkPlan *plan, int32_t distance)
{
    return distance == YK_NONE ? 1 : plan->pose->x[plan->mech->orientation_count - 1 + (size_t)distance];
}

static YkVec turned_at(const YkPlan *plan, const YkTerm *term)
{
    return term->slot == 0 ? term->v : yk_mul(yk_unit(plan->pose->x[term->slot - 1]), term->v);
}

// --- blocks

// Returns how the loop of plan->list changes with a column: in metres, over the size for an angle.
static YkVec column_of(const YkPlan *plan, YkColumn column)
{
    YkVec sum = {0, 0};
    for (size_t k = 0; k < plan->list.count; k++) {
        const YkTerm *t = &plan->list.items[k];
        YkVec v = turned_at(plan, t);
        if (column.is_distance && t->distance == column.index) sum = yk_add(sum, v);
        if (!column.is_distance && plan->mech->group_root[t->slot] == column.index)
            sum = yk_add(sum, yk_scale(distance_at(plan, t->distance) / plan->mech->size, yk_quarter(v)));
    }
    return sum;
}

bool yk_judge_block(const YkPlan *plan, const YkColumn *columns, size_t count)
{
    YkVec c[2];
    if (count == 0 || !yk_is_judged(plan, columns[0])) return true;
    for (size_t k = 0; k < count; k++) {
        c[k] = column_of(plan, columns[k]);
        if (!(yk_norm(c[k]) > BLOCK_SINE)) return false;
    }
    return count < 2 || fabs(yk_cross(c[0], c[1])) > BLOCK_SINE * yk_norm(c[0]) * yk_norm(c[1]);
}

// --- rows

bool yk_judge_start(YkJudge *judge, YkPlan *plan, const int32_t *ids, size_t count)
{
    const YkMechanism *mech = plan->mech;
    size_t all = mech->orientation_count + mech->distance_count;
    *judge = (YkJudge){.plan = plan, .unknowns = count};
    judge->place = YK_NEW(plan->arena, int32_t, all + 1);
    judge->rows = YK_NEW(plan->arena, double, count *count + 1);
    judge->next = YK_NEW(plan->arena, double, 2 * count + 1);
    judge->gradient = YK_NEW(plan->arena, double, all + 1);
    if (yk_arena_failed(plan->arena)) return false;
    for (size_t k = 0; k < all; k++) judge->place[k] = YK_NONE;
    for (size_t k = 0; k < count; k++) judge->place[ids[k]] = (int32_t)k;
    return true;
}

static void add_entry(YkJudge *judge, size_t id, YkVec v)
{
    int32_t place = judge->place[id];
    if (place == YK_NONE) return; // known
    judge->next[place] += v.x;
    judge->next[judge->unknowns + (size_t)place] += v.y;
}

static double length_of(const double *row, size_t n)
{
    double sum = 0;
    for (size_t k = 0; k < n; k++) sum += row[k] * row[k];
    return sqrt(sum);
}

// Subtracts from a row its part in the rows taken; twice, because of rounding.
static void reduce(const YkJudge *judge, double *row, size_t from)
{
    size_t n = judge->unknowns;
    for (int twice = 0; twice < 2; twice++)
        for (size_t r = from; r < judge->taken; r++) {
            const double *taken = judge->rows + r * n;
            double along = 0;
            for (size_t k = 0; k < n; k++) along += row[k] * taken[k];
            for (size_t k = 0; k < n; k++) row[k] -= along * taken[k];
        }
}

// Takes the longer of the remaining rows, then the other, as long as enough of them remains.
static size_t take(YkJudge *judge, size_t count)
{
    size_t n = judge->unknowns, before = judge->taken;
    double *row[2] = {judge->next, judge->next + n}, scale = length_of(row[0], n);
    if (count > 1) scale = fmax(scale, length_of(row[1], n));
    for (size_t k = 0; k < count; k++) reduce(judge, row[k], 0);
    if (count > 1 && length_of(row[1], n) > length_of(row[0], n)) {
        row[0] = judge->next + n;
        row[1] = judge->next;
    }
    for (size_t k = 0; k < count && judge->taken < n; k++) {
        reduce(judge, row[k], before);
        double left = length_of(row[k], n);
        if (!(left > ROW_LEFT * scale && left > YK_CLOSURE_ROUNDING)) break;
        for (size_t i = 0; i < n; i++) judge->rows[judge->taken * n + i] = row[k][i] / left;
        judge->taken++;
    }
    return judge->taken - before;
}

size_t yk_judge_loop(YkJudge *judge, const YkSum *sum)
{
    const YkPlan *plan = judge->plan;
    const YkMechanism *mech = plan->mech;
    memset(judge->next, 0, 2 * judge->unknowns * sizeof *judge->next);
    for (uint32_t k = 0; k < sum->count; k++) {
        const YkTerm *t = &mech->terms[sum->first + k];
        YkVec v = turned_at(plan, t);
        double d = distance_at(plan, t->distance) / mech->size;
        add_entry(judge, (size_t)mech->group_root[t->slot], yk_scale(d, yk_quarter(v)));
        if (t->distance != YK_NONE) add_entry(judge, mech->orientation_count + (size_t)t->distance, v);
    }
    return take(judge, 2);
}

size_t yk_judge_relation(YkJudge *judge, size_t relation)
{
    const YkMechanism *mech = judge->plan->mech;
    size_t o = mech->orientation_count;
    double miss;
    memset(judge->gradient, 0, yk_variable_count(mech) * sizeof *judge->gradient);
    memset(judge->next, 0, 2 * judge->unknowns * sizeof *judge->next);
    yk_closure_relation(mech, relation, judge->plan->pose->x, &miss, judge->gradient, NULL);
    for (size_t v = 0; v < yk_variable_count(mech); v++) {
        bool is_angle = v < o - 1;
        double entry = is_angle ? judge->gradient[v] / mech->size : judge->gradient[v];
        if (entry != 0) add_entry(judge, is_angle ? (size_t)mech->group_root[v + 1] : v + 1, yk_vec(entry, 0));
    }
    return take(judge, 1);
}
