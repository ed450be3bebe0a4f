// Beside coincidences - a base or an arm without length, parallel guides, tangent circles - an answer with status OK is
// right, or there is another status: measured on the points of the bodies, and against closed forms in long double.
#include <complex.h>
#include "machine.h"
#include "solve/state.h"

typedef long double Real;
typedef long double complex Plane;

// How far from the coincidence: 0, then 1e-17 ... 1e-3, to either side.
enum { OFFSETS = 61 };
static double offset(int k)
{
    double size = k / 2 == 0 ? 0 : pow(10, -17 + 0.5 * (k / 2 - 1));
    return k % 2 ? -size : size;
}

static double size_of(const Machine *m)
{
    double size = yk_mechanism_size(m->mech);
    for (size_t c = 0; c < yk_coordinate_count(m->mech); c++)
        if (yk_coordinate_info(m->mech, c).is_distance)
            size = fmax(size, fabs(yk_state_coordinate(m->state, c).position));
    return size;
}

// --- what bodies and joints keep, from the points alone --------------------------------------------------------------

static double fastest(const Machine *m)
{
    double most = 0;
    for (size_t k = 0; k < yk_model_point_count(m->model); k++) {
        YkPointMotion p = yk_state_point(m->state, k);
        most = fmax(most, hypot(p.velocity[0], p.velocity[1]));
    }
    return most;
}

static void check_lengths(const Machine *m)
{
    const YkPoint *points = m->model->points;
    double size = size_of(m), speed = fastest(m);
    for (size_t i = 0; i < m->model->point_count; i++)
        for (size_t j = 0; j < i; j++) {
            if (points[i].body != points[j].body) continue;
            YkPointMotion a = yk_state_point(m->state, i), b = yk_state_point(m->state, j);
            double x = a.position[0] - b.position[0], y = a.position[1] - b.position[1];
            double vx = a.velocity[0] - b.velocity[0], vy = a.velocity[1] - b.velocity[1];
            double length = hypot(points[i].at.x - points[j].at.x, points[i].at.y - points[j].at.y);
            CHECK_NEAR(hypot(x, y), length, 2e-12 * size);
            CHECK_NEAR(x * vx + y * vy, 0, 1e-11 * size * speed); // and it stays
        }
}

static YkPointMotion point_of(const Machine *m, const YkJoint *joint, int side)
{
    YkPointMotion origin = {0};
    if (joint->point[side] != YK_NONE) return yk_state_point(m->state, (size_t)joint->point[side]);
    fail_msg("every joint of these tests names its points");
    return origin;
}

static void check_pin(YkPointMotion a, YkPointMotion b, double size, double speed)
{
    for (int axis = 0; axis < 2; axis++) {
        CHECK_NEAR(a.position[axis], b.position[axis], 2e-12 * size);
        CHECK_NEAR(a.velocity[axis], b.velocity[axis], 1e-9 * speed);
    }
}

// The point on the line, and its velocity there: nothing across but what the line's turning brings.
static void check_slot(const Machine *m, const YkJoint *joint, YkPointMotion a, YkPointMotion b, double size,
                       double speed)
{
    YkMotion body = yk_state_body(m->state, (size_t)joint->body[0]);
    double angle = body.position + joint->along_angle, c = cos(angle), s = sin(angle);
    double x = b.position[0] - a.position[0], y = b.position[1] - a.position[1];
    double vx = b.velocity[0] - a.velocity[0], vy = b.velocity[1] - a.velocity[1];
    CHECK_NEAR(c * y - s * x, 0, 4e-12 * size);
    CHECK_NEAR(c * vy - s * vx - body.velocity * (c * x + s * y), 0, 1e-9 * speed);
}

static void check_joints(const Machine *m)
{
    double size = size_of(m), speed = fastest(m);
    for (size_t k = 0; k < m->model->joint_count; k++) {
        const YkJoint *joint = &m->model->joints[k];
        YkPointMotion a = point_of(m, joint, 0), b = point_of(m, joint, 1);
        if (joint->kind == YK_PIN)
            check_pin(a, b, size, speed);
        else
            check_slot(m, joint, a, b, size, speed);
    }
}

// --- families with a closed form -------------------------------------------------------------------------------------

// An answer and its rate, per unit of the input's rate.
typedef struct Truth {
    Real value, rate;
} Truth;

typedef struct Family {
    char text[1400];
    double coincidence, start; // of the input; a pose of the same machine to come from
    const char *answer;
    bool is_angle, is_limit, closes_there; // there: exactly at the coincidence, where an angle is left open
    Real a, b, c, d, e;                    // what the closed form needs
    Truth (*truth)(const struct Family *family, Real input, int branch);
} Family;

static Real random_length(uint64_t *seed)
{
    return (Real)check_uniform(seed, 0.3, 2);
}

// K + U e^(i u) + W e^(i v) = 0 for a base K with rate G: the angle u, by the law of cosines, and its rate from the two
// equations by Cramer's rule. `branch`: the sign of the determinant.
static Truth rrr_angle(Plane K, Plane G, Real U, Real W, int branch)
{
    Real L = cabsl(K), cosine = (L * L + U * U - W * W) / (2 * L * U);
    Real turn = acosl(fmaxl(-1, fminl(1, cosine)));
    Plane p = 0, q = 0;
    for (int sign = -1; sign <= 1; sign += 2) {
        p = U * cexpl(I * (cargl(-K) + sign * turn)), q = -K - p;
        if (cimagl(conjl(p) * q) * branch > 0) break;
    }
    return (Truth){cargl(p), -creall(conjl(G) * q) / cimagl(conjl(p) * q)};
}

static Truth four_bar_truth(const Family *f, Real theta, int branch)
{
    Plane A = f->a * cexpl(I * theta);
    return rrr_angle(A - f->d, I * A, f->b, -f->c, -branch);
}

// crank a, coupler b, rocker c, frame d. Rhombi, kites, parallelograms, equal circles; and near them.
static Family four_bar(uint64_t *seed)
{
    Family f = {.truth = four_bar_truth, .answer = "coupler.angle", .is_angle = true, .start = 0.2};
    f.a = f.d = random_length(seed), f.b = f.c = random_length(seed);
    int kind = (int)(check_random(seed) % 4);
    if (kind == 1) f.b = f.d, f.a = f.c = random_length(seed); // a parallelogram, flat
    if (kind == 2) f.b = f.c = f.d = f.a;
    if (kind == 3) f.c += 1e-13L, f.is_limit = true; // not far from where it opens
    f.a = (double)f.a, f.b = (double)f.b, f.c = (double)f.c, f.d = (double)f.d;
    f.closes_there = kind != 1;
    snprintf(f.text, sizeof f.text,
             "bodies: {ground: {points: {O: [0, 0], Q: [%.17g, 0]}}, crank: {points: {O: [0, 0], A: [%.17g, 0]}},\n"
             "  coupler: {points: {A: [0, 0], B: [%.17g, 0], P: [1, 1]}}, rocker: {points: {Q: [0, 0], B: [%.17g, "
             "0]}}}\n"
             "joints: {O: {pin: [ground, crank], angle: th}, A: {pin: [crank, coupler], angle: u},\n"
             "  Q: {pin: [ground, rocker], angle: v}, B: {pin: [coupler, rocker]}}\nstart: {th: 0.2}\n",
             (double)f.d, (double)f.a, (double)f.b, (double)f.c);
    return f;
}

static Truth slotted_truth(const Family *f, Real theta, int branch)
{
    Plane K = f->d - f->a * cexpl(I * theta), G = -I * f->a * cexpl(I * theta); // the pin's way from crank to pivot
    Real h = f->c, r = branch * sqrtl(fmaxl(0, creall(K * conjl(K)) - h * h));
    // K + (r + i h) e = 0 along and across the line
    Plane e = -K / (r + I * h);
    return (Truth){cargl(e) - f->e, cimagl(conjl(G) * e) / r};
}

// A crank's pin in the slot of a lever whose pivot the pin passes; the slot leads past the pivot at a distance c, or
// not at all.
static Family slotted(uint64_t *seed)
{
    Family f = {.truth = slotted_truth, .answer = "lever.angle", .is_angle = true, .start = 1};
    static const double beside[] = {0, 0, 1e-16, 1e-13, 1e-9, 1e-4};
    f.a = f.d = (double)random_length(seed);
    f.c = beside[check_random(seed) % 6];
    f.is_limit = f.c != 0;
    f.closes_there = f.c < 1e-12L;
    f.e = check_random(seed) % 2 ? (double)check_uniform(seed, -3, 3) : 0;
    double away = check_random(seed) % 2 ? check_uniform(seed, -2, 2) : 0; // the slot's origin, along the slot
    Plane from = cexpl(I * f.e) * (away + I * f.c);
    snprintf(f.text, sizeof f.text,
             "bodies: {ground: {points: {O: [0, 0], C: [%.17g, 0]}}, crank: {points: {O: [0, 0], A: [%.17g, 0]}},\n"
             "  lever: {points: {C: [0, 0], E: [2, 0], F: [%.17g, %.17g]}}}\n"
             "joints: {O: {pin: [ground, crank], angle: th}, C: {pin: [ground, lever], angle: u},\n"
             "  A: {pin-slot: [lever, crank], along: %.17g rad, from: F, at: A}}\nstart: {th: 1}\n",
             (double)f.d, (double)f.a, (double)creall(from), (double)cimagl(from), (double)f.e);
    return f;
}

static Truth strut_truth(const Family *f, Real s, int branch)
{
    Real x = s / (2 * f->a);
    if (s < 0) branch = -branch; // the determinant has the sign of s
    return (Truth){branch * acosl(x), -branch / (2 * f->a * sqrtl(1 - x * x))};
}

// A strut of length s between a pivot and the end of a rocker, which lies on the pivot where s = 0.
static Family strut(uint64_t *seed)
{
    Family f = {.truth = strut_truth, .answer = "tube.angle", .is_angle = true, .start = 0.5, .closes_there = true};
    static const char *const strut_first[] = {
        "O: {pin: [ground, tube], angle: u}, S: {slide: [tube, rod], along: x, distance: s, from: O, to: B},\n  ",
        "  Q: {pin: [ground, rocker], angle: v}, "};
    int order = (int)(check_random(seed) % 2); // which arm of the dyad is the strut
    f.a = (double)random_length(seed) + 0.5;
    f.a = (double)f.a;
    snprintf(f.text, sizeof f.text,
             "bodies: {ground: {points: {O: [0, 0], Q: [%.17g, 0]}}, tube: {points: {O: [0, 0], E: [1, 1]}},\n"
             "  rod: {points: {B: [0, 0]}}, rocker: {points: {Q: [0, 0], B: [%.17g, 0]}}}\n"
             "joints: {%s%sB: {pin: [%s]}}\nstart: {s: 0.5}\n",
             (double)f.a, (double)f.a, strut_first[order], strut_first[1 - order],
             order == 0 ? "rod, rocker" : "rocker, rod");
    return f;
}

static Truth piston_truth(const Family *f, Real theta, int branch)
{
    Plane A = f->a * cexpl(I * theta);
    Real h = f->d - cimagl(A), g = sqrtl(fmaxl(0, f->b * f->b - h * h)); // the rod's height and reach
    Real reach = branch * g;
    return (Truth){creall(A) + reach, creall(I * A) + h * cimagl(I * A) / reach};
}

// A rod that stands square on its guide where the crank points up: the circle touches the line there, or all but.
static Family piston(uint64_t *seed)
{
    Family f = {.truth = piston_truth, .answer = "s", .is_limit = true, .start = 0.8};
    static const double beside[] = {0, 0, 1e-15, 1e-12, 1e-9, 1e-5};
    f.coincidence = YK_PI / 2;
    f.a = (double)random_length(seed);
    f.b = f.a * 0.75L;
    f.d = (double)(f.a - f.b + beside[check_random(seed) % 6]); // the guide's height
    f.b = (double)f.b;
    snprintf(
        f.text, sizeof f.text,
        "bodies: {ground: {points: {O: [0, 0], G: [0, %.17g]}}, crank: {points: {O: [0, 0], A: [%.17g, 0]}},\n"
        "  rod: {points: {A: [0, 0], B: [%.17g, 0], P: [1, 2]}}, piston: {points: {B: [0, 0]}}}\n"
        "joints: {O: {pin: [ground, crank], angle: th}, A: {pin: [crank, rod], angle: u}, B: {pin: [rod, piston]},\n"
        "  S: {slide: [ground, piston], along: x, from: G, to: B, distance: s}}\nstart: {th: 0.8}\n",
        (double)f.d, (double)f.a, (double)f.b);
    return f;
}

static Truth guides_truth(const Family *f, Real theta, int branch)
{
    (void)branch;
    Real sine = sinl(theta), cosine = cosl(theta);
    Real gap = f->d == f->b ? -2 * f->d * powl(sinl(theta / 2), 2) : f->d * cosine - f->b;
    return (Truth){gap / sine, (f->b * cosine - f->d) / (sine * sine)};
}

// Two guides that come to be parallel, at a distance or on one line.
static Family guides(uint64_t *seed)
{
    Family f = {.truth = guides_truth, .answer = "s", .start = 1};
    f.a = (double)random_length(seed);
    f.d = (double)random_length(seed);
    f.b = check_random(seed) % 2 ? f.d : (double)random_length(seed);
    f.is_limit = f.b != f.d; // off to where they meet no more
    snprintf(f.text, sizeof f.text,
             "bodies: {ground: {points: {O: [0, 0], G: [0, %.17g]}}, crank: {points: {O: [0, 0], A: [%.17g, %.17g]}},\n"
             "  table: {points: {T: [0, 0]}}}\n"
             "joints: {O: {pin: [ground, crank], angle: th}, S: {pin-slot: [ground, table], along: x, from: G, at: T, "
             "distance: s},\n"
             "  R: {slide: [crank, table], along: x, from: A, to: T}}\nstart: {th: 1}\n",
             (double)f.d, (double)f.a, (double)f.b);
    return f;
}

static Truth telescope_truth(const Family *f, Real s, int branch)
{
    (void)f;
    if (s < 0) branch = -branch; // the determinant has the sign of s
    return (Truth){branch * s, branch};
}

// A strut of length s between a pivot and a block whose guide leads through the pivot: folded up, any direction is its
// own.
static Family telescope(uint64_t *seed)
{
    Family f = {.truth = telescope_truth, .answer = "x", .start = 0.5, .closes_there = true};
    (void)seed;
    snprintf(f.text, sizeof f.text, "%s",
             "bodies: {ground: {points: {O: [0, 0]}}, tube: {points: {O: [0, 0], E: [1, 1]}},\n"
             "  rod: {points: {B: [0, 0]}}, block: {points: {B: [0, 0]}}}\n"
             "joints: {O: {pin: [ground, tube], angle: u}, S: {slide: [tube, rod], along: x, distance: s, from: O, to: "
             "B},\n"
             "  G: {slide: [ground, block], along: x, distance: x, from: O, to: B}, B: {pin: [rod, block]}}\n"
             "start: {s: 0.5}\n");
    return f;
}

// --- the search ------------------------------------------------------------------------------------------------------

static Family (*const families[])(uint64_t *) = {four_bar, slotted, strut, piston, guides, telescope};
enum { FAMILIES = sizeof families / sizeof *families };

// What an answer with status OK may be off by, over what such an answer comes to. At a limit, where rates grow beyond
// all bounds, they may have two digits left.
#define VALUE_OFF 1e-7
#define RATE_OFF 1e-5
#define RATE_OFF_AT_LIMIT 0.02

typedef struct Tally {
    size_t fine, told;
} Tally;

static double off_truth(const Machine *m, const Family *f, Truth truth)
{
    double off = machine_ask(m, f->answer) - (double)truth.value;
    return f->is_angle ? yk_nearest_turn(off, 0) : off;
}

static void check_pose(const Machine *m, const Family *f, double input, int branch, Tally *tally)
{
    YkStatus status = machine_solve(m, input, 1, 0.25);
    if (f->closes_there && input == f->coincidence) { // the open angle stays as it was
        if (status != YK_SINGULAR) print_error("%sstatus %d, branch %d\n", f->text, status, branch);
        assert_int_equal(status, YK_SINGULAR);
        check_lengths(m);
        check_joints(m);
    }
    if (status != YK_OK && status != YK_REDUNDANT) {
        assert_non_null(yk_state_report(m->state)->message);
        tally->told++;
        return;
    }
    tally->fine++;
    check_lengths(m);
    check_joints(m);
    Truth truth = f->truth(f, input, branch);
    char rate[64];
    snprintf(rate, sizeof rate, "%s.rate", f->answer);
    double speed = machine_ask(m, rate), value_scale = fmax(1, fabs((double)truth.value)),
           rate_off = (f->is_limit ? RATE_OFF_AT_LIMIT : RATE_OFF) * fmax(1, fabs((double)truth.rate));
    bool is_right =
        fabs(off_truth(m, f, truth)) <= VALUE_OFF * value_scale && fabs(speed - (double)truth.rate) <= rate_off;
    if (!is_right)
        print_error("%sinput %.17g, branch %d, margin %g\n", f->text, input, branch, m->state->space.margin[0]);
    CHECK_NEAR(off_truth(m, f, truth), 0, VALUE_OFF * value_scale);
    CHECK_NEAR(speed, (double)truth.rate, rate_off);
    YkResiduals r = yk_state_residuals(m->state);
    CHECK_NEAR(r.position, 0, 1e-12 * fmax(1, size_of(m) / yk_mechanism_size(m->mech)));
}

// Which of the closed form's two solutions the pose at the start is.
static int branch_at_start(const Machine *m, const Family *f)
{
    for (int branch = -1; branch <= 1; branch += 2)
        if (fabs(off_truth(m, f, f->truth(f, f->start, branch))) < 1e-9) return branch;
    fail_msg("%s\nis neither solution", f->text);
    return 0;
}

// A batch that begins at the start gives the same pose as the state that comes from there.
static void check_batch(Machine *m, const Family *f, double input)
{
    double value = 0, rate = 1, acceleration = 0.25, *outputs[] = {&value};
    const double *inputs[] = {&input, &rate, &acceleration};
    signed char status = 0;
    assert_true(machine_solve(m, f->start, 1, 0) >= 0);
    YkChannel channel = machine_channel(m, f->answer);
    YkBatch *batch = yk_batch_new(m->state, &channel, 1);
    assert_non_null(batch);
    yk_batch_run(batch, inputs, outputs, &status, 1);
    YkStatus alone = machine_solve(m, input, rate, acceleration);
    if (alone < 0) alone = YK_LIMIT;
    if (status != alone) print_error("%sinput %.17g\n", f->text, input);
    assert_int_equal(status, alone == YK_REDUNDANT ? YK_OK : alone);
    if (alone >= 0) assert_true(value == yk_state_channel(m->state, channel));
    yk_batch_free(batch);
}

static void check_family(uint64_t seed, Tally *tally)
{
    uint64_t start = seed;
    Family f = families[check_random(&start) % FAMILIES](&start);
    Machine m = machine_parse(f.text, true);
    for (int branch = -1; branch <= 1; branch += 2)
        for (int k = 0; k < OFFSETS; k++) {
            if (yk_block_count(m.mech) != 1) fail_msg("one dyad was meant");
            yk_state_set_branch(m.state, 0, branch);
            assert_true(machine_solve(&m, f.start, 1, 0) >= 0);
            check_pose(&m, &f, f.coincidence + offset(k), branch_at_start(&m, &f), tally);
            if (k < 16 && seed % 4 == 0) check_batch(&m, &f, f.coincidence + offset(k));
        }
    machine_free(&m);
}

static void an_answer_with_status_ok_is_right(void **state)
{
    (void)state;
    const char *full = getenv("YOKE_FULL");
    size_t machines = full ? 100000 : 400;
    Tally tally = {0, 0};
    for (uint64_t seed = 1; seed <= machines; seed++) check_family(seed, &tally);
    assert_true(tally.fine > 5 * machines && tally.told > 5 * machines); // both are tried
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(an_answer_with_status_ok_is_right)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
