// Which bodies have a moment equation, counted by hand: those on which all forces meet in the centre of mass have none.
#include "rig.h"

static YkEquationCount count_of(const char *text)
{
    Rig rig = rig_of_text(text);
    YkEquationCount c = yk_dynamics_count(rig.dynamics);
    assert_int_equal(c.force + c.moment + c.acceleration,
                     c.unknown_reactions + c.unknown_accelerations + c.unknown_efforts);
    rig_free(&rig);
    return c;
}

// A rod on a crank slides through a block that swings about its centre: crank, rod, wheel; and the block where
// something turns it.
#define SWINGING(BLOCK, PIN, MORE)                                                                                     \
    "bodies:\n  ground: {points: {C: [0, 0], O: [0.5, 0], W: [0.8, 0]}}\n"                                             \
    "  crank: {points: {C: [0, 0], A: [0.1, 0]}, mass: 1}\n  rod: {points: {A: [0, 0]}, mass: 2}\n"                    \
    "  block: {points: {O: " BLOCK ", P: [0.05, 0.02]}, mass: 1}\n  wheel: {points: {W: [0, 0]}, mass: 1}\njoints:\n"  \
    "  C: {pin: [ground, crank], angle: q}\n  A: {pin: [crank, rod], angle: a}\n  O: " PIN "\n"                        \
    "  S: {slide: [rod, block], along: x, from: A, to: O, distance: s}\n  W: {pin: [ground, wheel], angle: w}\n" MORE  \
    "start: {q: 60 deg, a: -70 deg, s: 0.46}\n"
#define PINNED "{pin: [ground, block]}"

static void a_swinging_block_has_a_moment_where_something_turns_it(void **unused)
{
    (void)unused;
    static const struct {
        const char *text;
        size_t moments;
    } cases[] = {
        {SWINGING("[0, 0]", PINNED, ""), 3},
        {SWINGING("[0.01, 0]", PINNED, ""), 4}, // its centre is elsewhere
        {SWINGING("[0, 0]", "{pin: [ground, block], friction: {viscous: 1}}", ""), 4},
        {SWINGING("[0, 0]", "{pin: [block, ground], friction: {viscous: 1}}", ""), 4},
        {SWINGING("[0, 0]", PINNED, "efforts: {s: 3 N}\n"), 3}, // along the guide
        {SWINGING("[0, 0]", PINNED, "efforts: {q: 3 N*m, w: 2 N*m}\n"), 3},
        {SWINGING("[0, 0]", PINNED, "forces: {f: {body: block, at: P, value: [1 N, 0]}}\n"), 4},
        {SWINGING("[0, 0]", PINNED, "forces: {f: {body: wheel, at: W, value: [1 N, 0]}}\n"), 3},
        {SWINGING("[0, 0]", PINNED, "springs: {k: {between: [block.P, ground.C], stiffness: 5 N/m}}\n"), 4},
        {SWINGING("[0, 0]", PINNED, "springs: {k: {between: [ground.C, block.P], stiffness: 5 N/m}}\n"), 4},
        {SWINGING("[0, 0]", PINNED, "springs: {k: {between: [ground.C, crank.A], stiffness: 5 N/m}}\n"), 3},
        {SWINGING("[0, 0]", PINNED, "gears: {g: {mesh: [block, wheel], teeth: [20, 20]}}\n"), 4},
        {SWINGING("[0, 0]", PINNED, "gears: {g: {mesh: [wheel, block], teeth: [20, 20]}}\n"), 4},
        {SWINGING("[0, 0]", PINNED, "belts: {b: {between: [block, wheel], radii: [50 mm, 50 mm]}}\n"), 4},
        {SWINGING("[0, 0]", PINNED, "belts: {b: {between: [wheel, block], radii: [50 mm, 50 mm]}}\n"), 4},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        YkEquationCount c = count_of(cases[k].text);
        if (c.moment != cases[k].moments) print_error("%s", cases[k].text);
        assert_int_equal(c.moment, cases[k].moments);
        assert_int_equal(c.force, 8);
    }
}

#define SLIDER(MORE)                                                                                                   \
    "bodies:\n  ground: {points: {O: [0, 0]}}\n  shaft: {points: {O: [0, 0]}, mass: 1}\n  tappet: {mass: "             \
    "3}\njoints:\n"                                                                                                    \
    "  K: {pin: [ground, shaft], angle: q}\n  T: {slide: [ground, tappet], along: x, distance: s}\n" MORE
#define LIFT "laws: {lift: {period: 2*pi, segments: [{formula: {to: 2*pi, s: 5 mm*(1 - cos(x))}}]}}\n"

// What acts on a slider beside its guide turns it: teeth, a cam. Another joint may as well.
static void a_slider_has_a_moment_where_a_wheel_moves_it(void **unused)
{
    (void)unused;
    assert_int_equal(count_of(SLIDER("")).moment, 1);
    assert_int_equal(count_of(SLIDER("racks: {r: {pinion: shaft, rack: tappet, radius: 20 mm}}\n")).moment, 2);
    assert_int_equal(
        count_of(SLIDER(LIFT "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 40 mm, face: flat}}\n")).moment,
        2);
}

// Pins that share a place on a body are one junction: n pins of n + 1 bodies, with two forces each.
static void pins_in_one_place_are_a_junction(void **unused)
{
    (void)unused;
    for (int n = 1; n <= 4; n++) {
        char text[2000];
        int at =
            snprintf(text, sizeof text,
                     "bodies:\n  ground: {points: {O: [0, 0]}}\n  hub: {points: {O: [0, 0], A: [1, 0]}, mass: 1}\n");
        for (int k = 0; k < n; k++)
            at += snprintf(text + at, sizeof text - (size_t)at, "  arm%d: {points: {A: [0, 0]}, mass: 1}\n", k);
        at += snprintf(text + at, sizeof text - (size_t)at, "joints:\n  O: {pin: [ground, hub]}\n");
        for (int k = 0; k < n; k++) // from arm to arm, as from the hub
            at += k % 2 ? snprintf(text + at, sizeof text - (size_t)at, "  A%d: {pin: [arm%d, arm%d], at: A}\n", k,
                                   k - 1, k)
                        : snprintf(text + at, sizeof text - (size_t)at, "  A%d: {pin: [hub, arm%d], at: A}\n", k, k);
        YkEquationCount c = count_of(text);
        size_t bodies = (size_t)n + 1, junction = n > 1;
        assert_int_equal(c.force, 2 * (bodies + junction));
        assert_int_equal(c.moment, bodies);
        assert_int_equal(c.unknown_reactions, 2 * (bodies + junction));
        assert_int_equal(c.unknown_accelerations, bodies);
    }
}

// Whichever joints close the loops: with the joints in every order there are as many equations as unknowns, and as many
// forces and moments.
static void the_order_of_joints_changes_nothing(void **unused)
{
    (void)unused;
    static const char *const joints[] = {"  C: {pin: [ground, crank], angle: q}\n",
                                         "  A: {pin: [crank, rod], angle: a}\n", "  O: {pin: [ground, block]}\n",
                                         "  S: {slide: [rod, block], along: x, from: A, to: O, distance: s}\n",
                                         "  W: {slide: [block, tail], along: y}\n"};
    for (int order = 0; order < 120; order++) {
        char text[1500];
        int at =
            snprintf(text, sizeof text,
                     "bodies:\n  ground: {points: {C: [0, 0], O: [0.5, 0]}}\n  tail: {mass: 2}\n"
                     "  crank: {points: {C: [0, 0], A: [0.1, 0]}, mass: 1}\n  rod: {points: {A: [0, 0]}, mass: 2}\n"
                     "  block: {points: {O: [0, 0]}, mass: 1}\njoints:\n");
        bool is_used[5] = {false};
        for (int k = 5, rest = order; k > 0; rest /= k, k--) {
            int skip = rest % k, j = 0;
            while (is_used[j] || skip-- > 0) j++;
            is_used[j] = true;
            at += snprintf(text + at, sizeof text - (size_t)at, "%s", joints[j]);
        }
        snprintf(text + at, sizeof text - (size_t)at, "start: {q: 60 deg, a: -70 deg, s: 0.46}\n");
        YkEquationCount c = count_of(text);
        assert_int_equal(c.force, 8);
        assert_int_equal(c.moment, 3); // the tail is guided at its centre
        assert_int_equal(c.unknown_reactions, 9);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_swinging_block_has_a_moment_where_something_turns_it),
        cmocka_unit_test(a_slider_has_a_moment_where_a_wheel_moves_it),
        cmocka_unit_test(pins_in_one_place_are_a_junction),
        cmocka_unit_test(the_order_of_joints_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
