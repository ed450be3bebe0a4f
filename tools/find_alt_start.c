// Finds the start system of Alt's problem by monodromy, and writes src/synthesis/nine_points/alt_start_table.c. See
// tools/find-alt-start.
//
// A random complex linkage is turned to eight random places, which makes it a solution of the nine-point problem there.
// It is led to places with few digits, and then round random triangles of places: the solutions permute, and every
// round shows new ones, one of each triple of cognates being kept. It ends when a round shows none, by when there must
// be 1,442 of them.
// Source of the method: Duff, Hill, Jensen, Lee, Leykin & Sommars 2019; of the number: Wampler, Morgan & Sommese 1992.
#include <inttypes.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/mix.h"
#include "synthesis/nine_points/alt_start.h"

enum { N = YK_ALT_SIZE, P = YK_ALT_PLACES, MOST = 2 * YK_ALT_TRIPLES, ROUNDS_MAX = 60, THREADS = 2 };

typedef struct Solution {
    YkVec x[N], key[2]; // key: the sums of the triple's fixed pivots
} Solution;

static Solution solutions[MOST];
static size_t count;
static uint64_t seed = 20;

// --- random linkages

static YkVec random_complex(void)
{
    double size = yk_exp(0.5 * (2 * yk_mix_unit(&seed) - 1));
    return yk_scale(size, yk_unit(2 * YK_PI * yk_mix_unit(&seed)));
}

static YkVec root(YkVec z)
{
    return yk_scale(sqrt(yk_norm(z)), yk_unit(yk_atan2(z.y, z.x) / 2));
}

// Finds a place of the coupler point where the coupler is turned by t: each dyad says d d^ + p d + q d^ + r = 0.
static void place_of(const YkVec *x, YkVec t, YkVec *d, YkVec *hat)
{
    YkVec p[2], q[2], r[2], inverse = yk_inverse(t), one = yk_vec(1, 0);
    for (size_t i = 0; i < 2; i++) {
        const YkVec *y = x + i * YK_ALT_DYAD;
        p[i] = yk_sub(yk_mul(y[YK_ALT_X_HAT], inverse), y[YK_ALT_A_HAT]);
        q[i] = yk_sub(yk_mul(y[YK_ALT_X], t), y[YK_ALT_A]);
        r[i] = yk_add(yk_mul(yk_mul(y[YK_ALT_A_HAT], y[YK_ALT_X]), yk_sub(one, t)),
                      yk_mul(yk_mul(y[YK_ALT_A], y[YK_ALT_X_HAT]), yk_sub(one, inverse)));
    }
    YkVec dp = yk_sub(p[0], p[1]), dq = yk_sub(q[0], q[1]), dr = yk_sub(r[0], r[1]);
    YkVec linear = yk_sub(yk_sub(yk_mul(p[0], dq), yk_mul(q[0], dp)), dr);
    YkVec rest = yk_sub(yk_mul(r[0], dq), yk_mul(q[0], dr));
    YkVec square = yk_add(yk_mul(linear, linear), yk_scale(4, yk_mul(dp, rest)));
    *d = yk_mul(yk_add(linear, root(square)), yk_inverse(yk_scale(2, dp)));
    *hat = yk_scale(-1, yk_mul(yk_add(dr, yk_mul(*d, dp)), yk_inverse(dq)));
}

static double rounded(double value)
{
    return rint(value * 1000) / 1000;
}

static bool invent(YkVec *places, YkVec *x)
{
    YkVec from[P];
    for (size_t k = 0; k < N; k++) x[k] = random_complex();
    for (size_t j = 0; j < N; j++) place_of(x, random_complex(), &from[j], &from[N + j]);
    for (size_t k = 0; k < P; k++) {
        places[k] = random_complex();
        places[k] = yk_vec(rounded(places[k].x), rounded(places[k].y));
    }
    YkAltPath path = {from, places, false, NULL};
    return yk_alt_polish(from, x) < 1e-10 && yk_alt_follow(&path, x);
}

// --- what is known

static void key_of(const YkVec *x, YkVec key[2])
{
    YkVec other[N];
    yk_alt_cognate(x, other);
    for (size_t k = 0; k < 2; k++) {
        size_t at = k == 0 ? YK_ALT_A : YK_ALT_A_HAT;
        key[k] = yk_add(yk_add(x[at], x[YK_ALT_DYAD + at]), other[YK_ALT_DYAD + at]);
    }
}

static void add_new(const YkVec *x)
{
    Solution new;
    memcpy(new.x, x, sizeof new.x);
    key_of(x, new.key);
    for (size_t i = 0; i < count; i++) {
        double apart = 0;
        for (size_t k = 0; k < 2; k++)
            apart += yk_sum_norm(yk_sub(new.key[k], solutions[i].key[k])) / (1 + yk_sum_norm(new.key[k]));
        if (apart < 1e-6) return;
    }
    if (count < MOST) solutions[count++] = new;
}

// --- rounds

typedef struct Round {
    YkVec corner[3][P];
    size_t from, to, lost;
    YkVec (*end)[N];
    bool *arrived;
} Round;

static void *go_round(void *context)
{
    Round *r = context;
    for (size_t i = r->from; i < r->to; i += THREADS) {
        memcpy(r->end[i], solutions[i].x, sizeof r->end[i]);
        r->arrived[i] = true;
        for (size_t k = 0; k < 3 && r->arrived[i]; k++) {
            YkAltPath path = {r->corner[k], r->corner[(k + 1) % 3], false, NULL};
            r->arrived[i] = yk_alt_follow(&path, r->end[i]);
        }
        if (!r->arrived[i]) r->lost++;
    }
    return NULL;
}

// Returns the number of new solutions.
static size_t send_all(const YkVec *places)
{
    static YkVec end[MOST][N];
    static bool arrived[MOST];
    Round round = {.to = count, .end = end, .arrived = arrived}, part[THREADS];
    pthread_t thread[THREADS];
    size_t before = count, lost = 0;
    memcpy(round.corner[0], places, sizeof round.corner[0]);
    for (size_t c = 1; c < 3; c++)
        for (size_t k = 0; k < P; k++) round.corner[c][k] = random_complex();
    for (size_t t = 0; t < THREADS; t++) {
        part[t] = round;
        part[t].from = t;
        if (pthread_create(&thread[t], NULL, go_round, &part[t]) != 0) abort();
    }
    for (size_t t = 0; t < THREADS; t++) {
        pthread_join(thread[t], NULL);
        lost += part[t].lost;
    }
    for (size_t i = 0; i < before; i++)
        if (arrived[i]) add_new(end[i]);
    fprintf(stderr, "%zu sent, %zu lost, %zu known\n", before, lost, count);
    return count - before;
}

// --- the table

static void print_solution(const YkVec *x)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    uint64_t bits = 0;
    int held = 0;
    printf("    \"");
    for (size_t k = 0; k < 2 * N; k++) {
        float value = (float)(k % 2 == 0 ? x[k / 2].x : x[k / 2].y);
        uint32_t own;
        memcpy(&own, &value, sizeof own);
        bits = bits << 32 | own;
        for (held += 32; held >= 6; held -= 6) putchar(digits[bits >> (held - 6) & 63]);
    }
    printf("%c\",\n", digits[bits << (6 - held) & 63]);
}

static void print_table(const YkVec *places)
{
    printf("// Start solutions of Alt's problem. Written by tools/find-alt-start: change that.\n"
           "#include \"synthesis/nine_points/alt_start.h\"\n\n"
           "// clang-format off\n"
           "const YkVec yk_alt_start_at[YK_ALT_PLACES] = {\n");
    for (size_t k = 0; k < P; k++) printf("    {%.3f, %.3f},\n", places[k].x, places[k].y);
    printf("};\n\nconst char yk_alt_start_text[YK_ALT_TRIPLES][YK_ALT_START_LENGTH + 1] = {\n");
    for (size_t i = 0; i < count; i++) print_solution(solutions[i].x);
    printf("};\n");
}

// Returns whether every solution is found again from what the table keeps of it.
static bool survive(const YkVec *places)
{
    for (size_t i = 0; i < count; i++) {
        YkVec x[N];
        double off = 0;
        for (size_t k = 0; k < N; k++)
            x[k] = yk_vec((double)(float)solutions[i].x[k].x, (double)(float)solutions[i].x[k].y);
        bool is_solution = yk_alt_polish(places, x) < 1e-10;
        for (size_t k = 0; k < N; k++) off = fmax(off, yk_sum_norm(yk_sub(x[k], solutions[i].x[k])));
        if (!is_solution || !(off < 1e-6)) return false;
    }
    return true;
}

int main(void)
{
    YkVec places[P], x[N];
    while (!invent(places, x)) fprintf(stderr, "a linkage did not reach its places: another one\n");
    add_new(x);
    for (int round = 0; round < ROUNDS_MAX; round++)
        if (send_all(places) == 0 && count >= YK_ALT_TRIPLES) break;
    if (count != YK_ALT_TRIPLES || !survive(places)) {
        fprintf(stderr, "found %zu triples instead of %d, or some that the table cannot keep\n", count, YK_ALT_TRIPLES);
        return 1;
    }
    print_table(places);
    return 0;
}
