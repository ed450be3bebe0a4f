// Counts, finds and proves the solutions of one group.
#include "configurations/group.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/mix.h"
#include "configurations/count.h"
#include "configurations/eliminate.h"
#include "configurations/follow.h"

enum { N_MAX = 2 * YK_SYSTEM_LOOPS_MAX, DETOURS = 3, COEFFICIENTS_MAX = 2 * YK_SYSTEM_LOOPS_MAX * (N_MAX + 1) };

void yk_group_kept_end(YkGroupKept *kept)
{
    yk_matroid_free(&kept->matroid);
    yk_generic_free(&kept->generic);
}

void yk_group_solutions_end(YkGroupSolutions *solutions)
{
    free(solutions->proved);
    free(solutions->real);
    free(solutions->pose);
    *solutions = (YkGroupSolutions){0};
}

// Makes `to` a copy of `from`. Returns false when out of memory.
static bool copy_bytes(void **to, const void *from, size_t bytes)
{
    void *copy = realloc(*to, bytes + 1);
    if (!copy) return false;
    if (from && bytes > 0) memcpy(copy, from, bytes);
    *to = copy;
    return true;
}

bool yk_group_solutions_copy(YkGroupSolutions *to, const YkGroupSolutions *from, const YkShape *shape)
{
    void *pose = to->pose, *proved = to->proved, *real = to->real;
    bool good = copy_bytes(&pose, from->pose, 2 * yk_coefficient_count(shape) * sizeof *from->pose);
    good = good && copy_bytes(&proved, from->proved, from->proved_count * sizeof *from->proved);
    good = good && copy_bytes(&real, from->real, from->real_count * shape->unknowns * sizeof *from->real);
    YkGroupSolutions copy = *from;
    copy.pose = pose;
    copy.proved = proved;
    copy.real = real;
    copy.proved_capacity = from->proved_count;
    copy.real_capacity = from->real_count;
    if (!good) { // nothing is kept
        free(pose);
        free(proved);
        free(real);
        copy = (YkGroupSolutions){0};
    }
    *to = copy;
    return good;
}

// --- counting

static YkGroupStatus count_matroid(YkGroupKept *kept, YkPace *pace)
{
    const YkShape *shape = &kept->shape;
    YkCountStatus status = shape->angles == shape->unknowns
                               ? yk_count_angles(&kept->matroid, pace, &kept->expected)
                               : yk_count_cones(&kept->matroid, shape, pace, &kept->expected);
    kept->is_counted = status == YK_COUNTED;
    if (status == YK_COUNT_STOPPED) return YK_GROUP_STOPPED;
    return status == YK_COUNT_NO_MEMORY ? YK_GROUP_NO_MEMORY : YK_GROUP_SOLVED;
}

// Counts the solutions at a pose, unless the last pose had the same matroid.
static YkGroupStatus count(YkGroupKept *kept, const YkVec *coefficients, YkPace *pace)
{
    YkMatroid matroid;
    YkMatroidStatus status = yk_matroid_make(&matroid, &kept->shape, coefficients);
    bool same = status == YK_MATROID_MADE && kept->matroid.rank && kept->is_counted &&
                memcmp(matroid.rank, kept->matroid.rank, (size_t)1 << matroid.elements) == 0;
    if (same || status == YK_MATROID_NO_MEMORY) {
        yk_matroid_free(&matroid);
        return same ? YK_GROUP_SOLVED : YK_GROUP_NO_MEMORY;
    }
    yk_matroid_free(&kept->matroid);
    kept->is_counted = false;
    kept->expected = 0;
    kept->matroid = matroid;
    return status == YK_MATROID_MADE ? count_matroid(kept, pace) : YK_GROUP_SOLVED;
}

// Makes the generic system if there is none, or one for another number of solutions.
static YkGroupStatus prepare(YkGroupKept *kept, const YkVec *coefficients, YkPace *pace)
{
    size_t wanted = kept->is_counted ? kept->expected : 0;
    if (kept->generic.coefficients && (!kept->is_counted || kept->generic.count == wanted)) return YK_GROUP_SOLVED;
    yk_generic_free(&kept->generic);
    if (kept->is_counted && wanted == 0) return YK_GROUP_SOLVED;
    YkGenericStatus status = yk_generic_make(&kept->generic, &kept->shape, coefficients, wanted, pace);
    if (status == YK_GENERIC_STOPPED) return YK_GROUP_STOPPED;
    return status == YK_GENERIC_NO_MEMORY ? YK_GROUP_NO_MEMORY : YK_GROUP_SOLVED;
}

// --- proving

// Keeps a solution if it can be proved and is certainly none of those kept before. Returns false when out of memory.
static bool prove(const YkShape *shape, const YkVec *coefficients, const YkVec *x, YkGroupSolutions *out)
{
    YkProved candidate = {0};
    memcpy(candidate.x, x, shape->unknowns * sizeof *x);
    if (!yk_certify(shape, coefficients, candidate.x, &candidate.certificate)) return true;
    for (size_t k = 0; k < out->proved_count; k++) {
        const YkProved *other = &out->proved[k];
        if (!yk_are_distinct(shape, candidate.x, &candidate.certificate, other->x, &other->certificate)) return true;
    }
    if (!YK_ROOM(out->proved, out->proved_count, out->proved_capacity)) return false;
    out->proved[out->proved_count++] = candidate;
    return true;
}

// --- finding

static bool has_all(const YkGroupKept *kept, const YkGroupSolutions *out)
{
    return kept->is_counted && out->proved_count >= kept->expected;
}

// Eliminates with one unknown hidden after the other until all solutions are proved, or as often as given.
static YkGroupStatus eliminate_all(const YkGroupKept *kept, const YkVec *pose, size_t attempts, YkPace *pace,
                                   YkGroupSolutions *out)
{
    static const uint64_t work[] = {0, 1000, 20000, 500000, 15000000}; // by loops
    const YkShape *shape = &kept->shape;
    if (shape->loops > YK_ELIMINATION_LOOPS_MAX) return YK_GROUP_SOLVED;
    YkVec *found = malloc(YK_ELIMINATION_MOST * shape->unknowns * sizeof *found);
    bool has_memory = found != NULL;
    for (size_t attempt = 0; has_memory && attempt < attempts && !has_all(kept, out); attempt++) {
        size_t count = 0;
        if (!yk_pace_spend(pace, work[shape->loops])) break;
        has_memory = yk_eliminate(shape, pose, attempt, found, &count);
        for (size_t k = 0; k < count && has_memory; k++) {
            YkVec *x = found + k * shape->unknowns;
            if (yk_system_polish(shape, pose, x) < 1e-10) has_memory = prove(shape, pose, x, out);
        }
    }
    free(found);
    if (!has_memory) return YK_GROUP_NO_MEMORY;
    return yk_pace_is_stopped(pace) ? YK_GROUP_STOPPED : YK_GROUP_SOLVED;
}

// Follows all paths from the generic system to the pose, over `between` unless it is NULL.
static YkGroupStatus follow_all(const YkGroupKept *kept, const YkVec *between, const YkVec *pose, YkPace *pace,
                                YkGroupSolutions *out)
{
    const YkShape *shape = &kept->shape;
    const YkVec *from = kept->generic.coefficients;
    YkVec x[N_MAX];
    for (size_t s = 0; s < kept->generic.count; s++) {
        memcpy(x, kept->generic.solutions + s * shape->unknowns, shape->unknowns * sizeof *x);
        bool arrived = !between || yk_path_follow(shape, from, between, x, pace);
        arrived = arrived && yk_path_follow(shape, between ? between : from, pose, x, pace);
        if (yk_pace_is_stopped(pace)) return YK_GROUP_STOPPED;
        if (arrived && !prove(shape, pose, x, out)) return YK_GROUP_NO_MEMORY;
    }
    return YK_GROUP_SOLVED;
}

// Returns a generic system on the way to a pose: its own, with other right-hand sides. Its loops and their conjugates
// are multiplied by complex numbers, which changes no solution: on the straight way from a pose to one with a
// coefficient of the opposite sign, that coefficient would vanish in both.
static void make_detour(const YkShape *shape, const YkVec *pose, uint64_t *seed, YkVec *between)
{
    size_t half = yk_coefficient_count(shape), width = shape->unknowns + 1;
    YkVec turn = yk_unit(2 + yk_mix_unit(seed));
    for (size_t k = 0; k < half; k++) between[k] = yk_mul(turn, pose[k]);
    for (size_t k = half; k < 2 * half; k++) between[k] = yk_mul(yk_conj(turn), pose[k]);
    for (size_t k = 0; k < shape->unknowns; k++) {
        YkVec way = yk_unit(2 * YK_PI * yk_mix_unit(seed)); // in a statement of its own: the order of draws is fixed
        YkVec scale = yk_scale(0.5 + yk_mix_unit(seed), way);
        for (size_t l = 0; l < shape->loops; l++) {
            YkVec *a = &between[half + l * width + k];
            *a = yk_mul(*a, scale);
        }
    }
}

// --- reading the real ones

static int compare_real(const YkShape *shape, const YkProved *a, const YkProved *b)
{
    for (size_t k = 0; k < shape->unknowns; k++) {
        bool is_angle = k < shape->angles;
        double u = is_angle ? yk_atan2(a->x[k].y, a->x[k].x) : a->x[k].x;
        double v = is_angle ? yk_atan2(b->x[k].y, b->x[k].x) : b->x[k].x;
        if (u != v) return u < v ? -1 : 1;
    }
    return 0;
}

// Sorts by insertion: there are few, and the comparison needs the shape.
static void sort_proved(const YkShape *shape, YkGroupSolutions *out)
{
    for (size_t k = 1; k < out->proved_count; k++) {
        YkProved moving = out->proved[k];
        size_t place = k;
        for (; place > 0 && compare_real(shape, &moving, &out->proved[place - 1]) < 0; place--)
            out->proved[place] = out->proved[place - 1];
        out->proved[place] = moving;
    }
}

static bool write_real(const YkShape *shape, double size, YkGroupSolutions *out)
{
    out->real_count = out->unclear = 0;
    for (size_t s = 0; s < out->proved_count; s++) {
        const YkProved *p = &out->proved[s];
        out->unclear += p->certificate.reality == YK_REALITY_UNKNOWN;
        if (p->certificate.reality != YK_REAL) continue;
        if (!YK_ROW_ROOM(out->real, shape->unknowns, out->real_count, out->real_capacity)) return false;
        double *row = out->real + out->real_count++ * shape->unknowns;
        for (size_t k = 0; k < shape->unknowns; k++)
            row[shape->column[k]] = k < shape->angles ? yk_atan2(p->x[k].y, p->x[k].x) : size * p->x[k].x;
    }
    return true;
}

static YkGroupStatus follow_to(YkGroupKept *kept, const YkVec *pose, YkPace *pace, YkGroupSolutions *out)
{
    YkVec between[COEFFICIENTS_MAX];
    const YkShape *shape = &kept->shape;
    uint64_t seed = 1;
    YkGroupStatus status = prepare(kept, pose, pace);
    for (int detour = 0; status == YK_GROUP_SOLVED && detour <= DETOURS && kept->generic.count > 0; detour++) {
        if (detour > 0) make_detour(shape, pose, &seed, between);
        status = follow_all(kept, detour > 0 ? between : NULL, pose, pace, out);
        if (out->proved_count >= (kept->is_counted ? kept->expected : kept->generic.count)) break;
    }
    return status;
}

static YkGroupStatus solve_at(YkGroupKept *kept, const YkVec *pose, YkPace *pace, YkGroupSolutions *out)
{
    size_t attempts = kept->solver == YK_SOLVER_ELIMINATION ? kept->shape.unknowns : 2;
    YkGroupStatus status = count(kept, pose, pace);
    bool is_dyad = kept->shape.loops == 1; // two short paths
    if (status == YK_GROUP_SOLVED && kept->solver != YK_SOLVER_PATHS && !(is_dyad && kept->solver == YK_SOLVER_BOTH))
        status = eliminate_all(kept, pose, attempts, pace, out);
    if (status == YK_GROUP_SOLVED && kept->solver != YK_SOLVER_ELIMINATION && !has_all(kept, out))
        status = follow_to(kept, pose, pace, out);
    return status;
}

YkGroupStatus yk_group_solve_at(YkGroupKept *kept, const YkVec *pose, double size, YkPace *pace, YkGroupSolutions *out)
{
    const YkShape *shape = &kept->shape;
    size_t bytes = 2 * yk_coefficient_count(shape) * sizeof *pose;
    if (!out->pose) out->pose = malloc(bytes);
    if (!out->pose) return YK_GROUP_NO_MEMORY;
    if (out->has_pose && memcmp(pose, out->pose, bytes) == 0 && (out->is_complete || yk_pace_is_stopped(pace)))
        return out->is_complete ? YK_GROUP_SOLVED : YK_GROUP_STOPPED;
    memcpy(out->pose, pose, bytes);
    out->has_pose = true;
    out->proved_count = 0;
    out->is_complete = false;
    YkGroupStatus status = solve_at(kept, pose, pace, out);
    sort_proved(shape, out);
    if (!write_real(shape, size, out)) return YK_GROUP_NO_MEMORY;
    out->is_counted = kept->is_counted;
    out->expected = kept->expected;
    out->is_complete =
        status == YK_GROUP_SOLVED && kept->is_counted && out->proved_count == kept->expected && out->unclear == 0;
    return status;
}

// Improves the solutions of the last pose. Returns whether all of this one were found and proved.
static bool improve_all(const YkShape *shape, const YkVec *pose, YkPace *pace, YkGroupSolutions *out, bool *has_memory)
{
    size_t n = shape->unknowns, count = out->proved_count;
    YkVec *before = malloc((count * n + 1) * sizeof *before);
    *has_memory = before != NULL;
    for (size_t s = 0; before && s < count; s++) memcpy(before + s * n, out->proved[s].x, n * sizeof *before);
    out->proved_count = 0;
    for (size_t s = 0; s < count && *has_memory && yk_pace_spend(pace, 12 * n * n * (n + 10)); s++) {
        YkVec *x = before + s * n;
        if (yk_system_polish(shape, pose, x) < 1e-8) *has_memory = prove(shape, pose, x, out);
        if (out->proved_count <= s) break; // not proved, or found twice
    }
    free(before);
    return out->proved_count == count;
}

YkGroupStatus yk_group_solve_near(YkGroupKept *kept, const YkVec *pose, double size, YkPace *pace,
                                  YkGroupSolutions *out)
{
    bool has_memory = true, is_near = out->has_pose && out->is_complete && out->proved_count > 0;
    if (is_near && improve_all(&kept->shape, pose, pace, out, &has_memory)) {
        memcpy(out->pose, pose, 2 * yk_coefficient_count(&kept->shape) * sizeof *pose);
        sort_proved(&kept->shape, out);
        if (!write_real(&kept->shape, size, out)) return YK_GROUP_NO_MEMORY;
        out->is_complete = out->unclear == 0;
        if (out->is_complete) return YK_GROUP_SOLVED;
    }
    if (!has_memory) return YK_GROUP_NO_MEMORY;
    if (is_near) out->has_pose = false;
    return yk_group_solve_at(kept, pose, size, pace, out);
}

YkGroupStatus yk_group_solve_all(YkGroupKept *kept, const YkRun *run, size_t index, YkPace *pace, YkGroupSolutions *out)
{
    YkVec pose[COEFFICIENTS_MAX];
    if (kept->outside != YK_OUTSIDE_NOT) return YK_GROUP_OUTSIDE;
    yk_coefficients_read(&kept->shape, run, index, pose);
    return yk_group_solve_at(kept, pose, run->mech->size, pace, out);
}
