// Random trains of up to 40 meshes against an elimination of another kind: the same equations, written from the
// generator's own list, dense, modulo the prime 2^31 - 1. Both must agree on what is determined and on every fraction.
// TRAIN_CASES in the environment sets how many (100000 by hand).
#include <stdlib.h>
#include "base/text.h"
#include "design/train_check.h"

enum { BODIES = 64, MESHES = 40, INPUTS = 6 };
static const uint64_t prime = 2147483647;

typedef struct Net {
    int bodies, meshes, inputs, holds; // body 0 is the ground
    int on[BODIES];                    // what carries it: 0 coaxial with all others on the ground, else an arm
    int mesh[MESHES][3], teeth[MESHES][2];
    bool internal[MESHES];
    int input[INPUTS], speed[INPUTS], hold[INPUTS];
    int join[INPUTS][2], joins;
} Net;

static int pick(uint64_t *seed, int low, int high)
{
    return low + (int)(check_random(seed) % (uint64_t)(high - low + 1));
}

// Some coaxial wheels and arms, planets on the arms, planets in mesh with wheels and with each other.
static Net random_net(uint64_t *seed)
{
    Net net = {.bodies = 1};
    int central = pick(seed, 2, 12), planets = pick(seed, 1, 30), wanted = pick(seed, 1, MESHES);
    for (int k = 0; k < central; k++) net.on[net.bodies++] = 0;
    for (int k = 0; k < planets; k++) net.on[net.bodies++] = pick(seed, 1, central);
    for (int tries = 0; net.meshes < wanted && tries < 400; tries++) {
        int p = pick(seed, central + 1, central + planets), q = pick(seed, 1, net.bodies - 1), arm = net.on[p];
        if (q == p || q == arm || (net.on[q] != 0 && net.on[q] != arm)) continue;
        bool internal = pick(seed, 0, 2) == 0;
        int z = pick(seed, 12, 60), m = net.meshes++;
        net.mesh[m][0] = p;
        net.mesh[m][1] = q;
        net.mesh[m][2] = arm;
        net.teeth[m][0] = z;
        net.teeth[m][1] = internal ? pick(seed, z + 1, 150) : pick(seed, 12, 120);
        net.internal[m] = internal;
    }
    net.inputs = pick(seed, 1, 4);
    for (int k = 0; k < net.inputs; k++) {
        bool is_new = true;
        net.input[k] = pick(seed, 1, central);
        for (int j = 0; j < k; j++) is_new &= net.input[j] != net.input[k];
        net.speed[k] = pick(seed, -500, 500);
        if (!is_new) net.inputs = k;
    }
    net.holds = pick(seed, 0, 3);
    for (int k = 0; k < net.holds; k++) net.hold[k] = pick(seed, 1, net.bodies - 1);
    net.joins = pick(seed, 0, 2);
    for (int k = 0; k < net.joins; k++) {
        net.join[k][0] = pick(seed, 1, net.bodies - 1);
        net.join[k][1] = pick(seed, 1, net.bodies - 1);
        if (net.join[k][0] == net.join[k][1]) net.joins = k;
    }
    return net;
}

static void write_yaml(const Net *net, YkText *text)
{
    yk_text_puts(text, "bodies:\n");
    for (int b = 1; b < net->bodies; b++) {
        yk_text_format(text, "  b%d: {points: {", b);
        const char *comma = "";
        for (int p = 1; p < net->bodies; p++) {
            if (net->on[p] != b) continue;
            yk_text_format(text, "%sj%d: [%d, 1]", comma, p, p);
            comma = ", ";
        }
        if (net->on[b] != 0) yk_text_format(text, "%sj%d: [0, 0]", comma, b);
        yk_text_puts(text, "}}\n");
    }
    yk_text_puts(text, "joints:\n");
    for (int b = 1; b < net->bodies; b++) {
        if (net->on[b] == 0) {
            yk_text_format(text, "  j%d: {pin: [ground, b%d], angle: q%d}\n", b, b, b);
        } else {
            yk_text_format(text, "  j%d: {pin: [b%d, b%d], angle: q%d}\n", b, net->on[b], b, b);
        }
    }
    if (net->meshes > 0) yk_text_puts(text, "gears:\n");
    for (int m = 0; m < net->meshes; m++)
        yk_text_format(text, "  g%d: {mesh: [b%d, b%d], teeth: [%d, %d], carrier: b%d, internal: %s}\n", m,
                       net->mesh[m][0], net->mesh[m][1], net->teeth[m][0], net->teeth[m][1], net->mesh[m][2],
                       net->internal[m] ? "true" : "false");
    yk_text_puts(text, "drives:\n");
    for (int k = 0; k < net->inputs; k++) yk_text_format(text, "  q%d: %d rpm * t\n", net->input[k], net->speed[k]);
    yk_text_puts(text, "locks:\n  one:\n    hold: [");
    for (int k = 0; k < net->holds; k++) yk_text_format(text, "%sb%d", k ? ", " : "", net->hold[k]);
    yk_text_puts(text, "]\n    join: [");
    for (int k = 0; k < net->joins; k++)
        yk_text_format(text, "%s[b%d, b%d]", k ? ", " : "", net->join[k][0], net->join[k][1]);
    yk_text_puts(text, "]\n");
}

// --- The other way ---------------------------------------------------------------------------------------------------

static uint64_t power(uint64_t base, uint64_t exponent)
{
    uint64_t result = 1;
    for (base %= prime; exponent > 0; exponent >>= 1, base = base * base % prime)
        if (exponent & 1) result = result * base % prime;
    return result;
}
static uint64_t residue(long long value)
{
    long long p = (long long)prime, r = value % p;
    return (uint64_t)(r < 0 ? r + p : r);
}

typedef struct Dense {
    int rows;
    uint64_t cell[MESHES + BODIES][BODIES + 1]; // last: the right-hand side in rpm
    int pivot[BODIES];
    bool is_contradiction;
} Dense;

static void write_dense(const Net *net, Dense *d)
{
    memset(d, 0, sizeof *d);
    for (int m = 0; m < net->meshes; m++) {
        int s = net->internal[m] ? -1 : 1;
        const int *z = net->teeth[m];
        uint64_t *row = d->cell[d->rows++];
        row[net->mesh[m][0]] = residue(z[0]);
        row[net->mesh[m][1]] = residue(s * z[1]);
        row[net->mesh[m][2]] = residue(-z[0] - s * z[1]);
    }
    d->cell[d->rows++][0] = 1;
    for (int k = 0; k < net->inputs; k++) {
        d->cell[d->rows][net->input[k]] = 1;
        d->cell[d->rows++][BODIES] = residue(net->speed[k]);
    }
    for (int k = 0; k < net->holds; k++) d->cell[d->rows++][net->hold[k]] = 1;
    for (int k = 0; k < net->joins; k++) {
        d->cell[d->rows][net->join[k][0]] = 1;
        d->cell[d->rows++][net->join[k][1]] = prime - 1;
    }
}

static void solve_dense(Dense *d)
{
    int rank = 0;
    for (int c = 0; c < BODIES; c++) {
        int r = rank;
        d->pivot[c] = -1;
        while (r < d->rows && d->cell[r][c] == 0) r++;
        if (r == d->rows) continue;
        for (int k = 0; k <= BODIES; k++) {
            uint64_t swap = d->cell[r][k];
            d->cell[r][k] = d->cell[rank][k];
            d->cell[rank][k] = swap;
        }
        uint64_t by = power(d->cell[rank][c], prime - 2);
        for (int k = 0; k <= BODIES; k++) d->cell[rank][k] = d->cell[rank][k] * by % prime;
        for (r = 0; r < d->rows; r++) {
            uint64_t f = prime - d->cell[r][c];
            if (r == rank || f == prime) continue;
            for (int k = 0; k <= BODIES; k++) d->cell[r][k] = (d->cell[r][k] + f * d->cell[rank][k]) % prime;
        }
        d->pivot[c] = rank++;
    }
    for (int r = rank; r < d->rows; r++) d->is_contradiction |= d->cell[r][BODIES] != 0;
}

static bool is_determined(const Dense *d, int body)
{
    if (d->pivot[body] < 0) return false;
    for (int c = 0; c < BODIES; c++)
        if (c != body && d->cell[d->pivot[body]][c] != 0) return false;
    return true;
}

// "-460/29 rpm" modulo the prime.
static uint64_t parse(const char *text)
{
    uint64_t part[2] = {0, 1};
    bool is_negative = *text == '-';
    text += is_negative;
    for (int k = 0; *text && *text != ' '; text++) {
        if (*text == '/') {
            part[k = 1] = 0;
        } else {
            part[k] = (part[k] * 10 + (uint64_t)(*text - '0')) % prime;
        }
    }
    uint64_t value = part[0] * power(part[1], prime - 2) % prime;
    return is_negative ? (prime - value) % prime : value;
}

// --- Both ------------------------------------------------------------------------------------------------------------

// How many bodies did not agree.
static int differences(const Net *net, const Dense *d, const Train *t)
{
    bool is_locked = yk_train_status(t->train) == YK_TRAIN_STATUS_LOCKED;
    int wrong = is_locked != d->is_contradiction;
    if (wrong) print_error("locked: %d and %d\n", is_locked, d->is_contradiction);
    for (size_t i = 0; i < yk_train_body_count(t->train) && !is_locked; i++) {
        int before = wrong;
        YkTrainBody body = yk_train_body(t->train, i);
        int b = atoi(yk_model_body_name(t->model, body.body) + 1);
        if (body.is_determined != is_determined(d, b)) {
            wrong++;
        } else if (body.is_determined) {
            wrong += !body.exact || parse(body.exact) != d->cell[d->pivot[b]][BODIES];
        }
        if (wrong > before) print_error("b%d: %s\n", b, body.exact ? body.exact : "open");
    }
    for (int m = 0; m < net->meshes && !is_locked; m++) { // Willis in doubles
        double w[3], largest = 1;
        char name[3][8];
        for (int k = 0; k < 3; k++) {
            snprintf(name[k], sizeof name[k], "b%d", net->mesh[m][k]);
            w[k] = train_body(t, name[k]).speed;
            if (fabs(w[k]) > largest) largest = fabs(w[k]);
        }
        if (isnan(w[0] + w[1] + w[2])) continue;
        double rest = (w[0] - w[2]) * net->teeth[m][0] + (net->internal[m] ? -1 : 1) * (w[1] - w[2]) * net->teeth[m][1];
        if (fabs(rest) <= 1e-12 * largest * 300) continue;
        print_error("g%d: %g of %g left\n", m, rest, largest);
        wrong++;
    }
    return wrong;
}

static void random_trains_agree_with_another_elimination(void **state)
{
    (void)state;
    const char *wanted = getenv("TRAIN_CASES");
    long cases = wanted ? atol(wanted) : 5000, moving = 0, locked = 0;
    const char *again = getenv("TRAIN_SEED"); // of a case that failed
    uint64_t seed = again ? strtoull(again, NULL, 10) : wanted ? 99 : 2024;
    Dense *d = malloc(sizeof *d);
    YkText text = {0};
    assert_non_null(d);
    for (long n = 0; n < cases; n++) {
        uint64_t start = seed;
        Net net = random_net(&seed);
        if (net.meshes == 0) continue;
        yk_text_clear(&text);
        write_yaml(&net, &text);
        Train t = train_of(yk_text_get(&text), &(YkTrainOptions){.efficiency = 1, .lock = "one"});
        write_dense(&net, d);
        solve_dense(d);
        if (differences(&net, d, &t) > 0) {
            print_error("seed %llu\n", (unsigned long long)start);
            fputs(yk_text_get(&text), stderr); // longer than print_error takes
            fail();
        }
        locked += d->is_contradiction;
        moving += yk_train_status(t.train) == YK_TRAIN_STATUS_OK;
        train_done(&t);
    }
    assert_true(moving > cases / 100 && locked > cases / 100); // the cases are of all kinds
    yk_text_free(&text);
    free(d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(random_trains_agree_with_another_elimination)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
