// The same bits for one lane and for many, in any cut, on any instruction set, from any compiler at any optimisation.
#include "lanes_check.h"

enum { INPUTS = 40, OUTPUTS = 147 };
typedef struct Machine {
    double in[INPUTS][LANES], out[OUTPUTS][LANES];
} Machine;

// Inputs by basic arithmetic alone: no library's cosine may have a say.
static void fill(Machine *m)
{
    uint64_t seed = 2024;
    for (size_t k = 0; k < INPUTS; k++)
        for (size_t i = 0; i < LANES; i++) m->in[k][i] = check_uniform(&seed, -2, 2);
    for (size_t k = 0; k < OUTPUTS; k++)
        for (size_t i = 0; i < LANES; i++) m->out[k][i] = 1;
}

static double *row(Machine *m, size_t *next, size_t at)
{
    return m->out[(*next)++] + at;
}
static YkTurn turn(Machine *m, size_t *next, size_t at)
{
    double *c = row(m, next, at), *s = row(m, next, at), *w = row(m, next, at), *a = row(m, next, at);
    return (YkTurn){c, s, w, a};
}
static YkSlide slide(Machine *m, size_t *next, size_t at)
{
    double *d = row(m, next, at), *v = row(m, next, at), *a = row(m, next, at);
    return (YkSlide){d, v, a};
}
static YkPlane input_plane(Machine *m, size_t k, size_t at)
{
    return (YkPlane){m->in[k] + at,     m->in[k + 1] + at, m->in[k + 2] + at,
                     m->in[k + 3] + at, m->in[k + 4] + at, m->in[k + 5] + at};
}
static YkPlane plane(Machine *m, size_t *next, size_t at)
{
    double *r[6];
    for (size_t k = 0; k < 6; k++) r[k] = row(m, next, at);
    return (YkPlane){r[0], r[1], r[2], r[3], r[4], r[5]};
}

// Zeros of either sign where a dyad does not close.
static void mask_rates(YkTurn first, YkTurn second, const double *margin, size_t n)
{
    double *rates[] = {first.w, first.a, second.w, second.a};
    for (size_t k = 0; k < 4; k++) yk_lanes_mask(rates[k], margin, 1e-12, n);
}

// The dyads that work out their known part themselves, or (apart) from its lanes.
static void run_turned(Machine *m, size_t *next, size_t at, bool apart, size_t n)
{
    YkTurn base = {m->in[23] + at, m->in[24] + at, m->in[25] + at, m->in[26] + at}, ground = {0}, t[5];
    YkTurned K = {{0.3, -0.4}, 0.8, base};
    YkSlide d[3];
    YkPlane sum = plane(m, next, at);
    YkVec U = {1.5, 0.25}, W = {2, 0}, u = {0.6, 0.8}, x = {-1, 0};
    YkArm arm_U = {.constant = U}, arm_W = {.constant = W};
    double *margin = row(m, next, at), *own = row(m, next, at);
    for (size_t k = 0; k < 5; k++) t[k] = turn(m, next, at);
    for (size_t k = 0; k < 3; k++) d[k] = slide(m, next, at);
    yk_lanes_start_turn(sum, K.constant, base, yk_vec(K.along, 0), n);
    if (apart)
        yk_lanes_rrr(sum, arm_U, arm_W, 1, t[0], t[1], margin, own, n);
    else
        yk_lanes_rrr_turned(&K, arm_U, arm_W, 1, t[0], t[1], margin, own, n);
    mask_rates(t[0], t[1], own, n);
    if (apart) {
        yk_lanes_rrp(sum, arm_W, ground, x, -1, t[2], d[0], margin, NULL, n);
        yk_lanes_rrp(sum, arm_U, t[1], u, 1, t[3], d[1], margin, NULL, n);
        yk_lanes_rpr(sum, arm_U, ground, u, 1, t[4], d[2], margin, NULL, n);
    } else {
        yk_lanes_rrp_turned(&K, arm_W, ground, x, -1, t[2], d[0], margin, NULL, n);
        yk_lanes_rrp_turned(&K, arm_U, t[1], u, 1, t[3], d[1], margin, NULL, n);
        yk_lanes_rpr_turned(&K, arm_U, u, 1, t[4], d[2], margin, NULL, n);
    }
    assert_true(*next <= OUTPUTS);
}

// Every kernel once, on the lanes from `at`.
static void run(Machine *m, size_t at, size_t n)
{
    size_t next = 0;
    YkTurn ground = {0}, one = turn(m, &next, at), two = turn(m, &next, at), both = turn(m, &next, at);
    YkPlane K = input_plane(m, 0, at), sum = plane(m, &next, at), place = plane(m, &next, at);
    YkArm U = {.constant = {1.5, 0.25}}, W = {.constant = {-0.5, 1}}, varying = {.lanes = input_plane(m, 6, at)},
          zero = {0};
    YkVec u = {0.6, 0.8};
    double *margin = row(m, &next, at);
    yk_lanes_turn(one, ground, m->in[12] + at, m->in[13] + at, m->in[14] + at, 0.5, -1, n);
    yk_lanes_turn(two, one, m->in[15] + at, m->in[16] + at, NULL, 0, 1, n);
    yk_lanes_compose(both, one, two, n);
    yk_lanes_start(sum, u, K, input_plane(m, 6, at), n);
    yk_lanes_start_turn(place, u, one, U.constant, n);
    yk_lanes_add_turn(sum, two, W.constant, n);
    yk_lanes_add_slide(sum, both, u, (YkSlide){m->in[17] + at, m->in[18] + at, m->in[19] + at}, n);
    yk_lanes_add_slide(sum, ground, u, (YkSlide){m->in[20] + at, m->in[21] + at, m->in[22] + at}, n);
    YkTurn first = turn(m, &next, at), second = turn(m, &next, at), t[4];
    YkSlide d[4];
    double *own[5]; // rows are taken in statements of their own: arguments are evaluated in any order
    for (size_t k = 0; k < 4; k++) t[k] = turn(m, &next, at), d[k] = slide(m, &next, at);
    for (size_t k = 0; k < 5; k++) own[k] = row(m, &next, at);
    yk_lanes_rrr(K, U, W, 1, first, second, margin, own[4], n);
    mask_rates(first, second, own[4], n);
    yk_lanes_rrp(sum, U, one, u, -1, t[0], d[0], margin, own[0], n);
    yk_lanes_rrp(place, W, ground, u, 1, t[1], d[1], margin, own[1], n);
    yk_lanes_rpr(K, zero, ground, u, -1, t[2], d[2], margin, own[2], n);
    yk_lanes_rpr(K, varying, two, u, 1, t[3], d[3], margin, own[3], n);
    YkVec x = {-1, 0};
    YkPlane axial = plane(m, &next, at);
    YkTurn t_axial[2];
    YkSlide d_axial[2];
    for (size_t k = 0; k < 2; k++) t_axial[k] = turn(m, &next, at), d_axial[k] = slide(m, &next, at);
    yk_lanes_start_turn(axial, u, two, x, n);
    yk_lanes_add_turn(axial, one, x, n);
    yk_lanes_rrp(axial, (YkArm){.constant = {2, 0}}, ground, x, -1, t_axial[0], d_axial[0], margin, NULL, n);
    yk_lanes_rpr(axial, zero, ground, x, 1, t_axial[1], d_axial[1], margin, NULL, n);
    YkSlide d1 = slide(m, &next, at), d2 = slide(m, &next, at);
    yk_lanes_pp(K, one, u, ground, u, d1, d2, margin, NULL, n);
    yk_lanes_pp_rates(K, one, u, ground, u, d1, d2, n);
    yk_lanes_angle(row(m, &next, at), one, first, 0.25, 9, n);
    yk_lanes_angle(row(m, &next, at), ground, second, 0, 0, n);
    yk_lanes_difference(row(m, &next, at), first.w, second.w, n);
    yk_lanes_gap(place, row(m, &next, at), n);
    run_turned(m, &next, at, false, n);
}

// What did not close is garbage and may be any NaN: masked, as the engine does.
static void mask_all(Machine *m)
{
    double margin[LANES];
    for (size_t i = 0; i < LANES; i++) {
        margin[i] = 1;
        for (size_t k = 0; k < OUTPUTS; k++)
            if (!isfinite(m->out[k][i])) margin[i] = -1;
    }
    for (size_t k = 0; k < OUTPUTS; k++) yk_lanes_mask(m->out[k], margin, 0, LANES);
}

static void a_turned_vector_gives_the_bits_of_its_lanes(void **state)
{
    (void)state;
    static Machine whole, apart;
    size_t next[2] = {0, 0};
    fill(&whole);
    fill(&apart);
    run_turned(&whole, &next[0], 0, false, LANES);
    run_turned(&apart, &next[1], 0, true, LANES);
    mask_all(&whole);
    mask_all(&apart);
    assert_memory_equal(whole.out, apart.out, sizeof whole.out);
}

static void any_cut_into_blocks_has_the_same_bits(void **state)
{
    (void)state;
    static Machine whole, cut;
    fill(&whole);
    run(&whole, 0, LANES);
    mask_all(&whole);
    const size_t sizes[] = {1, 2, 3, 5, 7, 8, 9, 16, 17, 31, 64, 100, 256};
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        fill(&cut);
        for (size_t at = 0; at < LANES; at += sizes[k]) run(&cut, at, LANES - at < sizes[k] ? LANES - at : sizes[k]);
        mask_all(&cut);
        assert_memory_equal(cut.out, whole.out, sizeof whole.out);
    }
}

// The digest (FNV-1a) was the same from gcc 12 and clang 14, at -O0, -O2 and -O3, with SSE2, AVX2 and AVX-512.
static void bits_are_the_same_everywhere(void **state)
{
    (void)state;
    static Machine m;
    fill(&m);
    run(&m, 0, LANES);
    mask_all(&m);
    size_t closed = 0;
    for (size_t i = 0; i < LANES; i++) closed += m.out[0][i] != 0;
    assert_true(closed > LANES / 2); // the digest is of numbers, not of zeros
    const unsigned char *bytes = (const unsigned char *)m.out;
    uint64_t digest = 0xcbf29ce484222325u;
    for (size_t i = 0; i < sizeof m.out; i++) digest = (digest ^ bytes[i]) * 0x100000001b3u;
    const uint64_t expected = 0xdffd63ba0b584026u;
    if (digest != expected) print_error("digest 0x%016llx\n", (unsigned long long)digest);
    assert_true(digest == expected);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_turned_vector_gives_the_bits_of_its_lanes),
        cmocka_unit_test(any_cut_into_blocks_has_the_same_bits),
        cmocka_unit_test(bits_are_the_same_everywhere),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
