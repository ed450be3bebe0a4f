// The law of similarity: with the metre, the kilogram and the second set to other powers of two, a machine gives the
// same answers, each times the power of two that its dimension demands, bit for bit, since such factors round nothing.
// Code that adds a length to a number, compares a speed with 1e-9, or leaves a unit out, breaks it.
//
// The library's readers of units are replaced here: what is loaded after `similar_set(3, -5, 2)` measures a metre as
// 2^3, a kilogram as 2^-5, a second as 2^2. Have both machines at hand, make the same calls on both, and compare them:
//
//     Similar a, b;
//     similar_load_both(&a, &b, "examples/four-bar.yaml", (const int[]){3, -5, 2});
//     ... where a is given a value, b is given similar_to(value, quantity) ...
//     similar_check_state(&a, &b);                // all channels of a pose but forces
//     similar_check_forces(&a, &b);               // all forces, after yk_dynamics_solve on both
//     SIMILAR(x_of_a, x_of_b, YK_QUANTITY_SPEED); // one number
//     SIMILAR_EQUAL(a.file, count_of_a, count_of_b);
//
// A test that includes this header becomes a program of its own.
#ifndef TESTS_SIMILAR_H
#define TESTS_SIMILAR_H
#include <stdlib.h>
#include <yoke/yoke.h>
#include "base/units/units.h"
#include "check.h"
#include "dynamics/dynamics.h"
#include "examples.h"
#include "model/model.h"

#define yk_unit_read similar_unit_read
#define units similar_table // a name that tests use
#include "../src/base/units/unit_words.c"
#undef units
#undef yk_unit_read
#define yk_units_si similar_units_si
#include "../src/base/units/units.c"
#undef yk_units_si

static YkDimension similar_units; // powers of two: what a metre, a kilogram and a second are

static inline void similar_set(int length, int mass, int time)
{
    similar_units = (YkDimension){(signed char)length, (signed char)mass, (signed char)time, 0};
}

static inline int similar_power(YkDimension of)
{
    return of.length * similar_units.length + of.mass * similar_units.mass + of.time * similar_units.time;
}

bool yk_unit_read(const char *text, size_t length, double *size, YkDimension *dimension, const char **bad,
                  size_t *bad_length)
{
    bool is_read = similar_unit_read(text, length, size, dimension, bad, bad_length);
    if (is_read) *size = ldexp(*size, similar_power(*dimension));
    return is_read;
}

YkUnits yk_units_si(void)
{
    YkUnits units = similar_units_si();
    units.length = ldexp(1, similar_units.length);
    units.mass = ldexp(1, similar_units.mass);
    units.time = ldexp(1, similar_units.time);
    return units;
}

// Returns a value in the units that are set.
static inline double similar_to(double value, YkQuantity quantity)
{
    return ldexp(value, similar_power(yk_quantity_dimension(quantity)));
}

static inline YkMotion similar_motion(YkMotion q, bool is_distance)
{
    return (YkMotion){
        similar_to(q.position, is_distance ? YK_QUANTITY_LENGTH : YK_QUANTITY_ANGLE),
        similar_to(q.velocity, is_distance ? YK_QUANTITY_SPEED : YK_QUANTITY_ANGLE_RATE),
        similar_to(q.acceleration, is_distance ? YK_QUANTITY_ACCELERATION : YK_QUANTITY_ANGLE_ACCELERATION)};
}

// Fails unless b is a in the units that are set, bit for bit; both may be not a number. `what` says what they are.
static inline void similar_check(double a, double b, YkQuantity quantity, const char *file, const char *what)
{
    double due = similar_to(a, quantity);
    if (b == due || (isnan(b) && isnan(due))) return;
    print_error("%s: %s is %.17g, and %.17g in other units where it should be %.17g (m: 2^%d, kg: 2^%d, s: 2^%d)\n",
                file, what, a, b, due, similar_units.length, similar_units.mass, similar_units.time);
    fail();
}
#define SIMILAR(a, b, quantity) similar_check((a), (b), (quantity), __func__, #b)

// Fails unless two counts, kinds or statuses are the same.
static inline void similar_equal(long long a, long long b, const char *file, const char *what)
{
    if (a == b) return;
    print_error("%s: %s is %lld, and %lld in other units\n", file, what, a, b);
    fail();
}
#define SIMILAR_EQUAL(file, a, b) similar_equal((long long)(a), (long long)(b), (file), #a)

typedef struct Similar {
    const char *file;
    YkProblems *problems;
    size_t warnings; // of the file: a gravity eight times the Earth's is one
    YkModel *model;
    YkMechanism *mech; // NULL where it does not compile
    YkState *state;
    YkDynamics *dynamics;
} Similar;

// Loads a machine in the units that are set; `input` (may be NULL) is a coordinate to hold besides the drives.
static inline Similar similar_load(const char *file, const char *input)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s", YOKE_ROOT, file);
    Similar m = {.file = file, .problems = yk_problems_new()};
    m.model = yk_model_load(path, NULL, m.problems);
    if (!m.model) print_error("%s", yk_problems_text(m.problems, 0));
    assert_non_null(m.model);
    m.warnings = yk_problems_count(m.problems);
    YkCompileOptions options = {.inputs = &input, .input_count = input ? 1 : 0};
    m.mech = yk_mechanism_compile(m.model, &options, m.problems);
    if (!m.mech) return m;
    m.state = yk_state_new(m.mech);
    m.dynamics = yk_dynamics_new(m.mech, m.problems);
    assert_true(m.state && m.dynamics);
    return m;
}

static inline void similar_free(Similar *m)
{
    yk_dynamics_free(m->dynamics);
    yk_state_free(m->state);
    yk_mechanism_free(m->mech);
    yk_model_free(m->model);
    yk_problems_free(m->problems);
}

// Loads a machine as it is, and in other units, which stay set: powers of two of metre, kilogram and second.
static inline void similar_load_both(Similar *a, Similar *b, const char *file, const int units[3])
{
    similar_set(0, 0, 0);
    *a = similar_load(file, NULL);
    similar_set(units[0], units[1], units[2]);
    *b = similar_load(file, NULL);
}

// Fails unless two machines are compiled alike: the same freedom, inputs, loops and blocks, a similar size.
static inline void similar_check_mechanism(const Similar *a, const Similar *b)
{
    SIMILAR_EQUAL(a->file, !a->mech, !b->mech);
    SIMILAR_EQUAL(a->file, yk_problems_count(a->problems) - a->warnings, yk_problems_count(b->problems) - b->warnings);
    if (!a->mech) return;
    similar_check(yk_mechanism_size(a->mech), yk_mechanism_size(b->mech), YK_QUANTITY_LENGTH, a->file, "size");
    YkFreedom f = yk_mechanism_freedom(a->mech), g = yk_mechanism_freedom(b->mech);
    assert_memory_equal(&f, &g, sizeof f);
    SIMILAR_EQUAL(a->file, yk_input_count(a->mech), yk_input_count(b->mech));
    for (size_t k = 0; k < yk_input_count(a->mech); k++)
        SIMILAR_EQUAL(a->file, yk_input_coordinate(a->mech, k), yk_input_coordinate(b->mech, k));
    SIMILAR_EQUAL(a->file, yk_loop_count(a->mech), yk_loop_count(b->mech));
    for (size_t k = 0; k < yk_loop_count(a->mech); k++)
        SIMILAR_EQUAL(a->file, yk_loop_joint(a->mech, k), yk_loop_joint(b->mech, k));
    SIMILAR_EQUAL(a->file, yk_redundant_count(a->mech), yk_redundant_count(b->mech));
    for (size_t k = 0; k < yk_redundant_count(a->mech); k++)
        SIMILAR_EQUAL(a->file, yk_redundant_joint(a->mech, k), yk_redundant_joint(b->mech, k));
    SIMILAR_EQUAL(a->file, yk_block_count(a->mech), yk_block_count(b->mech));
    for (size_t k = 0; k < yk_block_count(a->mech); k++) {
        YkBlockInfo c = yk_block_info(a->mech, k), d = yk_block_info(b->mech, k);
        SIMILAR_EQUAL(a->file, c.kind, d.kind);
        assert_string_equal(c.label, d.label);
        SIMILAR_EQUAL(a->file, c.unknowns, d.unknowns);
        SIMILAR_EQUAL(a->file, c.equations, d.equations);
        SIMILAR_EQUAL(a->file, c.joint_count, d.joint_count);
        SIMILAR_EQUAL(a->file, c.body_count, d.body_count);
        SIMILAR_EQUAL(a->file, c.relation_count, d.relation_count);
    }
}

// Returns what a coordinate is.
static inline YkQuantity similar_quantity(const YkMechanism *mech, size_t coordinate)
{
    return yk_coordinate_info(mech, coordinate).is_distance ? YK_QUANTITY_LENGTH : YK_QUANTITY_ANGLE;
}

// Compares many values of a channel. Forces of batches come from a graph, which joins what happens to be the same
// number in one system of units: they may round otherwise.
static inline void similar_check_values(const double *a, const double *b, size_t count, YkChannel channel,
                                        const char *file, const char *what)
{
    double most = 0;
    for (size_t k = 0; k < count; k++) most = fmax(most, fabs(a[k]));
    for (size_t k = 0; k < count; k++)
        if (yk_channel_needs_forces(channel))
            CHECK_NEAR(similar_to(a[k], channel.quantity), b[k], 1e-12 * similar_to(most, channel.quantity));
        else
            similar_check(a[k], b[k], channel.quantity, file, what);
}

// Compares a channel, whose name and back also gives its quantity.
static inline void similar_channel(const Similar *a, const Similar *b, YkChannel channel)
{
    char name[256];
    YkChannel c;
    yk_channel_name(a->mech, channel, name, sizeof name);
    assert_int_equal(yk_channel_parse(b->mech, name, &c, b->problems), YK_OK);
    similar_check(yk_dynamics_channel(a->dynamics, a->state, c), yk_dynamics_channel(b->dynamics, b->state, c),
                  c.quantity, a->file, name);
}

static inline void similar_channels(const Similar *a, const Similar *b, YkChannelKind kind, size_t count, int orders)
{
    for (size_t k = 0; k < count; k++)
        for (int order = 0; order < orders; order++)
            similar_channel(a, b, (YkChannel){kind, (int)k, order, YK_QUANTITY_NUMBER});
}

// Fails unless two states stand in similar poses, with similar rates, branches and residuals.
static inline void similar_check_state(const Similar *a, const Similar *b)
{
    SIMILAR_EQUAL(a->file, yk_state_has_pose(a->state), yk_state_has_pose(b->state));
    SIMILAR_EQUAL(a->file, yk_state_has_rates(a->state), yk_state_has_rates(b->state));
    char label[2][512];
    yk_state_label(a->state, label[0], sizeof label[0]);
    yk_state_label(b->state, label[1], sizeof label[1]);
    assert_string_equal(label[0], label[1]);
    similar_channels(a, b, YK_CHANNEL_TIME, 1, 1);
    similar_channels(a, b, YK_CHANNEL_COORDINATE, yk_coordinate_count(a->mech), 3);
    similar_channels(a, b, YK_CHANNEL_BODY, yk_model_body_count(a->model), 3);
    similar_channels(a, b, YK_CHANNEL_POINT_X, yk_model_point_count(a->model), 3);
    similar_channels(a, b, YK_CHANNEL_POINT_Y, yk_model_point_count(a->model), 3);
    similar_channels(a, b, YK_CHANNEL_POINT_SPEED, yk_model_point_count(a->model), 1);
    similar_channels(a, b, YK_CHANNEL_TRANSMISSION, yk_block_count(a->mech), 1);
    YkResiduals r = yk_state_residuals(a->state), s = yk_state_residuals(b->state);
    similar_check(r.position, s.position, YK_QUANTITY_NUMBER, a->file, "residual of the position");
    similar_check(r.velocity, s.velocity, YK_QUANTITY_NUMBER, a->file, "residual of the velocity");
    similar_check(r.acceleration, s.acceleration, YK_QUANTITY_NUMBER, a->file, "residual of the acceleration");
    const YkReport *p = yk_state_report(a->state), *q = yk_state_report(b->state);
    SIMILAR_EQUAL(a->file, p->status, q->status);
    SIMILAR_EQUAL(a->file, p->block, q->block);
    SIMILAR_EQUAL(a->file, p->joint, q->joint);
    similar_check(p->gap, q->gap, YK_QUANTITY_LENGTH, a->file, "gap of the report");
    similar_check(p->determinant, q->determinant, YK_QUANTITY_NUMBER, a->file, "determinant of the report");
}

// Fails unless all forces, efforts and energies are similar.
static inline void similar_check_forces(const Similar *a, const Similar *b)
{
    size_t joints = yk_model_joint_count(a->model) + yk_dynamics_contact_count(a->dynamics);
    similar_channels(a, b, YK_CHANNEL_FORCE_X, joints, 1);
    similar_channels(a, b, YK_CHANNEL_FORCE_Y, joints, 1);
    similar_channels(a, b, YK_CHANNEL_FORCE, joints, 1);
    similar_channels(a, b, YK_CHANNEL_MOMENT, joints, 1);
    similar_channels(a, b, YK_CHANNEL_EFFORT, yk_coordinate_count(a->mech), 1);
    similar_channels(a, b, YK_CHANNEL_EFFORT_FROM, yk_coordinate_count(a->mech), 1);
    similar_channels(a, b, YK_CHANNEL_EFFORT_TO, yk_coordinate_count(a->mech), 1);
    static const YkChannelKind whole[] = {YK_CHANNEL_ENERGY,    YK_CHANNEL_KINETIC,   YK_CHANNEL_POTENTIAL,
                                          YK_CHANNEL_SHAKING_X, YK_CHANNEL_SHAKING_Y, YK_CHANNEL_SHAKING_MOMENT};
    for (size_t k = 0; k < sizeof whole / sizeof *whole; k++) similar_channels(a, b, whole[k], 1, 1);
    for (size_t k = 1; k < yk_model_body_count(a->model); k++)
        similar_check(yk_dynamics_balance(a->dynamics, k).residual, yk_dynamics_balance(b->dynamics, k).residual,
                      a->dynamics->largest_force > 0 ? YK_QUANTITY_NUMBER : YK_QUANTITY_FORCE, a->file,
                      "residual of a body's balance");
}

// The units to try, and what to do with a machine and the same in those units; both are assembled.
typedef void SimilarCheck(Similar *a, Similar *b, size_t units);
static struct {
    const int (*units)[3];
    size_t count;
    SimilarCheck *check;
} similar_pairs;

static inline void similar_check_pairs(const char *file)
{
    for (size_t k = 0; k < similar_pairs.count; k++) {
        Similar a, b;
        similar_load_both(&a, &b, file, similar_pairs.units[k]);
        similar_check_mechanism(&a, &b);
        YkStatus status = a.mech ? yk_state_assemble(a.state) : YK_NO_ASSEMBLY;
        if (a.mech) {
            SIMILAR_EQUAL(file, yk_state_assemble(b.state), status);
            similar_check_state(&a, &b);
        }
        if (status >= 0) similar_pairs.check(&a, &b, k);
        similar_free(&a);
        similar_free(&b);
    }
}

static inline size_t similar_example(const char *path, size_t number)
{
    (void)number;
    similar_check_pairs(path + strlen(YOKE_ROOT "/"));
    return 1;
}

// Calls `check` with each example and the same in other units, where they assemble.
static inline void similar_each_pair(const int (*units)[3], size_t count, SimilarCheck *check)
{
    similar_pairs.units = units;
    similar_pairs.count = count;
    similar_pairs.check = check;
    each_example(similar_example);
}
#endif
