// Groups with several gears, with a rack, with a law: what exclusion finds is what Newton's method finds from a great
// many starts in fewer unknowns, and what a fine walk finds by closed form.
#include <yoke/configurations.h>
#include "configurations/exclude.h"
#include "solve/machine.h"
#include "solve/state.h"

enum { FOUND_MAX = 200, STEPS = 20000 };

// --- two gears in a loop: a six-bar chain of a driven link a and b, c, d, e, with wheels of equal size on b and d,
// which c holds, and on c and e, which d holds

typedef struct Double {
    double length[5], angle[5];
} Double;

static YkVec end_of_double(const Double *c)
{
    YkVec end = {0, 0};
    for (int k = 0; k < 5; k++) end = yk_add(end, yk_scale(c->length[k], yk_unit(c->angle[k])));
    return end;
}

static Machine double_machine(const Double *c)
{
    char text[2400];
    const double *l = c->length, *t = c->angle;
    YkVec end = end_of_double(c);
    snprintf(text, sizeof text,
             "bodies:\n  ground: {points: {A: [0, 0], F: [%.17g, %.17g]}}\n  a: {points: {A: [0, 0], B: [%.17g, 0]}}\n"
             "  b: {points: {C: [0, 0], B: [-%.17g, 0]}}\n  c: {points: {D: [0, 0], C: [-%.17g, 0]}}\n"
             "  d: {points: {D: [0, 0], E: [%.17g, 0]}}\n  e: {points: {E: [0, 0], F: [%.17g, 0]}}\njoints:\n"
             "  A: {pin: [ground, a], angle: t1}\n  B: {pin: [a, b], angle: t2}\n  C: {pin: [b, c], angle: t3}\n"
             "  D: {pin: [c, d], angle: t4}\n  E: {pin: [d, e], angle: t5}\n  F: {pin: [ground, e]}\n"
             "gears: {g: {mesh: [b, d], teeth: [20, 20], carrier: c}, h: {mesh: [c, e], teeth: [20, 40], carrier: d}}\n"
             "drives: {t1: %.17g}\nstart: {t2: %.17g, t3: %.17g, t4: %.17g, t5: %.17g}\n",
             end.x, end.y, l[0], l[1], l[2], l[3], l[4], t[0], t[1] - t[0], t[2] - t[1], t[3] - t[2], t[4] - t[3]);
    return machine_parse_with(text, NULL, 0);
}

// Returns by how much the loop misses at the angles of c and d. The first pair gives b = 2 c - d + constant, and the
// second (c - d) + 2 (e - d) = constant, up to a whole turn: e = (3 d - c) / 2 + constant, or half a turn more.
static YkVec double_miss(const Double *f, double c, double d, int half, double angle[5])
{
    double dc = c - f->angle[2], dd = d - f->angle[3];
    angle[0] = f->angle[0];
    angle[1] = f->angle[1] + 2 * dc - dd;
    angle[2] = c;
    angle[3] = d;
    angle[4] = f->angle[4] + 0.5 * (3 * dd - dc) + half * YK_PI;
    YkVec miss = yk_scale(-1, end_of_double(f));
    for (int k = 0; k < 5; k++) miss = yk_add(miss, yk_scale(f->length[k], yk_unit(angle[k])));
    return miss;
}

// Takes Newton's steps in c and d, with derivatives by differences. Returns whether the loop closes then.
static bool close_double(const Double *f, double c, double d, int half, double angle[5])
{
    for (int step = 0; step < 30; step++) {
        const double h = 1e-7;
        YkVec m = double_miss(f, c, d, half, angle);
        YkVec by_c = yk_scale(1 / h, yk_sub(double_miss(f, c + h, d, half, angle), m));
        YkVec by_d = yk_scale(1 / h, yk_sub(double_miss(f, c, d + h, half, angle), m));
        double det = yk_cross(by_c, by_d);
        if (fabs(det) < 1e-9) return false;
        c -= yk_cross(m, by_d) / det;
        d -= yk_cross(by_c, m) / det;
    }
    return yk_norm(double_miss(f, c, d, half, angle)) < 1e-10;
}

typedef struct Poses {
    double angle[FOUND_MAX][5];
    size_t count;
} Poses;

static bool has_pose(const Poses *p, const double angle[5])
{
    for (size_t k = 0; k < p->count; k++) {
        bool is_same = true;
        for (int j = 0; j < 5; j++) is_same &= fabs(yk_nearest_turn(p->angle[k][j] - angle[j], 0)) < 1e-6;
        if (is_same) return true;
    }
    return false;
}

static bool keep_double(void *context, YkState *state)
{
    static const char *const names[] = {"t1", "t2", "t3", "t4", "t5"};
    const YkMechanism *mech = yk_state_mechanism(state);
    Poses *poses = context;
    double sum = 0;
    assert_true(poses->count < FOUND_MAX);
    assert_true(yk_state_residuals(state).position < 1e-10); // the gears too, with their turns
    for (int k = 0; k < 5; k++)
        poses->angle[poses->count][k] = sum += yk_state_coordinate(state, yk_coordinate_find(mech, names[k])).position;
    poses->count++;
    return true;
}

static void test_all_poses_of_two_gears_in_a_loop_are_found(void **unused)
{
    (void)unused;
    uint64_t seed = 31;
    size_t most = 0;
    for (size_t k = 0, cases = check_cases(10); k < cases; k++) {
        Double f;
        static Poses proved, found;
        for (int j = 0; j < 5; j++) {
            f.length[j] = check_uniform(&seed, 0.5, 2);
            f.angle[j] = check_uniform(&seed, -YK_PI, YK_PI);
        }
        Machine m = double_machine(&f);
        assert_true(yk_state_set_time(m.state, 0, m.problems) >= 0 && yk_state_assemble(m.state) >= 0);
        YkConfigurations *all = yk_configurations_new(m.mech);
        YkConfigurationsReport r;
        proved.count = found.count = 0;
        assert_int_equal(yk_configurations_each(all, m.state, NULL, keep_double, &proved, &r), YK_OK);
        if (!r.complete) print_error("case %zu: %s\n", k, r.message);
        assert_true(r.complete);
        assert_int_equal(r.reason, YK_COMPLETE_BY_EXCLUSION);
        for (int start = 0; start < 4000; start++) {
            double angle[5], c = check_uniform(&seed, -7, 7), d = check_uniform(&seed, -7, 7);
            if (!close_double(&f, c, d, start % 2, angle) || has_pose(&found, angle)) continue;
            memcpy(found.angle[found.count++], angle, sizeof angle);
            assert_true(has_pose(&proved, angle));
        }
        assert_int_equal(found.count, proved.count);
        most = proved.count > most ? proved.count : most;
        yk_configurations_free(all);
        machine_free(&m);
    }
    assert_true(most >= 6);
}

// A belt and a gear between b and d, both on c, hold the three together: what is left is a dyad of them and e. The sum
// and the difference of two angles are never one odd and one even number of turns, so that half a turn of c is no
// solution.
static void test_a_belt_and_a_gear_hold_three_links(void **unused)
{
    (void)unused;
    static const char text[] =
        "bodies:\n  ground: {points: {A: [0, 0], F: [3.1, 0.4]}}\n  a: {points: {A: [0, 0], B: [1, 0]}}\n"
        "  b: {points: {C: [0, 0], B: [-1.3, 0]}}\n  c: {points: {D: [0, 0], C: [-0.9, 0]}}\n"
        "  d: {points: {D: [0, 0], E: [0.7, 0]}}\n  e: {points: {E: [0, 0], F: [2.2, 0]}}\njoints:\n"
        "  A: {pin: [ground, a], angle: t1}\n  B: {pin: [a, b], angle: t2}\n  C: {pin: [b, c], angle: t3}\n"
        "  D: {pin: [c, d], angle: t4}\n  E: {pin: [d, e], angle: t5}\n  F: {pin: [ground, e]}\n"
        "gears: {g: {mesh: [b, d], teeth: [20, 20], carrier: c}}\nbelts: {h: {between: [b, d], radii: [0.1, 0.1]}}\n"
        "drives: {t1: 0.7}\nstart: {t2: 0.3, t3: -0.8, t4: -0.8}\n";
    Machine m = machine_parse_with(text, NULL, 0);
    assert_true(yk_state_set_time(m.state, 0, m.problems) >= 0 && yk_state_assemble(m.state) >= 0);
    YkConfigurations *all = yk_configurations_new(m.mech);
    YkConfigurationsReport r;
    Poses poses = {.count = 0};
    assert_int_equal(yk_configurations_each(all, m.state, NULL, keep_double, &poses, &r), YK_OK);
    assert_true(r.complete);
    assert_int_equal(r.reason, YK_COMPLETE_BY_EXCLUSION);
    assert_int_equal(poses.count, 2);
    for (int k = 2; k < 4; k++) // in both the three stand to each other as in the start
        CHECK_NEAR(yk_nearest_turn(poses.angle[0][k] - poses.angle[0][1] - poses.angle[1][k] + poses.angle[1][1], 0), 0,
                   1e-9);
    yk_configurations_free(all);
    machine_free(&m);
}

// --- a rack in two loops: a driven link to B, a link b with B, C and E, a bar from C to a block on a line of the
// ground, a bar from E to the rim of a wheel on the ground, and a rack on the block that the wheel turns

typedef struct Rack {
    double crank, turn, cx, cy, ex, ey, bar, bars, rim, radius; // b has C and E at these places from B
    YkVec wheel;                                                // its centre
    double s, angle[4]; // own pose: the block; b, the bars to C and E, the wheel
} Rack;

static YkVec tip(const Rack *r)
{
    return yk_scale(r->crank, yk_unit(r->turn));
}

// Computes the block's height and the wheel's centre from the own pose.
static void settle(Rack *r, double *height)
{
    YkVec b = yk_unit(r->angle[0]);
    YkVec C = yk_add(tip(r), yk_mul(b, yk_vec(r->cx, r->cy))), E = yk_add(tip(r), yk_mul(b, yk_vec(r->ex, r->ey)));
    YkVec D = yk_add(C, yk_scale(r->bar, yk_unit(r->angle[1]))), F = yk_add(E, yk_scale(r->bars, yk_unit(r->angle[2])));
    *height = D.y;
    r->s = D.x;
    r->wheel = yk_sub(F, yk_scale(r->rim, yk_unit(r->angle[3])));
}

static Machine rack_machine(const Rack *r, double height)
{
    char text[2400];
    snprintf(text, sizeof text,
             "bodies:\n  ground: {points: {A: [0, 0], W: [%.17g, %.17g], S: [0, %.17g]}}\n"
             "  a: {points: {A: [0, 0], B: [%.17g, 0]}}\n"
             "  b: {points: {B: [0, 0], C: [%.17g, %.17g], E: [%.17g, %.17g]}}\n"
             "  c: {points: {C: [0, 0], D: [%.17g, 0]}}\n  block: {points: {D: [0, 0]}}\n"
             "  e: {points: {E: [0, 0], F: [%.17g, 0]}}\n  wheel: {points: {W: [0, 0], F: [%.17g, 0]}}\njoints:\n"
             "  A: {pin: [ground, a], angle: ta}\n  B: {pin: [a, b], angle: tb}\n  C: {pin: [b, c], angle: tc}\n"
             "  D: {pin: [c, block]}\n  S: {slide: [ground, block], along: x, from: S, to: D, distance: s}\n"
             "  E: {pin: [b, e], angle: te}\n  F: {pin: [e, wheel]}\n  W: {pin: [ground, wheel], angle: tw}\n"
             "racks: {k: {pinion: wheel, rack: block, radius: %.17g}}\n"
             "drives: {ta: %.17g}\nstart: {tb: %.17g, tc: %.17g, te: %.17g, tw: %.17g, s: %.17g}\n",
             r->wheel.x, r->wheel.y, height, r->crank, r->cx, r->cy, r->ex, r->ey, r->bar, r->bars, r->rim, r->radius,
             r->turn, r->angle[0] - r->turn, r->angle[1] - r->angle[0], r->angle[2] - r->angle[0], r->angle[3], r->s);
    return machine_parse_with(text, NULL, 0);
}

static size_t meets_between(double from, double to) // a whole turn of the wheel, less than half of one apart
{
    return cos(from) > 0 && cos(to) > 0 && (sin(from) > 0) != (sin(to) > 0);
}

// Returns in *rolled by how much the rack is off the wheel, in turns of the wheel, where b has an angle, on branches of
// the block and of the wheel. sign: which way the rack moves when the wheel turns. Returns 0, or the bit of the branch
// whose loop does not close.
static int rolled_at(const Rack *r, double height, double b, int branches, int sign, double *rolled)
{
    YkVec turn = yk_unit(b);
    YkVec C = yk_add(tip(r), yk_mul(turn, yk_vec(r->cx, r->cy))),
          E = yk_add(tip(r), yk_mul(turn, yk_vec(r->ex, r->ey)));
    double rise = height - C.y, run2 = r->bar * r->bar - rise * rise;
    YkVec way = yk_sub(E, r->wheel);
    double far = yk_norm(way), cosine = (far * far + r->rim * r->rim - r->bars * r->bars) / (2 * far * r->rim);
    if (!(run2 >= 0)) return 1;
    if (!(fabs(cosine) <= 1)) return 2;
    double s = C.x + (branches & 1 ? 1 : -1) * sqrt(run2);
    double wheel = atan2(way.y, way.x) + (branches & 2 ? 1 : -1) * acos(cosine);
    *rolled = sign * (s - r->s) / r->radius - (wheel - r->angle[3]);
    return 0;
}

// Where a branch ends it meets the other one of the loop that does not close any longer.
static size_t count_rolls(const Rack *r, double height, int sign)
{
    size_t count = 0;
    for (int k = 0; k < STEPS; k++)
        for (int branches = 0; branches < 4; branches++) {
            double from, to, other, at = 2 * YK_PI * k / STEPS, next = 2 * YK_PI * (k + 1) / STEPS;
            int here = rolled_at(r, height, at, branches, sign, &from);
            int there = rolled_at(r, height, next, branches, sign, &to), open = here | there;
            if (open == 0) count += meets_between(from, to);
            if ((here == 0) == (there == 0) || !(branches & open)) continue; // each pair once
            if (rolled_at(r, height, here == 0 ? at : next, branches ^ open, sign, &other) == 0)
                count += meets_between(here == 0 ? from : to, other);
        }
    return count;
}

static bool count_one(void *context, YkState *state)
{
    assert_true(yk_state_residuals(state).position < 1e-10);
    ++*(size_t *)context;
    return true;
}

// Every pose that exclusion finds has the block where a configuration has it, without any help by Newton's method.
static void check_distances(Machine *m, const double *s, size_t count)
{
    YkGeared geared;
    YkExcluded found = {.count = 0};
    YkRun run = yk_state_run(m->state, &m->state->spare);
    size_t block = 0;
    yk_run_begin(&run);
    for (size_t k = 0; k < m->mech->step_count; k++) {
        const YkStep *step = &m->mech->steps[k];
        block = (size_t)step->target;
        if (step->kind == YK_STEP_BLOCK && m->mech->blocks[block].kind == YK_BLOCK_GROUP) break;
        yk_run_steps(&run, k, k + 1);
    }
    assert_true(yk_geared_read(&geared, &run, block) && yk_exclude(&geared, NULL, &found));
    assert_int_equal(found.count, count);
    size_t n = geared.shape.unknowns, column = geared.shape.column[n - 1]; // the only distance
    for (size_t k = 0; k < found.count; k++) {
        double nearest = INFINITY;
        for (size_t j = 0; j < count; j++) nearest = fmin(nearest, fabs(found.poses[k * n + column] - s[j]));
        assert_true(nearest < 1e-9 * m->mech->size);
    }
    yk_excluded_end(&found);
}

typedef struct Blocks {
    double s[FOUND_MAX];
    size_t count;
} Blocks;

static bool note_block(void *context, YkState *state)
{
    Blocks *blocks = context;
    size_t s = yk_coordinate_find(yk_state_mechanism(state), "s");
    assert_true(blocks->count < FOUND_MAX);
    blocks->s[blocks->count++] = yk_state_coordinate(state, s).position;
    return count_one(&(size_t){0}, state);
}

static void test_all_poses_of_a_rack_in_loops_are_found(void **unused)
{
    (void)unused;
    uint64_t seed = 41;
    size_t most = 0;
    for (size_t k = 0, cases = check_cases(20); k < cases; k++) {
        double height;
        double scale = k % 2 == 0 ? 1 : 1000; // no length is special
        Rack r = {.crank = scale * check_uniform(&seed, 0.5, 1), .turn = check_uniform(&seed, -3, 3)};
        r.cx = scale * check_uniform(&seed, 0.5, 1.5), r.cy = scale * check_uniform(&seed, -0.5, 0.5);
        r.ex = scale * check_uniform(&seed, 0.5, 1.5), r.ey = scale * check_uniform(&seed, -0.5, 0.5);
        r.bar = scale * check_uniform(&seed, 1.5, 3), r.bars = scale * check_uniform(&seed, 1.5, 3);
        r.rim = scale * check_uniform(&seed, 0.8, 2), r.radius = scale * check_uniform(&seed, 0.3, 0.8);
        for (int j = 0; j < 4; j++) r.angle[j] = check_uniform(&seed, -3, 3);
        settle(&r, &height);
        Machine m = rack_machine(&r, height);
        assert_true(yk_state_set_time(m.state, 0, m.problems) >= 0 && yk_state_assemble(m.state) >= 0);
        YkConfigurations *all = yk_configurations_new(m.mech);
        YkConfigurationsReport report;
        Blocks blocks = {.count = 0};
        assert_int_equal(yk_configurations_each(all, m.state, NULL, note_block, &blocks, &report), YK_OK);
        size_t count = blocks.count;
        // The rack lies below the wheel, or above it.
        size_t walked = count_rolls(&r, height, r.wheel.y > height ? 1 : -1);
        if (!report.complete || count != walked)
            print_error("case %zu: %zu, walked %zu: %s\n", k, count, walked, report.message);
        assert_true(report.complete);
        assert_int_equal(report.reason, YK_COMPLETE_BY_EXCLUSION);
        assert_int_equal(count, walked);
        check_distances(&m, blocks.s, count);
        most = count > most ? count : most;
        yk_configurations_free(all);
        machine_free(&m);
    }
    assert_true(most >= 6);
}

// --- a slide that turns with a wheel: a driven link a, b on its tip, a wheel c on b that rolls on one of a, and a
// guide on the ground in which a line of c slides

typedef struct Guide {
    double crank, turn, link, b, c, along, off, s; // own pose: b, c, s; the line of c stands off by this
} Guide;

// Returns from where the line of c starts, and its direction, where b has an angle. Wheels of equal size: c turns twice
// as far as b.
static YkVec line_at(const Guide *g, double b, YkVec *way)
{
    YkVec c = yk_unit(g->c + 2 * (b - g->b));
    *way = yk_mul(c, yk_unit(g->along));
    YkVec C = yk_add(yk_scale(g->crank, yk_unit(g->turn)), yk_scale(g->link, yk_unit(b)));
    return yk_add(C, yk_mul(c, yk_vec(0, g->off)));
}

static YkVec guide_of(const Guide *g)
{
    YkVec way, from = line_at(g, g->b, &way);
    return yk_add(from, yk_scale(g->s, way));
}

// How far the slide stands by the law of b's angle, seen from a.
static double lift_at(const Guide *g, double b)
{
    double x = b - g->turn;
    return 0.6 * (1 - cos(x)) + 0.25 * sin(2 * x);
}

// A machine with the gear, or with the law of b that moves the slide in its place.
static Machine guide_machine(const Guide *g, bool has_law)
{
    char text[1800];
    YkVec E = guide_of(g);
    snprintf(text, sizeof text,
             "bodies:\n  ground: {points: {A: [0, 0], E: [%.17g, %.17g]}}\n  a: {points: {B: [0, 0], A: [-%.17g, 0]}}\n"
             "  b: {points: {B: [0, 0], C: [%.17g, 0]}}\n  c: {points: {C: [0, 0], Q: [0, %.17g]}}\n"
             "  d: {points: {E: [0, 0]}}\njoints:\n  A: {pin: [ground, a], angle: ta}\n"
             "  B: {pin: [a, b], angle: tb}\n  C: {pin: [b, c], angle: tc}\n  E: {pin: [ground, d]}\n"
             "  S: {slide: [c, d], along: %.17g rad, from: Q, to: E, distance: s}\n"
             "%sta: %.17g}\nstart: {tb: %.17g, tc: %.17g, s: %.17g}\n",
             E.x, E.y, g->crank, g->link, g->off, g->along,
             has_law ? "laws: {lift: {period: 360 deg, segments: [{formula: {to: 360 deg, s: \"0.6 m * (1 - cos(x)) + "
                       "0.25 m * sin(2*x)\"}}]}}\ndrives: {s: {law: lift, of: tb}, "
                     : "gears: {g: {mesh: [a, c], teeth: [20, 20], carrier: b}}\ndrives: {",
             g->turn, g->b - g->turn, g->c - g->b, g->s);
    return machine_parse_with(text, NULL, 0);
}

// Returns what vanishes where the guide is met: with the gear, how far it is from the line; with the law, by how much
// its distance from the pin of c is off.
static double guide_miss(const Guide *g, double b, bool has_law)
{
    YkVec way, E = guide_of(g), from = line_at(g, b, &way);
    if (!has_law) return yk_cross(way, yk_sub(E, from));
    YkVec C = yk_add(yk_scale(g->crank, yk_unit(g->turn)), yk_scale(g->link, yk_unit(b)));
    YkVec arm = yk_add(yk_vec(0, g->off), yk_scale(lift_at(g, b), yk_unit(g->along)));
    return yk_norm(yk_sub(E, C)) - yk_norm(arm);
}

static size_t check_guide(uint64_t *seed, bool has_law)
{
    Guide g = {.crank = check_uniform(seed, 0.5, 2), .turn = check_uniform(seed, -3, 3)};
    g.link = check_uniform(seed, 0.5, 2), g.b = check_uniform(seed, -3, 3), g.c = check_uniform(seed, -3, 3);
    g.along = check_uniform(seed, 0, 3), g.off = check_uniform(seed, -0.5, 0.5);
    g.s = check_uniform(seed, -2, 2);
    if (has_law) g.s = lift_at(&g, g.b);
    Machine m = guide_machine(&g, has_law);
    assert_true(yk_state_set_time(m.state, 0, m.problems) >= 0 && yk_state_assemble(m.state) >= 0);
    YkConfigurations *all = yk_configurations_new(m.mech);
    YkConfigurationsReport r;
    size_t count = 0, walked = 0;
    assert_int_equal(yk_configurations_each(all, m.state, NULL, count_one, &count, &r), YK_OK);
    for (int j = 0; j < STEPS; j++)
        walked += (guide_miss(&g, 2 * YK_PI * j / STEPS, has_law) > 0) !=
                  (guide_miss(&g, 2 * YK_PI * (j + 1) / STEPS, has_law) > 0);
    if (!r.complete || count != walked) print_error("%zu, walked %zu: %s\n", count, walked, r.message);
    assert_true(r.complete);
    assert_int_equal(r.reason, YK_COMPLETE_BY_EXCLUSION);
    assert_int_equal(count, walked);
    yk_configurations_free(all);
    machine_free(&m);
    return count;
}

static void test_a_slide_that_turns_with_a_wheel_is_excluded(void **unused)
{
    (void)unused;
    uint64_t seed = 51;
    size_t most = 0;
    for (size_t k = 0, cases = check_cases(20); k < cases; k++) {
        size_t count = check_guide(&seed, false);
        most = count > most ? count : most;
    }
    assert_true(most >= 4);
}

static void test_a_law_that_a_link_moves_is_excluded(void **unused)
{
    (void)unused;
    uint64_t seed = 61;
    size_t most = 0;
    for (size_t k = 0, cases = check_cases(20); k < cases; k++) {
        size_t count = check_guide(&seed, true);
        most = count > most ? count : most;
    }
    assert_true(most >= 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_all_poses_of_two_gears_in_a_loop_are_found),
                                       cmocka_unit_test(test_a_belt_and_a_gear_hold_three_links),
                                       cmocka_unit_test(test_a_slide_that_turns_with_a_wheel_is_excluded),
                                       cmocka_unit_test(test_a_law_that_a_link_moves_is_excluded),
                                       cmocka_unit_test(test_all_poses_of_a_rack_in_loops_are_found)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
