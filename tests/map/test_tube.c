// Tubes: what they claim holds at places between, where the solution is found anew; and where no tube can be, none is
// made.
#include "map/tube.h"
#include <stdlib.h>
#include "configurations/truss.h"
#include "solve/state.h"

enum { RANDOM_TRIES = 40, PLACES = 9 };

typedef struct Chain {
    Machine m;
    YkDiscs discs;
    YkPiece piece; // the machine's only block
    double from[1], way[1];
} Chain;

static void start(Chain *c, uint64_t seed)
{
    Truss truss = {.links = "hbc ha ad be cf def"}; // a crank and a triad
    truss_scatter(&truss, seed);
    c->m = truss_machine(&truss);
    yk_state_free(c->m.state);
    yk_mechanism_free(c->m.mech);
    machine_compile(&c->m, "h3.angle");
    assert_true(yk_state_assemble(c->m.state) >= 0 && c->m.mech->block_count == 1);
    assert_true(yk_discs_start(&c->discs, c->m.mech));
    c->from[0] = yk_state_input(c->m.state, 0).position;
    c->way[0] = 1;
    c->discs.others = c->from;
    c->discs.ways = c->way;
}

static void stop(Chain *c)
{
    yk_discs_end(&c->discs);
    machine_free(&c->m);
}

// Reads the coefficients over [middle - half, middle + half].
static void read_coefficients(Chain *c, double middle, double half, YkDiscCoefficients *out)
{
    c->discs.input = yk_ball(yk_vec(middle, 0), half);
    for (size_t k = 0; k < c->m.mech->step_count; k++) {
        const YkStep *step = &c->m.mech->steps[k];
        if (step->kind == YK_STEP_BLOCK) {
            assert_int_equal(yk_piece_read(&c->piece, c->m.mech, k), YK_PIECE_READ);
            yk_piece_coefficients(&c->piece, &c->discs, out);
            return;
        }
        yk_discs_take(&c->discs, step);
    }
}

static void read_pose(const Chain *c, YkVec *x)
{
    const YkMechanism *mech = c->m.mech;
    for (size_t k = 0; k < c->piece.shape.unknowns; k++) {
        YkTurn t = yk_space_turn(&c->m.state->space, mech->group_columns[c->piece.shape.column[k]].index);
        x[k] = yk_vec(t.c[0], t.s[0]);
    }
}

static double turn_between(YkVec a, YkVec b)
{
    YkVec turn = yk_mul(yk_conj(a), b);
    return yk_atan2(turn.y, turn.x);
}

// Solves at a place, from the line of a tube.
static bool solve_at(Chain *c, const YkTube *tube, double at, YkTube *point)
{
    YkDiscCoefficients *own = malloc(sizeof *own);
    assert_non_null(own);
    read_coefficients(c, at, 0, own);
    yk_tube_at(&c->piece, tube, at, point->x);
    point->middle = at;
    bool found = yk_tube_make(&c->piece, own, NULL, 0, point);
    free(own);
    return found;
}

typedef struct Count {
    const Chain *c;
    const YkTube *tube;
    double at;
    size_t inside;
} Count;

static bool count_inside(void *context, YkState *state)
{
    Count *count = context;
    YkVec x[YK_PIECE_UNKNOWNS];
    assert_ptr_equal(state, count->c->m.state);
    read_pose(count->c, x);
    count->inside += yk_tube_contains(&count->c->piece, count->tube, count->at, x, 1e-12);
    return true;
}

// Of all configurations, enumerated in another way, one is in the tube.
static void check_alone(Chain *c, YkConfigurations *all, const YkTube *tube, double at)
{
    Count count = {c, tube, at, 0};
    YkConfigurationsReport report;
    yk_state_set_input(c->m.state, 0, (YkMotion){c->from[0] + at, 0, 0});
    yk_configurations_each(all, c->m.state, NULL, count_inside, &count, &report);
    if (report.complete) assert_int_equal(count.inside, 1);
}

// Returns whether a tube of that length was made; what it claims is then checked.
static bool check_tube(Chain *c, YkConfigurations *all, double half, double *tightest)
{
    YkDiscCoefficients *middle = malloc(sizeof *middle), *over = malloc(sizeof *over);
    assert_true(middle && over);
    read_coefficients(c, half, half, over);
    read_coefficients(c, half, 0, middle);
    YkTube tube = {.middle = half}, point = {.middle = 0}, ahead = point, behind = point;
    read_pose(c, tube.x);
    bool is_made = yk_tube_make(&c->piece, middle, over, half, &tube);
    for (size_t p = 0; is_made && p < PLACES; p++) {
        const double d = 1e-5;
        double at = 2 * half * (double)p / (PLACES - 1), off = 0, off_rate = 0;
        YkVec line[YK_PIECE_UNKNOWNS];
        assert_true(solve_at(c, &tube, at, &point) && solve_at(c, &tube, at + d, &ahead) &&
                    solve_at(c, &tube, at - d, &behind));
        yk_tube_at(&c->piece, &tube, at, line);
        for (size_t k = 0; k < c->piece.shape.unknowns; k++) {
            off = fmax(off, fabs(turn_between(line[k], point.x[k])));
            double rate = turn_between(behind.x[k], ahead.x[k]) / (2 * d);
            off_rate = fmax(off_rate, fabs(rate - tube.rate[k]));
        }
        assert_true(off <= tube.within + 1e-14 && tube.within < tube.radius);
        assert_true(off_rate <= tube.rate_within * (1 + 1e-3) + 1e-5);
        assert_true(yk_tube_contains(&c->piece, &tube, at, point.x, point.within));
        assert_false(yk_tube_excludes(&c->piece, &tube, at, point.x, point.within));
        // Just outside of what the operator leaves the pose is refused, though it is in the tube.
        point.x[0] = yk_mul(line[0], yk_unit(1.2 * tube.within + 1e-10));
        assert_true(yk_tube_excludes(&c->piece, &tube, at, point.x, 0));
        check_alone(c, all, &tube, at);
        *tightest = fmax(*tightest, off / tube.within);
    }
    free(middle);
    free(over);
    return is_made;
}

static void test_solutions_lie_in_their_tubes(void **unused)
{
    (void)unused;
    static const double halves[] = {1e-4, 1e-3, 5e-3, 2e-2, 0.05, 0.1, 2};
    size_t made[7] = {0};
    double tightest = 0;
    for (uint64_t seed = 1; seed <= check_cases(RANDOM_TRIES); seed++) {
        Chain c = {.from = {0}};
        start(&c, seed);
        YkConfigurations *all = yk_configurations_new(c.m.mech);
        for (size_t h = 0; h < 7; h++) made[h] += check_tube(&c, all, halves[h], &tightest);
        yk_configurations_free(all);
        stop(&c);
    }
    print_message("made %zu %zu %zu %zu %zu %zu %zu; off by %.2f of the bound at most\n", made[0], made[1], made[2],
                  made[3], made[4], made[5], made[6], tightest);
    assert_true(made[0] >= check_cases(RANDOM_TRIES) - 1);
    assert_int_equal(made[6], 0); // no tube is as long as a turn
    assert_true(tightest > 0.05); // the bound is not far off
}

// --- a Jacobian that changes along the line

// An arm of length 1 + t and a slide, (1 + t) (e^(i angle) - e^i) + d - 2 = 0: the solution stands, at angle 1 and d =
// 2, while the Jacobian changes with t. At t = -1 every angle is a solution.
static const YkPiece growing_arm = {.shape = {.loops = 1, .angles = 1, .unknowns = 2, .turning = {-1, -1}}};

static bool make_growing(double half, YkTube *tube)
{
    YkDiscCoefficients *middle = calloc(1, sizeof *middle), *over = calloc(1, sizeof *over);
    assert_true(middle && over);
    YkVec away = yk_scale(-1, yk_unit(1)), at[] = {{1, 0}, {1, 0}, yk_sub(away, yk_vec(2, 0))};
    YkVec rate[] = {{1, 0}, {0, 0}, away};
    for (size_t k = 0; k < 3; k++) {
        middle->at[k] = over->at[k] = at[k];
        over->rate[k] = rate[k];
        middle->radius[k] = 1e-15;
        over->rate_radius[k] = k == 1 ? 0 : 1e-15;
    }
    *tube = (YkTube){.x = {yk_unit(1), {2, 0}}};
    bool is_made = yk_tube_make(&growing_arm, middle, over, half, tube);
    free(middle);
    free(over);
    return is_made;
}

static void test_a_jacobian_that_vanishes_along_the_line_has_no_tube(void **unused)
{
    (void)unused;
    YkTube tube;
    assert_true(make_growing(0.1, &tube) && make_growing(0.9, &tube));
    assert_true(tube.rate_within < 1e-9 && fabs(tube.rate[0]) < 1e-12); // the solution stands
    assert_false(make_growing(1, &tube));
    assert_false(make_growing(2.5, &tube));
}

// --- a slot that turns, in closed form

// e^(i angle) (d + i b) = c, with c = rho e^(i phi) at the time t: a slot at the distance b from its pivot. Two
// solutions, d = +s and -s with s^2 = rho^2 - b^2.
static const YkPiece slot = {.shape = {.loops = 1, .angles = 1, .unknowns = 2, .turning = {-1, 0}}};

typedef struct Slot {
    double b, rho, phi, rho_rate, phi_rate;
    double spin; // of the axes in which all is told, which changes no solution
} Slot;

static YkVec slot_end(const Slot *s, double t)
{
    return yk_scale(s->rho + t * s->rho_rate, yk_unit(s->phi + t * s->phi_rate));
}

static bool slot_solution(const Slot *s, double t, double sign, YkVec *x)
{
    double rho = s->rho + t * s->rho_rate, square = rho * rho - s->b * s->b, d = sign * sqrt(square);
    if (!(square > 0)) return false;
    x[0] = yk_scale(1 / (rho * rho), yk_mul(slot_end(s, t), yk_conj(yk_vec(d, s->b))));
    x[1] = yk_vec(d, 0);
    return true;
}

static bool make_slot(const Slot *s, double half, double sign, YkTube *tube)
{
    YkDiscCoefficients *middle = calloc(1, sizeof *middle), *over = calloc(1, sizeof *over);
    assert_true(middle && over);
    double most = fabs(s->rho) + half * fabs(s->rho_rate), w = fabs(s->phi_rate + s->spin);
    YkVec at[] = {{0, s->b}, {1, 0}, yk_scale(-1, slot_end(s, 0))};
    for (size_t k = 0; k < 3; k++) {
        middle->at[k] = over->at[k] = at[k];
        middle->radius[k] = 1e-15;
        over->rate[k] = yk_scale(s->spin, yk_quarter(at[k]));
        over->rate_radius[k] = 1e-15 + 1.0001 * half * s->spin * s->spin * yk_norm(at[k]);
    }
    over->rate[2] = yk_scale(-1, yk_mul(yk_vec(s->rho_rate, s->rho * (s->phi_rate + s->spin)), yk_unit(s->phi)));
    over->rate_radius[2] = 1e-15 + 1.0001 * half * (2 * fabs(s->rho_rate) * w + most * w * w);
    *tube = (YkTube){.middle = 0};
    bool is_made = slot_solution(s, 0, sign, tube->x) && yk_tube_make(&slot, middle, over, half, tube);
    free(middle);
    free(over);
    return is_made;
}

static void check_slot(const Slot *s, double half, double sign, double *farthest)
{
    YkTube tube;
    YkVec own[2], other[2], line[2];
    if (!make_slot(s, half, sign, &tube)) return;
    for (size_t p = 0; p < PLACES; p++) {
        double t = half * (2.0 * (double)p / (PLACES - 1) - 1);
        assert_true(slot_solution(s, t, sign, own) && slot_solution(s, t, -sign, other));
        yk_tube_at(&slot, &tube, t, line);
        double rho = s->rho + t * s->rho_rate, d = own[1].x, size = fmax(1, fabs(tube.x[1].x));
        double rate = rho * s->rho_rate / d, turn = s->phi_rate + s->b * rate / (rho * rho);
        double off = fmax(fabs(turn_between(line[0], own[0])), fabs(d - line[1].x) / size);
        double off_rate = fmax(fabs(turn - tube.rate[0]), fabs(rate - tube.rate[1]) / size);
        assert_true(off <= tube.within + 1e-14 && off_rate <= tube.rate_within + 1e-12);
        assert_true(yk_tube_contains(&slot, &tube, t, own, 1e-14) && !yk_tube_excludes(&slot, &tube, t, own, 1e-14));
        assert_false(yk_tube_contains(&slot, &tube, t, other, 0));
        double gap = fmax(fabs(turn_between(line[0], other[0])), fabs(other[1].x - line[1].x) / size);
        *farthest = fmax(*farthest, tube.radius / gap);
    }
}

static void test_slots_that_turn_have_one_solution_in_a_tube(void **unused)
{
    (void)unused;
    double farthest = 0;
    for (uint64_t seed = 1; seed <= 100 * check_cases(RANDOM_TRIES); seed++) {
        uint64_t random = seed;
        Slot s = {.b = exp(check_uniform(&random, -3, 2)), .phi = check_uniform(&random, -3, 3)};
        s.rho = s.b * (1 + exp(check_uniform(&random, -7, 2)));
        s.rho_rate = s.rho * check_uniform(&random, -1, 1);
        s.phi_rate = check_uniform(&random, -2, 2);
        s.spin = check_uniform(&random, -2, 2);
        check_slot(&s, exp(check_uniform(&random, -9, 0)), seed % 2 ? 1 : -1, &farthest);
    }
    print_message("a tube reaches %.2f of the way to the other solution at most\n", farthest);
    assert_true(farthest > 0.1 && farthest < 1); // it is not too narrow to be of use
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_solutions_lie_in_their_tubes),
        cmocka_unit_test(test_slots_that_turn_have_one_solution_in_a_tube),
        cmocka_unit_test(test_a_jacobian_that_vanishes_along_the_line_has_no_tube),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
