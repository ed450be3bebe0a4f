// Assembling: the nearest configuration by trying all, all of them by Newton's method from anywhere, labels that keep
// their meaning, and messages for what cannot be assembled.
#include "four_bar.h"
#include "solve/state.h"

// --- all configurations
// -----------------------------------------------------------------------------------------------------

enum { POSES_MAX = 64, COORDINATES_MAX = 16 };
typedef struct Pose {
    double q[COORDINATES_MAX];
    char label[64];
    bool has_rates;
    double residual;
} Pose;
typedef struct Poses {
    Pose at[POSES_MAX];
    size_t count, stop_after;
} Poses;

static Pose pose_of(const YkState *state)
{
    Pose p = {.has_rates = yk_state_has_rates(state), .residual = yk_state_residuals(state).position};
    size_t n = yk_coordinate_count(yk_state_mechanism(state));
    assert_true(n <= COORDINATES_MAX);
    for (size_t k = 0; k < n; k++) p.q[k] = yk_state_coordinate(state, k).position;
    assert_true(yk_state_label(state, p.label, sizeof p.label) < sizeof p.label);
    return p;
}

static bool gather(void *context, YkState *state)
{
    Poses *poses = context;
    assert_true(poses->count < POSES_MAX);
    poses->at[poses->count++] = pose_of(state);
    return poses->count != poses->stop_after;
}

static Poses all_poses(const Machine *m)
{
    Poses poses = {.count = 0};
    bool complete = false;
    YkStatus status = yk_state_each(m->state, gather, &poses, &complete);
    assert_int_equal(status, poses.count > 0 ? YK_OK : YK_NO_ASSEMBLY);
    return poses;
}

// Squared differences of angles modulo a turn, of lengths over the machine's size.
static double distance2(const Machine *m, const double *a, const double *b)
{
    double sum = 0;
    for (size_t k = 0; k < yk_coordinate_count(m->mech); k++) {
        YkCoordinateInfo info = yk_coordinate_info(m->mech, k);
        if (info.input >= 0) continue;
        double d = info.is_distance ? (a[k] - b[k]) / yk_mechanism_size(m->mech) : angle_between(a[k], b[k]);
        sum += d * d;
    }
    return sum;
}

static size_t nearest_pose(const Machine *m, const Poses *poses, const double *q)
{
    size_t best = 0;
    for (size_t k = 1; k < poses->count; k++)
        if (distance2(m, poses->at[k].q, q) < distance2(m, poses->at[best].q, q)) best = k;
    return best;
}

static const struct {
    const char *file;
    size_t count;
} counts[] = {{"four-bar", 2},           {"slider-crank", 2}, {"oscillating-cylinder", 2},
              {"elliptic-trammel", 1},   {"quick-return", 2}, {"five-bar", 2},
              {"stephenson-six-bar", 4}, {"jansen", 8},       {"inverted-slider-crank", 2},
              {"scotch-yoke", 1},        {"excavator", 4},    {"double-pendulum", 1}};
enum { COUNTS = sizeof counts / sizeof counts[0] };

static void test_there_are_as_many_configurations_as_the_dyads_have_and_all_close(void **unused)
{
    (void)unused;
    for (size_t f = 0; f < COUNTS; f++) {
        Machine m = machine_load(counts[f].file);
        Poses poses = all_poses(&m);
        if (poses.count != counts[f].count) print_error("%s: %zu configurations\n", counts[f].file, poses.count);
        assert_int_equal(poses.count, counts[f].count);
        for (size_t k = 0; k < poses.count; k++) {
            assert_true(poses.at[k].residual <= 1e-12);
            for (size_t j = 0; j < k; j++) {
                assert_true(distance2(&m, poses.at[j].q, poses.at[k].q) > 1e-6);
                assert_true(strcmp(poses.at[j].label, poses.at[k].label) < 0); // "+" before "-"
            }
        }
        machine_free(&m);
    }
}

static void test_the_state_is_as_it_was_after_visiting_all(void **unused)
{
    (void)unused;
    static const char *const files[] = {"jansen", "stephenson-awkward", "double-butterfly"};
    for (size_t f = 0; f < 3; f++) {
        Machine m = machine_load(files[f]);
        Pose before = pose_of(m.state);
        double accel = yk_state_coordinate(m.state, 1).acceleration;
        Poses poses = all_poses(&m);
        assert_true(poses.count > 1);
        Pose after = pose_of(m.state);
        assert_true(memcmp(before.q, after.q, sizeof before.q) == 0);
        assert_string_equal(before.label, after.label);
        CHECK_NEAR(yk_state_coordinate(m.state, 1).acceleration, accel, 0);
        double at = yk_state_input(m.state, 0).position;
        assert_true(machine_solve(&m, at + 0.01, 1, 0) >= 0);
        CHECK_NEAR(sqrt(distance2(&m, pose_of(m.state).q, before.q)), 0, 0.2); // and goes on from there
        machine_free(&m);
    }
}

static bool has_present_input(void *context, YkState *state)
{
    const double *due = context;
    CHECK_NEAR(yk_state_coordinate(state, 0).position, *due, 0);
    CHECK_NEAR(yk_state_coordinate(state, 0).velocity, 3, 0);
    CHECK_NEAR(yk_state_body(state, 1).position, *due, 0); // the crank
    return true;
}

static void test_the_poses_shown_are_those_of_the_present_inputs(void **unused)
{
    (void)unused;
    Machine m = machine_load("four-bar");
    double before = machine_ask(&m, "theta2"), due = before + 1;
    yk_state_set_input(m.state, 0, (YkMotion){due, 3, 0});
    assert_int_equal(yk_state_each(m.state, has_present_input, &due, NULL), YK_OK);
    CHECK_NEAR(machine_ask(&m, "theta2"), before, 0); // the state's own pose is another
    machine_free(&m);
}

static void test_a_visitor_may_stop(void **unused)
{
    (void)unused;
    Machine m = machine_load("jansen");
    Poses poses = {.stop_after = 3};
    bool complete = false;
    assert_int_equal(yk_state_each(m.state, gather, &poses, &complete), YK_OK);
    assert_int_equal(poses.count, 3);
    machine_free(&m);
}

static void test_complete_says_whether_all_were_enumerated(void **unused)
{
    (void)unused;
    Poses poses = {.count = 0};
    bool complete = false;
    Machine dyads = machine_load("jansen"), group = machine_load("stephenson-awkward");
    yk_state_each(dyads.state, gather, &poses, &complete);
    assert_true(complete);
    poses.count = 0;
    yk_state_each(group.state, gather, &poses, &complete);
    assert_false(complete);
    machine_free(&dyads);
    machine_free(&group);
}

// --- Newton's method in absolute coordinates finds no other
// -------------------------------------------------------------------

enum { UNKNOWNS_MAX = 48 };

// Places of all bodies but the ground: x, y, angle. Rows: what joints and inputs ask.
static size_t equations(const Machine *m, const double *z, double *rows)
{
    size_t n = 0;
    double pose[UNKNOWNS_MAX + 3] = {0, 0, 0};
    memcpy(pose + 3, z, 3 * (m->model->body_count - 1) * sizeof *z);
    for (size_t j = 0; j < m->model->joint_count; j++) {
        const YkJoint *joint = &m->model->joints[j];
        const double *a = pose + 3 * joint->body[0], *b = pose + 3 * joint->body[1];
        YkVec pa = yk_add(yk_vec(a[0], a[1]), yk_mul(yk_unit(a[2]), joint->at[0]));
        YkVec pb = yk_add(yk_vec(b[0], b[1]), yk_mul(yk_unit(b[2]), joint->at[1]));
        YkVec off = yk_sub(pb, pa), e = yk_mul(yk_unit(a[2]), joint->along);
        if (joint->kind == YK_PIN || joint->kind == YK_WELD) {
            rows[n++] = off.x;
            rows[n++] = off.y;
        } else {
            rows[n++] = yk_cross(e, off);
        }
        if (joint->kind == YK_SLIDE || joint->kind == YK_WELD) rows[n++] = b[2] - a[2] - joint->turned;
        for (size_t i = 0; i < yk_input_count(m->mech); i++) {
            YkCoordinateInfo info = yk_coordinate_info(m->mech, yk_input_coordinate(m->mech, i));
            if (info.joint != j) continue;
            double now = info.is_distance ? yk_dot(e, off) : b[2] - a[2];
            rows[n++] = now - yk_state_input(m->state, i).position;
        }
    }
    return n;
}

// Gauss elimination with partial pivoting; false when singular.
static bool solve_dense(size_t n, double A[][UNKNOWNS_MAX], double *b)
{
    for (size_t k = 0; k < n; k++) {
        size_t p = k;
        for (size_t i = k + 1; i < n; i++)
            if (fabs(A[i][k]) > fabs(A[p][k])) p = i;
        if (fabs(A[p][k]) < 1e-12) return false;
        for (size_t j = 0; j < n; j++) {
            double t = A[k][j];
            A[k][j] = A[p][j];
            A[p][j] = t;
        }
        double t = b[k];
        b[k] = b[p];
        b[p] = t;
        for (size_t i = k + 1; i < n; i++) {
            double f = A[i][k] / A[k][k];
            for (size_t j = k; j < n; j++) A[i][j] -= f * A[k][j];
            b[i] -= f * b[k];
        }
    }
    for (size_t k = n; k-- > 0;) {
        for (size_t j = k + 1; j < n; j++) b[k] -= A[k][j] * b[j];
        b[k] /= A[k][k];
    }
    return true;
}

static bool newton(const Machine *m, double *z, size_t n)
{
    static double A[UNKNOWNS_MAX][UNKNOWNS_MAX];
    double rows[UNKNOWNS_MAX], moved[UNKNOWNS_MAX], step[UNKNOWNS_MAX], size = yk_mechanism_size(m->mech);
    for (int k = 0; k < 60; k++) {
        assert_int_equal(equations(m, z, rows), n);
        double worst = 0;
        for (size_t i = 0; i < n; i++) worst = fmax(worst, fabs(rows[i]));
        if (worst < 1e-11 * size) return true;
        if (!(worst < 1e6 * size)) return false;
        for (size_t j = 0; j < n; j++) {
            double keep = z[j], h = j % 3 == 2 ? 1e-7 : 1e-7 * size;
            z[j] = keep + h;
            equations(m, z, moved);
            z[j] = keep;
            for (size_t i = 0; i < n; i++) A[i][j] = (moved[i] - rows[i]) / h;
        }
        for (size_t i = 0; i < n; i++) step[i] = -rows[i];
        if (!solve_dense(n, A, step)) return false;
        double turn = 0;
        for (size_t j = 2; j < n; j += 3) turn = fmax(turn, fabs(step[j]));
        for (size_t j = 0; j < n; j++) z[j] += step[j] * fmin(1, 1 / fmax(turn, 1e-300));
    }
    return false;
}

static double relative_angle(const Machine *m, const double *z, size_t joint)
{
    const YkJoint *j = &m->model->joints[joint];
    double a = j->body[0] ? z[3 * (j->body[0] - 1) + 2] : 0, b = j->body[1] ? z[3 * (j->body[1] - 1) + 2] : 0;
    return b - a;
}

// The angles of a pose that Newton found, against those of a configuration; distances follow from them.
static bool is_pose(const Machine *m, const double *z, const Pose *pose)
{
    for (size_t k = 0; k < yk_coordinate_count(m->mech); k++) {
        YkCoordinateInfo info = yk_coordinate_info(m->mech, k);
        if (!info.is_distance && fabs(angle_between(relative_angle(m, z, info.joint), pose->q[k])) > 1e-6) return false;
    }
    return true;
}

// From so many random starts; YOKE_FULL=1 in the environment takes ten times as many.
static void check_no_other(const char *file, int starts)
{
    starts = getenv("YOKE_FULL") ? 10 * starts : (int)check_cases((uint64_t)starts);
    Machine m = machine_load(file);
    Poses poses = all_poses(&m);
    size_t n = 3 * (m.model->body_count - 1), seen = 0;
    bool found[POSES_MAX] = {false};
    uint64_t seed = 1234;
    assert_true(n <= UNKNOWNS_MAX);
    for (int k = 0; k < starts; k++) {
        double z[UNKNOWNS_MAX], size = yk_mechanism_size(m.mech);
        for (size_t j = 0; j < n; j++)
            z[j] = j % 3 == 2 ? check_uniform(&seed, -YK_PI, YK_PI) : check_uniform(&seed, -1.5 * size, 1.5 * size);
        if (!newton(&m, z, n)) continue;
        size_t at = 0;
        while (at < poses.count && !is_pose(&m, z, &poses.at[at])) at++;
        if (at == poses.count) print_error("%s: Newton's method found another configuration\n", file);
        assert_true(at < poses.count);
        seen += !found[at];
        found[at] = true;
    }
    assert_true(seen >= 2 || poses.count < 2); // Newton's method got somewhere
    machine_free(&m);
}

static void test_newtons_method_from_anywhere_finds_no_other(void **unused)
{
    (void)unused;
    check_no_other("four-bar", 400);
    check_no_other("slider-crank", 400);
    check_no_other("oscillating-cylinder", 400);
    check_no_other("stephenson-six-bar", 150);
    check_no_other("watt-six-bar", 150);
    check_no_other("quick-return", 120);
}

static void test_newtons_method_finds_no_other_of_a_group(void **unused)
{
    (void)unused;
    check_no_other("stephenson-awkward", 200);
    check_no_other("double-butterfly", 80);
}

// --- the nearest
// ------------------------------------------------------------------------------------------------------------

static void check_nearest(const char *file, int tries)
{
    Machine m = machine_load(file);
    Poses poses = all_poses(&m);
    uint64_t seed = 77;
    size_t taken = 0;
    bool seen[POSES_MAX] = {false};
    for (int k = 0; k < tries; k++) {
        for (size_t q = 0; q < yk_coordinate_count(m.mech); q++) {
            YkCoordinateInfo info = yk_coordinate_info(m.mech, q);
            if (info.input >= 0) continue;
            m.state->is_guessed[q] = true;
            m.state->guess[q] = info.is_distance ? check_uniform(&seed, -1, 1) * yk_mechanism_size(m.mech)
                                                 : check_uniform(&seed, -7, 7);
        }
        assert_true(yk_state_assemble(m.state) >= 0);
        size_t due = nearest_pose(&m, &poses, m.state->guess);
        Pose found = pose_of(m.state);
        CHECK_NEAR(sqrt(distance2(&m, found.q, poses.at[due].q)), 0, 1e-12 * 100);
        if (!m.mech->has_groups) assert_string_equal(found.label, poses.at[due].label);
        for (size_t q = 0; q < yk_coordinate_count(m.mech); q++) // and the angles on the guess's turn
            if (!yk_coordinate_info(m.mech, q).is_distance && yk_coordinate_info(m.mech, q).input < 0)
                assert_true(fabs(found.q[q] - m.state->guess[q]) <= YK_PI + 1e-9);
        taken += !seen[due];
        seen[due] = true;
    }
    assert_int_equal(taken, poses.count); // every configuration is the nearest for some guess
    machine_free(&m);
}

static void test_the_nearest_to_the_guess_is_taken(void **unused)
{
    (void)unused;
    check_nearest("four-bar", 500);
    check_nearest("slider-crank", 500);
    check_nearest("quick-return", 500);
    check_nearest("watt-six-bar", 500);
    check_nearest("stephenson-six-bar", 500);
    check_nearest("jansen", 2000);
    check_nearest("excavator", 500);
    check_nearest("stephenson-awkward", 200);
}

// --- labels
// -----------------------------------------------------------------------------------------------------------------

// Followed over a sweep in small steps, a configuration keeps its label; so a label means the same at every pose.
static void check_labels(const char *file, double span)
{
    Machine m = machine_load(file);
    Poses start = all_poses(&m);
    double at = yk_state_input(m.state, 0).position;
    for (size_t c = 0; c < start.count; c++) {
        Pose last = start.at[c];
        for (int k = 1; k <= 720; k++) {
            yk_state_set_input(m.state, 0, (YkMotion){at + span * k / 720, 1, 0});
            Poses now = all_poses(&m);
            if (now.count < start.count) break; // a limit: here two configurations meet
            last = now.at[nearest_pose(&m, &now, last.q)];
            assert_string_equal(last.label, start.at[c].label);
        }
        yk_state_set_input(m.state, 0, (YkMotion){at, 1, 0});
    }
    machine_free(&m);
}

static void test_a_label_means_the_same_at_every_pose(void **unused)
{
    (void)unused;
    check_labels("four-bar", 2 * YK_PI);
    check_labels("offset-slider-crank", 2 * YK_PI);
    check_labels("stephenson-six-bar", 2 * YK_PI);
    check_labels("jansen", 2 * YK_PI);
    check_labels("oscillating-cylinder", 2 * YK_PI);
    check_labels("quick-return", 2.7);
}

// --- no assembly, dead points
// ---------------------------------------------------------------------------------------------------

static void check_gap(FourBar f, double theta, double gap)
{
    char text[1024];
    snprintf(
        text, sizeof text,
        "bodies:\n  ground: {points: {O2: [0, 0], O4: [%.17g, 0]}}\n  crank: {points: {O2: [0, 0], A: [%.17g, 0]}}\n"
        "  coupler: {points: {A: [0, 0], B: [%.17g, 0]}}\n  rocker: {points: {O4: [0, 0], B: [%.17g, 0]}}\njoints:\n"
        "  O2: {pin: [ground, crank], angle: theta2}\n  A: {pin: [crank, coupler], angle: gamma}\n"
        "  O4: {pin: [ground, rocker], angle: theta4}\n  B: {pin: [coupler, rocker]}\n"
        "start: {theta2: %.17g, gamma: 0, theta4: 0}\n",
        f.d, f.a, f.b, f.c, theta);
    Machine m = machine_parse(text, false);
    assert_int_equal(yk_state_assemble(m.state), YK_NO_ASSEMBLY);
    const YkReport *report = yk_state_report(m.state);
    assert_int_equal(report->status, YK_NO_ASSEMBLY);
    assert_int_equal(report->block, 0);
    assert_non_null(strstr(report->message, "`B`"));
    CHECK_NEAR(report->gap, gap, 1e-12 * link_length_sum(f));
    Poses none = {.count = 0};
    assert_int_equal(yk_state_each(m.state, gather, &none, NULL), YK_NO_ASSEMBLY);
    assert_int_equal(none.count, 0);
    machine_free(&m);
}

static void test_what_cannot_be_assembled_says_which_joint_and_by_how_much(void **unused)
{
    (void)unused;
    uint64_t seed = 5;
    int far = 0, near = 0;
    while (far < 100 || near < 100) {
        FourBar f = {check_uniform(&seed, 0.1, 1), check_uniform(&seed, 0.1, 1), check_uniform(&seed, 0.1, 1),
                     check_uniform(&seed, 0.1, 1)};
        double theta = check_uniform(&seed, -3, 3), l = hypot(f.d - f.a * cos(theta), f.a * sin(theta));
        double beyond = l - (f.b + f.c), inside = fabs(f.b - f.c) - l;
        if (beyond < 1e-9 && inside < 1e-9) continue;
        check_gap(f, theta, fmax(beyond, inside));
        if (beyond > 0) far++;
        if (inside > 0) near++;
    }
}

static void test_a_slider_out_of_reach_says_by_how_much(void **unused)
{
    (void)unused;
    Machine m = machine_parse("bodies:\n"
                              "  ground: {points: {O: [0, 0], G: [0, 1.5]}}\n"
                              "  crank: {points: {O: [0, 0], A: [0.3, 0]}}\n"
                              "  rod: {points: {A: [0, 0], B: [1, 0]}}\n"
                              "  piston: {points: {B: [0, 0]}}\n"
                              "joints:\n"
                              "  O: {pin: [ground, crank], angle: theta}\n"
                              "  A: {pin: [crank, rod], angle: psi}\n"
                              "  B: {pin: [rod, piston]}\n"
                              "  R: {slide: [ground, piston], along: x, from: G, distance: x}\n"
                              "start: {theta: -1, x: 1, psi: 0}\n",
                              false);
    assert_int_equal(yk_state_assemble(m.state), YK_NO_ASSEMBLY);
    CHECK_NEAR(yk_state_report(m.state)->gap, 1.5 + 0.3 * sin(1) - 1, 1e-14);
    yk_state_set_input(m.state, 0, (YkMotion){1.8, 1, 0}); // nearer
    assert_int_equal(yk_state_assemble(m.state), YK_NO_ASSEMBLY);
    CHECK_NEAR(yk_state_report(m.state)->gap, 1.5 - 0.3 * sin(1.8) - 1, 1e-14);
    machine_free(&m);
}

static void check_words(const char *text, YkStatus status, const char *words, double gap)
{
    Machine m = machine_parse(text, false);
    assert_int_equal(yk_state_assemble(m.state), status);
    const YkReport *report = yk_state_report(m.state);
    if (!strstr(report->message, words)) print_error("%s\n", report->message);
    assert_non_null(strstr(report->message, words));
    assert_null(strstr(report->message, "misses by"));
    CHECK_NEAR(report->gap, gap, 1e-12);
    machine_free(&m);
}

// Two arms at given angles, and a pin that slides along both.
#define TWO_ARMS(Q, angle)                                                                                             \
    "bodies:\n  ground: {points: {O: [0, 0], Q: " Q "}}\n  arm1: {points: {O: [0, 0]}}\n"                              \
    "  arm2: {points: {Q: [0, 0]}}\n  block1: {points: {B: [0, 0]}}\n  block2: {points: {B: [0, 0]}}\njoints:\n"       \
    "  O: {pin: [ground, arm1], angle: a}\n  Q: {pin: [ground, arm2], angle: b}\n"                                     \
    "  S: {slide: [arm1, block1], along: x, distance: d}\n  T: {slide: [arm2, block2], along: x, distance: e}\n"       \
    "  B: {pin: [block1, block2]}\ndrives: {a: " angle ", b: " angle "}\nstart: {d: 1.5, e: 0.5}\n"

static void test_at_a_coincidence_it_is_told_what_is_true_there(void **unused)
{
    (void)unused;
    check_words(TWO_ARMS("[1, 0.3]", "0.5"), YK_NO_ASSEMBLY, "`B` are parallel", sin(0.5) - 0.3 * cos(0.5));
    check_words(TWO_ARMS("[1, 0]", "0"), YK_NO_ASSEMBLY, "`B` coincide", 0);
    check_words("bodies:\n  ground: {points: {O: [0, 0], C: [1, 0]}}\n  crank: {points: {O: [0, 0], A: [1, 0]}}\n"
                "  lever: {points: {C: [0, 0]}}\n  block: {points: {A: [0, 0]}}\njoints:\n"
                "  O: {pin: [ground, crank], angle: th}\n  C: {pin: [ground, lever], angle: ps}\n"
                "  S: {slide: [lever, block], along: x, distance: d}\n  A: {pin: [crank, block]}\n"
                "drives: {th: 0}\nstart: {ps: 0.3, d: 0.2}\n",
                YK_SINGULAR, "dead point at joint `A`", 0); // the pin on the lever's pivot
}

// A plate on three links, one of them far too long: that no assembly was found proves nothing, so it is not
// said that there is none.
static void test_where_the_search_gave_up_it_says_so(void **unused)
{
    (void)unused;
    check_words("bodies:\n  ground: {points: {O: [0, 0], A: [1, 0], B: [0, 1]}}\n"
                "  plate: {points: {C: [0, 0], D: [1, 0], E: [0, 1]}}\n"
                "  l: {points: {O: [0, 0], C: [1, 0]}}\n  m: {points: {A: [0, 0], D: [1, 0]}}\n"
                "  n: {points: {B: [0, 0], E: [40, 0]}}\njoints:\n"
                "  O: {pin: [ground, l], angle: th}\n  A: {pin: [ground, m], angle: u}\n"
                "  B: {pin: [ground, n], angle: v}\n  C: {pin: [l, plate], angle: w}\n  D: {pin: [m, plate]}\n"
                "  E: {pin: [n, plate]}\nstart: {th: 1, u: 1, v: 1, w: 0}\n",
                YK_NOT_CONVERGED, "there may still be one", 0);
}

// Many four-bars that close in two ways each, and a last one that does not: no search tries all combinations.
static void test_where_there_are_too_many_branches_it_gives_up_and_says_so(void **unused)
{
    (void)unused;
    check_without_sanitizers();
    enum { FOUR_BARS = 22 };
    static char text[20000];
    size_t n = (size_t)snprintf(text, sizeof text, "bodies:\n  ground: {points: {O: [0, 0], C: [4, 0]}}\n");
    for (int k = 0; k < FOUR_BARS; k++)
        n += (size_t)snprintf(text + n, sizeof text - n,
                              "  a%d: {points: {O: [0, 0], A: [1, 0]}}\n  b%d: {points: {A: [0, 0], B: [%g, 0]}}\n"
                              "  c%d: {points: {C: [0, 0], B: [2.5, 0]}}\n",
                              k, k, k == FOUR_BARS - 1 ? 0.1 : 3.5, k);
    n += (size_t)snprintf(text + n, sizeof text - n, "joints:\n");
    for (int k = 0; k < FOUR_BARS; k++)
        n += (size_t)snprintf(text + n, sizeof text - n,
                              "  O%d: {pin: [ground, a%d], at: O, angle: th%d}\n  A%d: {pin: [a%d, b%d], at: A}\n"
                              "  C%d: {pin: [ground, c%d], at: C}\n  B%d: {pin: [b%d, c%d], at: B}\n",
                              k, k, k, k, k, k, k, k, k, k, k);
    n += (size_t)snprintf(text + n, sizeof text - n, "drives: {th0: 1");
    for (int k = 1; k < FOUR_BARS; k++) n += (size_t)snprintf(text + n, sizeof text - n, ", th%d: 1", k);
    snprintf(text + n, sizeof text - n, "}\n");
    check_words(text, YK_NOT_CONVERGED, "gave up", 0);
}

// A parallelogram in line, whose coupler moves a second dyad: the first dyad is at its dead point, the second is well.
static const char chained[] = "bodies:\n"
                              "  ground: {points: {O2: [0, 0], O4: [4, 0], O6: [5, 3]}}\n"
                              "  crank: {points: {O2: [0, 0], A: [2, 0]}}\n"
                              "  coupler: {points: {A: [0, 0], B: [4, 0], P: [2, 1]}}\n"
                              "  rocker: {points: {O4: [0, 0], B: [2, 0]}}\n"
                              "  link: {points: {P: [0, 0], Q: [2, 0]}}\n"
                              "  arm: {points: {O6: [0, 0], Q: [2, 0]}}\n"
                              "joints:\n"
                              "  O2: {pin: [ground, crank], angle: theta2}\n"
                              "  A: {pin: [crank, coupler], angle: theta3}\n"
                              "  O4: {pin: [ground, rocker], angle: theta4}\n"
                              "  B: {pin: [coupler, rocker]}\n"
                              "  P: {pin: [coupler, link], angle: theta5}\n"
                              "  O6: {pin: [ground, arm], angle: theta6}\n"
                              "  Q: {pin: [link, arm]}\n"
                              "start: {theta2: 0, theta3: 0, theta4: 0, theta5: 1, theta6: 3}\n";

static bool no_rates_here(void *context, YkState *state)
{
    size_t *count = context;
    (*count)++;
    assert_int_equal(yk_state_report(state)->status, YK_SINGULAR);
    assert_false(yk_state_has_rates(state));
    for (size_t k = 0; k < yk_coordinate_count(yk_state_mechanism(state)); k++) {
        YkMotion q = yk_state_coordinate(state, k);
        assert_true(isfinite(q.position) && isfinite(q.velocity) && isfinite(q.acceleration));
    }
    return true;
}

static void test_a_dead_point_in_an_early_dyad_is_seen_in_every_configuration(void **unused)
{
    (void)unused;
    Machine m = machine_parse(chained, true);
    size_t count = 0;
    yk_state_set_input(m.state, 0, (YkMotion){0, 1, 0});
    assert_int_equal(yk_state_each(m.state, no_rates_here, &count, NULL), YK_OK);
    assert_int_equal(count, 2); // the first dyad's two are one pose
    machine_free(&m);
}

static const char half_guessed[] = "bodies:\n"
                                   "  ground: {points: {O2: [0, 0], O4: [5, 0]}}\n"
                                   "  crank: {points: {O2: [0, 0], A: [2, 0]}}\n"
                                   "  coupler: {points: {A: [0, 0], B: [6, 0]}}\n"
                                   "  rocker: {points: {O4: [0, 0], B: [4, 0]}}\n"
                                   "joints:\n"
                                   "  O2: {pin: [ground, crank], angle: theta2}\n"
                                   "  A: {pin: [crank, coupler], angle: gamma}\n"
                                   "  O4: {pin: [ground, rocker], angle: theta4}\n"
                                   "  B: {pin: [coupler, rocker]}\n"
                                   "start: {theta2: 0.7, theta4: 1}\n";

// A pose that is taken as the guess counts in every coordinate, `start:` only in those that it names.
static void test_a_copy_assembles_as_the_original_does(void **unused)
{
    (void)unused;
    Machine m = machine_parse(half_guessed, true);
    YkState *guessed = yk_state_new(m.mech), *copy = yk_state_new(m.mech);
    assert_true(guessed && copy);
    for (int k = 0; k < 100; k++) {
        assert_int_equal(yk_state_guess(guessed, m.state), YK_OK);
        yk_state_set_input(guessed, 0, (YkMotion){2 * YK_PI * k / 100, 0, 0});
        assert_int_equal(yk_state_copy(copy, guessed), YK_OK);
        assert_int_equal(yk_state_assemble(guessed), YK_OK);
        assert_int_equal(yk_state_assemble(copy), YK_OK);
        assert_int_equal(yk_state_branch(copy, 0), yk_state_branch(guessed, 0));
    }
    yk_state_free(guessed);
    yk_state_free(copy);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_there_are_as_many_configurations_as_the_dyads_have_and_all_close),
        cmocka_unit_test(test_the_state_is_as_it_was_after_visiting_all),
        cmocka_unit_test(test_the_poses_shown_are_those_of_the_present_inputs),
        cmocka_unit_test(test_a_visitor_may_stop),
        cmocka_unit_test(test_complete_says_whether_all_were_enumerated),
        cmocka_unit_test(test_newtons_method_from_anywhere_finds_no_other),
        cmocka_unit_test(test_newtons_method_finds_no_other_of_a_group),
        cmocka_unit_test(test_the_nearest_to_the_guess_is_taken),
        cmocka_unit_test(test_a_label_means_the_same_at_every_pose),
        cmocka_unit_test(test_what_cannot_be_assembled_says_which_joint_and_by_how_much),
        cmocka_unit_test(test_a_slider_out_of_reach_says_by_how_much),
        cmocka_unit_test(test_at_a_coincidence_it_is_told_what_is_true_there),
        cmocka_unit_test(test_where_the_search_gave_up_it_says_so),
        cmocka_unit_test(test_where_there_are_too_many_branches_it_gives_up_and_says_so),
        cmocka_unit_test(test_a_dead_point_in_an_early_dyad_is_seen_in_every_configuration),
        cmocka_unit_test(test_a_copy_assembles_as_the_original_does),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
