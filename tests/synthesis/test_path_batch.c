// Closed curves of 60 points of random four-bars and slider-cranks, found again, each answer measured by its own
// equations.
#include "synthesis/answer.h"
#include "base/vec.h"

enum { POINTS = 60 };

typedef struct Machine {
    double ground, input, coupler, output; // slider-crank: ground is the offset of its line, output 0
    double px, py, turn;
    int branch;
} Machine;

// The coupler point by trigonometry alone.
static void trace(const Machine *m, double input, double xy[2])
{
    double ax = m->input * cos(input), ay = m->input * sin(input), phi;
    if (m->output > 0) {
        double dx = m->ground - ax, dy = -ay, d2 = dx * dx + dy * dy, d = sqrt(d2);
        double b = m->coupler, c = m->output;
        phi = atan2(dy, dx) + m->branch * acos((d2 + b * b - c * c) / (2 * b * d));
    } else {
        double sine = (m->ground - ay) / m->coupler;
        phi = m->branch > 0 ? asin(sine) : YK_PI - asin(sine);
    }
    double x = ax + m->px * cos(phi) - m->py * sin(phi), y = ay + m->px * sin(phi) + m->py * cos(phi);
    xy[0] = 7 + x * cos(m->turn) - y * sin(m->turn);
    xy[1] = -2 + x * sin(m->turn) + y * cos(m->turn);
}

static Machine draw(bool is_slider, uint64_t *seed)
{
    Machine m;
    double excess, least;
    do {
        m.ground = check_uniform(seed, is_slider ? -2 : 0.5, is_slider ? 2 : 5);
        m.input = check_uniform(seed, 0.5, 5);
        m.coupler = check_uniform(seed, 0.5, 5);
        m.output = is_slider ? 0 : check_uniform(seed, 0.5, 5);
        double most = fmax(fmax(m.ground, m.input), fmax(m.coupler, m.output));
        least = fmin(fmin(m.ground, m.input), fmin(m.coupler, m.output));
        excess = 2 * (most + least) - (m.ground + m.input + m.coupler + m.output);
        if (is_slider) excess = fabs(m.ground) + m.input - m.coupler;
    } while (excess > -0.05 || (!is_slider && least != m.ground && least != m.input));
    m.px = check_uniform(seed, -4, 4);
    m.py = check_uniform(seed, -4, 4);
    m.turn = check_uniform(seed, 0, 6);
    m.branch = check_uniform(seed, -1, 1) < 0 ? -1 : 1;
    return m;
}

// Returns the best answer's root mean square distance over the size of the curve. `uneven`: how far the steps of the
// input differ.
static double found_again(const Machine *m, double uneven)
{
    char text[5000];
    double low = INFINITY, high = -INFINITY, xy[2];
    size_t at =
        (size_t)snprintf(text, sizeof text, "synthesis: path\nclosed: true\nbest: 1\nmechanisms: [%s]\npoints:\n",
                         m->output > 0 ? "four-bar" : "slider-crank");
    for (int k = 0; k < POINTS; k++) {
        double angle = 2 * YK_PI * k / POINTS;
        trace(m, angle + uneven * sin(angle), xy);
        at += (size_t)snprintf(text + at, sizeof text - at, "- [%.17g, %.17g]\n", xy[0], xy[1]);
        low = fmin(low, xy[0]);
        high = fmax(high, xy[0]);
    }
    Answer a = answer_to(text);
    double error = yk_synthesis_count(a.synthesis) > 0 ? yk_synthesis_candidate(a.synthesis, 0).error : INFINITY;
    answer_free(&a);
    return sqrt(error / POINTS) / (high - low);
}

static void curves_of_random_four_bars_are_found_again(void **state)
{
    (void)state;
    uint64_t seed = 19;
    for (int k = 0; k < 20; k++) {
        Machine m = draw(false, &seed);
        double rms = found_again(&m, 0);
        if (!(rms < 1e-6)) print_error("curve %d of seed 19\n", k);
        CHECK_NEAR(rms, 0, 1e-6);
    }
}

static void curves_of_random_slider_cranks_are_found_again(void **state)
{
    (void)state;
    uint64_t seed = 5;
    for (int k = 0; k < 10; k++) {
        Machine m = draw(true, &seed);
        double rms = found_again(&m, 0);
        if (!(rms < 1e-6)) print_error("curve %d of seed 5\n", k);
        CHECK_NEAR(rms, 0, 1e-6);
    }
}

static void points_at_uneven_steps_belong_to_the_same_curve(void **state)
{
    (void)state;
    uint64_t seed = 3;
    for (int k = 0; k < 3; k++) {
        Machine m = draw(false, &seed);
        CHECK_NEAR(found_again(&m, 0.3), 0, 1e-6);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(curves_of_random_four_bars_are_found_again),
        cmocka_unit_test(curves_of_random_slider_cranks_are_found_again),
        cmocka_unit_test(points_at_uneven_steps_belong_to_the_same_curve),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
