// Elements that are alike are written from one pattern: the same text as without it, and no element made for it.
#include "ring/inside.h"
#include "ring_check.h"

enum { BODIES = 40, ROLES = 3 }; // enough symbols for the ring to keep patterns

typedef struct Bodies {
    YkRing *ring;
    int32_t mass[BODIES], length[BODIES], angle[BODIES], rate[BODIES];
} Bodies;

static Bodies bodies_new(void)
{
    Bodies all = {.ring = yk_ring_new()};
    assert_non_null(all.ring);
    for (int b = 0; b < BODIES; b++) {
        char name[3][8];
        for (int k = 0; k < 3; k++) snprintf(name[k], sizeof name[k], "%s%d", (const char *[]){"m", "l", "q"}[k], b);
        all.mass[b] = yk_ring_symbol(all.ring, name[0], YK_RING_MASS);
        all.length[b] = yk_ring_symbol(all.ring, name[1], YK_RING_CONSTANT);
        all.angle[b] = yk_ring_angle(all.ring, name[2]);
        all.rate[b] = yk_ring_rates(all.ring, all.angle[b]);
    }
    assert_int_equal(yk_ring_status(all.ring), YK_RING_OK);
    return all;
}

// The seed decides the shape, the roles the names.
static Element shaped(const Bodies *all, uint64_t seed, const int role[ROLES])
{
    YkRing *ring = all->ring;
    Fixture f = {.ring = ring, .seed = seed};
    Element sum = yk_ring_rational(ring, 0, 1);
    for (int terms = 1 + below(&f, 5); terms > 0; terms--) {
        Element term = yk_ring_rational(ring, below(&f, 9) - 4, 1 + below(&f, 3));
        for (int i = below(&f, 4); i > 0; i--) {
            int b = role[below(&f, ROLES)];
            const int32_t symbols[] = {all->mass[b], all->length[b], all->rate[b], all->rate[b] + 1};
            term = yk_ring_multiply(ring, term, yk_ring_of(ring, symbols[below(&f, 4)]));
        }
        YkAngleTerm angle = {all->angle[role[below(&f, ROLES)]], below(&f, 3) - 1};
        term = yk_ring_multiply(ring, term, yk_ring_exp(ring, &angle, 1));
        if (below(&f, 3) == 0) term = yk_ring_multiply(ring, term, yk_ring_i(ring));
        sum = yk_ring_add(ring, sum, term);
    }
    return sum;
}

// The first body's angle is the sum of the others', as in joint form.
static YkRingChanges *changes_of(const Bodies *all, const int role[ROLES])
{
    YkRing *ring = all->ring;
    int a = role[0], b = role[1], c = role[2];
    const YkAngleTerm terms[] = {{all->angle[b], 1}, {all->angle[c], 1}};
    YkRingChange changes[3] = {{.symbol = all->angle[a], .unit = yk_ring_exp(ring, terms, 2)}};
    for (int order = 0; order < 2; order++)
        changes[1 + order] = (YkRingChange){
            .symbol = all->rate[a] + order,
            .value = yk_ring_add(ring, yk_ring_of(ring, all->rate[b] + order), yk_ring_of(ring, all->rate[c] + order))};
    return yk_ring_changes(ring, changes, 3);
}

static YkRingView view_of(const Bodies *all, uint64_t seed, const int role[ROLES])
{
    return (YkRingView){.of = shaped(all, seed, role),
                        .changes = seed % 2 ? changes_of(all, role) : NULL,
                        .side = (YkRingSide)(seed % 3)};
}

static void pick(uint64_t *seed, int role[ROLES])
{
    role[0] = (int)(check_random(seed) % BODIES);
    do role[1] = (int)(check_random(seed) % BODIES);
    while (role[1] == role[0]);
    do role[2] = (int)(check_random(seed) % BODIES);
    while (role[2] == role[0] || role[2] == role[1]);
}

// Writes a shape in a ring that may have written it before, and in a new one.
static void check_shape(const Bodies *all, uint64_t shape, const int role[ROLES], YkRingFormat format,
                        YkRingStyle style)
{
    Bodies alone = bodies_new();
    YkText text = {0}, expected = {0};
    const YkRingView view = view_of(all, shape, role), own = view_of(&alone, shape, role);
    assert_true(yk_ring_write_view(all->ring, &view, format, style, &text));
    assert_true(yk_ring_write_view(alone.ring, &own, format, style, &expected));
    assert_string_equal(yk_text_get(&text), yk_text_get(&expected));
    check_same(all->ring, read_as(all->ring, format, yk_text_get(&text)), yk_ring_view(all->ring, &view));
    yk_text_free(&text);
    yk_text_free(&expected);
    yk_ring_free(alone.ring);
}

static void what_a_pattern_writes_is_what_is_written_without_it(void **state)
{
    (void)state;
    static const YkRingFormat formats[] = {YK_RING_TEXT, YK_RING_BOOK, YK_RING_LATEX};
    uint64_t seed = 1;
    for (uint64_t shape = 0; shape < check_cases(600); shape++) {
        Bodies all = bodies_new();
        for (int k = 0; k < 4; k++) {
            int role[ROLES];
            pick(&seed, role);
            bool in_c = shape % 3 > 0 && shape % 5 == 0; // x and y are real
            check_shape(&all, shape, role, in_c ? YK_RING_C : formats[shape / 2 % 3],
                        (YkRingStyle)(shape / 6 % YK_RING_STYLES));
        }
        yk_ring_free(all.ring);
    }
}

static void no_element_is_made_for_one_that_is_alike(void **state)
{
    (void)state;
    Bodies all = bodies_new();
    size_t made[3];
    for (int b = 0; b < 3; b++) {
        const int role[ROLES] = {b + 2, b, b + 1};
        YkText text = {0};
        YkRing *ring = all.ring;
        Element unit = yk_ring_unit(ring, all.angle[role[0]]);
        Element a = yk_ring_multiply(ring, unit, yk_ring_of(ring, all.rate[role[0]]));
        const YkRingView view = {a, changes_of(&all, role), YK_RING_X};
        size_t before = ring->made;
        assert_true(yk_ring_write_view(ring, &view, YK_RING_BOOK, YK_RING_TEXTBOOK, &text));
        made[b] = ring->made - before;
        YkText expected = {0};
        yk_text_format(&expected, "cos(q%d + q%d) (q%d' + q%d')", b, b + 1, b, b + 1);
        assert_string_equal(yk_text_get(&text), yk_text_get(&expected));
        yk_text_free(&expected);
        yk_text_free(&text);
    }
    assert_true(made[0] > 0);
    assert_int_equal(made[1], 0);
    assert_int_equal(made[2], 0);
    yk_ring_free(all.ring);
}

static void check_book(YkRing *ring, Element a, const char *expected)
{
    check_written(ring, a, YK_RING_BOOK, YK_RING_TEXTBOOK, expected);
}

static void what_differs_in_more_than_names_is_not_alike(void **state)
{
    (void)state;
    Bodies all = bodies_new();
    YkRing *r = all.ring;
    Element m[4], l[4];
    for (int b = 0; b < 4; b++) m[b] = yk_ring_of(r, all.mass[b]), l[b] = yk_ring_of(r, all.length[b]);
    check_book(r, yk_ring_add(r, m[0], m[1]), "m0 + m1"); // order
    check_book(r, yk_ring_add(r, m[3], m[2]), "m2 + m3");
    check_book(r, yk_ring_multiply(r, l[0], l[1]), "l0 l1"); // class
    check_book(r, yk_ring_multiply(r, l[0], m[1]), "m1 l0");
    check_book(r, l[0], "l0"); // number and root
    check_book(r, yk_ring_scale(r, l[1], 1, 2), "1/2 l1");
    check_book(r, yk_ring_scale(r, l[2], 1, 3), "1/3 l2");
    check_book(r, yk_ring_multiply(r, yk_ring_sqrt(r, 2), l[3]), "sqrt(2) l3");
    check_book(r, yk_ring_power(r, l[0], 2), "l0^2"); // exponent
    check_book(r, yk_ring_power(r, l[1], 3), "l1^3");
    check_book(r, yk_ring_real(r, yk_ring_turn(r, 1, 7)), "cos(pi/7)"); // angle without a symbol of the file
    check_book(r, yk_ring_real(r, yk_ring_turn(r, 1, 9)), "cos(pi/9)");
    Element sum = yk_ring_multiply(r, yk_ring_add(r, m[0], m[1]), l[2]); // format and style
    check_book(r, sum, "(m0 + m1) l2");
    check_written(r, sum, YK_RING_TEXT, YK_RING_TEXTBOOK, "(m0 + m1)*l2");
    check_written(r, sum, YK_RING_BOOK, YK_RING_EXPANDED, "m0 l2 + m1 l2");
    yk_ring_free(r);
}

// An angle is a factor, or turns what it is in the exponent of.
static void an_angle_by_itself_is_not_alike_to_its_cosine(void **state)
{
    (void)state;
    static const char *const expected[] = {"q0", "cos(q1)", "q2", "cos(q3)"};
    Bodies all = bodies_new();
    for (int k = 0; k < 4; k++) {
        Element a = k % 2 ? yk_ring_unit(all.ring, all.angle[k]) : yk_ring_of(all.ring, all.angle[k]);
        const YkRingView view = {a, NULL, YK_RING_X};
        YkText text = {0};
        assert_true(yk_ring_write_view(all.ring, &view, YK_RING_BOOK, YK_RING_TEXTBOOK, &text));
        assert_string_equal(yk_text_get(&text), expected[k]);
        yk_text_free(&text);
    }
    yk_ring_free(all.ring);
}

static void the_changes_and_the_side_decide_as_well(void **state)
{
    (void)state;
    static const char *const expected[2][2] = {{"cos(q1 + q2)", "sin(q1 + q2)"}, {"cos(q0)", "sin(q0)"}};
    Bodies all = bodies_new();
    Element unit = yk_ring_unit(all.ring, all.angle[0]);
    YkRingChanges *const changes[] = {changes_of(&all, (const int[]){0, 1, 2}),
                                      changes_of(&all, (const int[]){3, 1, 2})};
    for (int k = 0; k < 8; k++) {
        const YkRingView view = {unit, changes[k / 2 % 2], k % 2 ? YK_RING_Y : YK_RING_X};
        YkText text = {0};
        assert_true(yk_ring_write_view(all.ring, &view, YK_RING_BOOK, YK_RING_TEXTBOOK, &text));
        assert_string_equal(yk_text_get(&text), expected[k / 2 % 2][k % 2]);
        yk_text_free(&text);
    }
    yk_ring_free(all.ring);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_a_pattern_writes_is_what_is_written_without_it),
        cmocka_unit_test(no_element_is_made_for_one_that_is_alike),
        cmocka_unit_test(what_differs_in_more_than_names_is_not_alike),
        cmocka_unit_test(an_angle_by_itself_is_not_alike_to_its_cosine),
        cmocka_unit_test(the_changes_and_the_side_decide_as_well),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
