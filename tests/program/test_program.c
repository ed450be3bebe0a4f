// The values that `yoke code` prints: for every example they are the engine's, at the file's parameters and at others.
//
// The calls among the values are worked out here: linear equations, Newton's method on a group, laws, dry friction.
#include <stdlib.h>
#include <yoke/dynamics.h>
#include <yoke/move.h>
#include "code/file.h"
#include "compile/variant.h"
#include "dynamics/random_geared.h"
#include "dynamics/random_machine.h"
#include "examples.h"
#include "graph/graph_check.h"
#include "law/law.h"

typedef struct Printed { // a machine as values
    YkProblems *problems;
    YkModel *model;
    YkMechanism *mech;
    YkVariant *variant;
    YkArena *arena;
    YkFile file;
    const char **names; // of parameters that may vary
    size_t count;
    double *numbers, **results; // per value; per call
} Printed;

static void find_names(Printed *m)
{
    YkProgram fixing = {.model = m->model, .is_fixed = YK_NEW(m->arena, bool, m->model->parameter_count + 1)};
    m->names = YK_NEW(m->arena, const char *, m->model->parameter_count + 1);
    yk_program_fix(&fixing);
    for (size_t k = 0; k < m->model->parameter_count; k++) {
        bool follows = fixing.is_fixed[k];
        for (size_t i = 0; i < m->model->parameter_count && m->model->parameters[k].expr; i++)
            follows |= yk_expr_mentions(m->model->parameters[k].expr, m->model->parameters[i].name);
        if (!follows) m->names[m->count++] = m->model->parameters[k].name;
    }
}

// What no example has.
static const char *const more[] = {
    // an arm with drives and free joints by turns
    "parameters: {l: 0.5, m: 1.3, k: 20}\n"
    "gravity: [0.5, -9.81]\n"
    "bodies:\n"
    "  ground: {points: {O: [0, 0], S: [1, 1]}}\n"
    "  a: {points: {O: [0.1, 0], P: [l, 0.2]}, mass: m, center: [0.2, 0.1], inertia: 0.1}\n"
    "  b: {points: {P: [0, 0], Q: [0.4, 0.1]}, mass: 0.7, center: [0.1, -0.2], inertia: 0.05}\n"
    "  c: {points: {Q: [0, 0], R: [0.3, 0]}, mass: 0.5, center: [0.1, 0.3], inertia: 0.04}\n"
    "  d: {points: {R: [0, 0], T: [0.2, l]}, mass: 0.4, center: [0, 0.1], inertia: 0.02}\n"
    "joints:\n"
    "  O: {pin: [ground, a], angle: p}\n"
    "  P: {pin: [b, a], angle: q}\n"
    "  Q: {slide: [b, c], along: 0.4 rad, from: Q, distance: x}\n"
    "  R: {pin: [d, c], angle: r}\n"
    "springs: {S: {between: [ground.S, d.T], stiffness: k, length: 0.3, damping: 2}}\n"
    "forces: {F: {body: c, at: R, value: [3, -2]}}\n"
    "efforts: {x: 4, r: -1}\n"
    "drives: {q: 0.3 rad + 2 rad/s * t, r: 1 rad - 3 rad/s * t}\n"
    "start: {p: 0.4, p.rate: 1, x: 0.1, x.rate: 0.5}\n",
    // a dyad that slides along a lever which turns
    "parameters: {l: 0.3}\n"
    "gravity: [0.5, -9.81]\n"
    "bodies:\n"
    "  ground: {points: {O: [0, 0], C: [0.4, 0.1]}}\n"
    "  lever: {points: {O: [0, 0], L: [0, 0.05]}, mass: 1, center: [0.2, 0.1], inertia: 0.1}\n"
    "  crank: {points: {C: [0, 0], D: [l, 0]}, mass: 0.7, center: [0.1, 0.05], inertia: 0.04}\n"
    "  block: {points: {D: [0, 0], L: [0.02, 0.03]}, mass: 0.4, center: [0.01, 0.02], inertia: 0.01}\n"
    "joints:\n"
    "  O: {pin: [ground, lever], angle: p}\n"
    "  C: {pin: [ground, crank], angle: q}\n"
    "  D: {pin: [crank, block], angle: s}\n"
    "  L: {slide: [lever, block], along: 0.2 rad}\n"
    "drives: {p: 0.1 rad + 2 rad/s * t}\n"
    "start: {q: 2 rad, s: 1 rad}\n",
    // coordinates that follow laws
    "gravity: [0.3, -9.81]\n"
    "bodies:\n"
    "  ground: {points: {O: [0, 0], P: [1, 0.2]}}\n"
    "  a: {points: {O: [0.1, 0], S: [0.2, 0.5]}, mass: 1.3, center: [0.2, 0.1], inertia: 0.1}\n"
    "  b: {points: {P: [0, 0.1]}, mass: 0.7, center: [0.1, -0.2], inertia: 0.05}\n"
    "  c: {points: {S: [0, 0]}, mass: 0.5, center: [0.1, 0.3], inertia: 0.04}\n"
    "joints:\n"
    "  O: {pin: [ground, a], angle: q}\n"
    "  P: {pin: [b, ground], angle: r}\n"
    "  S: {slide: [a, c], along: 0.4 rad, distance: x}\n"
    "laws:\n"
    "  lift: {period: 2*pi, segments: [{rise: {to: 3 rad, by: 0.05, law: 3-4-5}}, {fall: {to: 2*pi, by: 0.05, law: "
    "harmonic}}]}\n"
    "  swing: {period: 2*pi, segments: [{rise: {to: 3 rad, by: 0.4 rad, law: cycloidal}}, {fall: {to: 2*pi, by: 0.4 "
    "rad, law: 3-4-5}}]}\n"
    "drives: {x: {law: lift, of: q}, r: {law: swing, of: q}}\n"
    "efforts: {q: 3}\n"
    "start: {q: 0.7, q.rate: 2}\n",
    // a belt and a rack on an arm
    "gravity: [0.3, -9.81]\n"
    "bodies:\n"
    "  ground: {points: {O: [0, 0]}}\n"
    "  arm: {points: {O: [0.1, 0.05], W0: [0.2, 0], W1: [0.5, 0.1], R: [0.2, 0.1]}, mass: 1.1, center: [0.1, 0.05], "
    "inertia: 0.1}\n"
    "  w0: {points: {W0: [0, 0]}, mass: 0.6, center: [0.02, 0.03], inertia: 0.02}\n"
    "  w1: {points: {W1: [0, 0]}, mass: 0.8, center: [0.01, -0.03], inertia: 0.03}\n"
    "  bar: {points: {R: [0, 0]}, mass: 0.5, center: [0.1, 0.02], inertia: 0.03}\n"
    "joints:\n"
    "  O: {pin: [ground, arm], angle: q}\n"
    "  W0: {pin: [arm, w0], angle: p}\n"
    "  W1: {pin: [arm, w1], angle: s}\n"
    "  R: {slide: [arm, bar], along: 0 rad, from: R, distance: x}\n"
    "belts: {b: {between: [w0, w1], radii: [0.1, 0.06], crossed: true}}\n"
    "racks: {r: {pinion: w0, rack: bar, radius: 0.1}}\n"
    "efforts: {p: 2}\n"
    "start: {q: 0.3, q.rate: 2, p: 1, p.rate: 3}\n",
    // a pair of cams with two rollers
    "laws: {lift: {period: 2*pi, segments: [{rise: {to: 120 deg, by: 20 deg, law: cycloidal}}, {fall: {to: 360 deg, "
    "by: 20 deg, law: 4-5-6-7}}]}}\n"
    "cams: {c: {cam: shaft, follower: rocker, law: lift, base: 40 mm, roller: 9 mm, at: P, conjugate: {angle: 80 deg, "
    "arm: 60 mm, roller: 8 mm}}}\n"
    "bodies:\n"
    "  ground: {points: {O: [0, 0], Q: [80 mm, 30 mm]}}\n"
    "  shaft: {points: {O: [0, 0]}}\n"
    "  rocker: {points: {Q: [0, 0], P: [0, 70 mm]}, mass: 0.3 kg, center: [10 mm, 20 mm], inertia: 2e-4}\n"
    "joints: {O: {pin: [ground, shaft], angle: theta}, Q: {pin: [ground, rocker], angle: phi}}\n"
    "gravity: [0, -9.81]\n"
    "drives: {theta: 0.6 rad + 5 rad/s * t}\n",
    // a cam whose follower is the first body of its slide
    "laws: {lift: {period: 2*pi, segments: [{rise: {to: 120 deg, by: 20 mm, law: cycloidal}}, {fall: {to: 360 deg, by: "
    "20 mm, law: 4-5-6-7}}]}}\n"
    "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 40 mm, roller: 9 mm, offset: 7 mm}}\n"
    "bodies: {ground: {points: {K: [0, 0]}}, shaft: {points: {K: [0, 0]}}, tappet: {mass: 0.2 kg, center: [3 mm, 5 "
    "mm]}}\n"
    "joints: {K: {pin: [ground, shaft], angle: theta}, T: {slide: [tappet, ground], along: -90 deg, distance: s}}\n"
    "gravity: [0, -9.81]\n"
    "drives: {theta: 0.6 rad + 5 rad/s * t}\n",
    // more free coordinates than are solved without pivots
    "gravity: [0.4, -9.81]\n"
    "bodies:\n"
    "  ground: {points: {P0: [0, 0]}}\n"
    "  b1: {points: {P0: [0, 0], P1: [0.3, 0.1]}, mass: 0.6, center: [0.1, 0.01], inertia: 0.03}\n"
    "  b2: {points: {P1: [0, 0], P2: [0.4, 0.1]}, mass: 0.7, center: [0.1, 0.02], inertia: 0.04}\n"
    "  b3: {points: {P2: [0, 0], P3: [0.2, 0.1]}, mass: 0.8, center: [0.1, 0.03], inertia: 0.05}\n"
    "  b4: {points: {P3: [0, 0], P4: [0.3, 0.1]}, mass: 0.9, center: [0.1, 0.04], inertia: 0.02}\n"
    "  b5: {points: {P4: [0, 0], P5: [0.4, 0.1]}, mass: 1, center: [0.1, 0.05], inertia: 0.03}\n"
    "  b6: {points: {P5: [0, 0], P6: [0.2, 0.1]}, mass: 1.1, center: [0.1, 0.06], inertia: 0.04}\n"
    "  b7: {points: {P6: [0, 0], P7: [0.3, 0.1]}, mass: 1.2, center: [0.1, 0.07], inertia: 0.05}\n"
    "  b8: {points: {P7: [0, 0], P8: [0.4, 0.1]}, mass: 1.3, center: [0.1, 0.08], inertia: 0.02}\n"
    "joints:\n"
    "  P0: {pin: [ground, b1], angle: q1}\n"
    "  P1: {pin: [b1, b2], angle: q2}\n"
    "  P2: {pin: [b2, b3], angle: q3}\n"
    "  P3: {pin: [b3, b4], angle: q4}\n"
    "  P4: {pin: [b4, b5], angle: q5}\n"
    "  P5: {pin: [b5, b6], angle: q6}\n"
    "  P6: {pin: [b6, b7], angle: q7}\n"
    "  P7: {pin: [b7, b8], angle: q8}\n"
    "efforts: {q2: 3, q7: -1}\n"
    "start: {q1: -0.7, q1.rate: 1.1, q2: -0.4, q2.rate: 0.7, q3: -0.1, q3.rate: 0.3, q4: 0.2, q4.rate: -0.1, q5: 0.5, "
    "q5.rate: -0.5, q6: 0.8, q6.rate: -0.9, q7: 1.1, q7.rate: -1.3, q8: 1.4, q8.rate: -1.7}\n",
    // a lever that a cam turns about the cam's own pin
    "laws: {lift: {period: 2*pi, segments: [{rise: {to: 120 deg, by: 20 deg, law: cycloidal}}, {fall: {to: 360 deg, "
    "by: "
    "20 deg, law: 4-5-6-7}}]}}\n"
    "cams: {c: {cam: shaft, follower: lever, law: lift, base: 40 mm, roller: 9 mm, at: P, centers: 80 mm}}\n"
    "bodies:\n"
    "  ground: {points: {O: [0, 0]}}\n"
    "  shaft: {points: {O: [0, 0]}, mass: 1, center: [0.1, 0.2], inertia: 0.02}\n"
    "  lever: {points: {O: [0, 0], P: [0, 70 mm]}, mass: 0.3, center: [10 mm, 20 mm], inertia: 2e-4}\n"
    "joints: {O: {pin: [ground, shaft], angle: theta}, Q: {pin: [ground, lever], at: O, angle: phi}}\n"
    "gravity: [0, -9.81]\n"
    "start: {theta: 0.6, theta.rate: 5}\n",
    // three cranks, one of them too many
    "gravity: [1, -9.81]\n"
    "bodies:\n"
    "  ground: {points: {O: [0, 0], Q: [3, 0], P: [1, 1]}}\n"
    "  a: {points: {O: [0, 0], A: [1, 0]}, mass: 1, center: [0.4, 0.1], inertia: 0.2}\n"
    "  b: {points: {A: [0, 0], B: [3, 0], D: [1, 1]}, mass: 2, center: [1.2, 0.3], inertia: 0.7}\n"
    "  c: {points: {Q: [0, 0], B: [1, 0]}, mass: 0.6, center: [0.5, 0], inertia: 0.1}\n"
    "  d: {points: {P: [0, 0], D: [1, 0]}, mass: 0.4, center: [0.6, 0.1], inertia: 0.1}\n"
    "joints: {O: {pin: [ground, a], angle: th}, Q: {pin: [ground, c], angle: ps}, A: {pin: [a, b], angle: u},\n"
    "  B: {pin: [b, c]}, P: {pin: [ground, d], angle: ph}, D: {pin: [b, d]}}\n"
    "start: {th: 1, ps: 1, ph: 1, u: -1, th.rate: 2}\n",
    // wheels with pressure on their flanks in pins that rub, and two planets
    "parameters: {m: 4 mm, z: 20, y: 30, k: 0.7, w: 3}\n"
    "gravity: [0.3, -9.81]\n"
    "bodies:\n"
    "  ground: {points: {O: [0, 0]}}\n"
    "  arm: {points: {O: [0, 0], P: [100 mm, 0], W: [-40 mm, 20 mm]}, mass: 0.9, center: [0.03, 0.01], inertia: 0.01}\n"
    "  sun: {points: {O: [0, 0]}, mass: 0.5, inertia: 0.002}\n"
    "  planet: {points: {P: [0, 0]}, mass: 0.4, center: [4 mm, 3 mm], inertia: 0.001}\n"
    "  bob: {points: {W: [0, 0]}, mass: k, center: [20 mm, 5 mm], inertia: 0.001}\n"
    "joints:\n"
    "  O: {pin: [ground, arm], angle: q, friction: {coulomb: 0.1, radius: 20 mm}}\n"
    "  S: {pin: [ground, sun], at: O, angle: s}\n"
    "  P: {pin: [arm, planet], angle: p, friction: {coulomb: 0.05, radius: 10 mm}}\n"
    "  W: {pin: [arm, bob], angle: r}\n"
    "gears: {g: {mesh: [sun, planet], teeth: [z, y], module: m, pressure_angle: 20 deg, carrier: arm}}\n"
    "efforts: {s: 2}\n"
    "drives: {r: 0.2 rad + w * (1 rad/s) * t}\n"
    "start: {q: 0.3, q.rate: 2, s: 0.4, s.rate: -3}\n",
    "gravity: [0.3, -9.81]\n"
    "bodies:\n"
    "  ground: {points: {O: [0, 0]}}\n"
    "  arm: {points: {O: [0, 0], P: [100 mm, 0]}, mass: 0.9, center: [0.03, 0.01], inertia: 0.01}\n"
    "  sun: {points: {O: [0, 0]}, mass: 0.5, inertia: 0.002}\n"
    "  planet: {points: {P: [0, 0]}, mass: 0.4, inertia: 0.001}\n"
    "joints: {O: {pin: [ground, arm], angle: q}, S: {pin: [ground, sun], at: O, angle: s}, P: {pin: [arm, planet], "
    "angle: p}}\n"
    "gears: {g: {mesh: [sun, planet], teeth: [20, 30], module: 4 mm, pressure_angle: 20 deg, planets: 2}}\n"
    "efforts: {s: 2}\n"
    "start: {q: 0.3, q.rate: 2, s: 0.4, s.rate: -3}\n",
    // dry friction where things move freely
    "gravity: [0.3, -9.81]\n"
    "bodies:\n"
    "  ground: {points: {O: [0, 0]}}\n"
    "  cart: {points: {P: [0.1, 0.2]}, mass: 1.3, center: [0.05, 0.1], inertia: 0.1}\n"
    "  pole: {points: {P: [0, 0]}, mass: 0.7, center: [0.3, 0.1], inertia: 0.05}\n"
    "joints:\n"
    "  X: {slide: [ground, cart], along: 0.2 rad, distance: x, friction: {coulomb: 0.2}}\n"
    "  P: {pin: [cart, pole], angle: q, friction: {coulomb: 0.1, radius: 20 mm}}\n"
    "start: {x.rate: 2, q: 0.7, q.rate: -3}\n"};

// From a file, or a text of many lines. Returns false for a machine that does not move, or is not printed.
static bool start(Printed *m, const char *path)
{
    *m = (Printed){.problems = yk_problems_new(), .arena = yk_arena_new()};
    bool is_text = strchr(path, '\n') != NULL;
    m->model = is_text ? yk_model_parse(path, strlen(path), "text", NULL, m->problems)
                       : yk_model_load(path, NULL, m->problems);
    m->mech = m->model ? yk_mechanism_compile(m->model, NULL, m->problems) : NULL;
    if (!m->mech) return false;
    find_names(m);
    m->variant = yk_variant_new(m->mech, m->names, m->count, m->problems);
    YkFile *file = &m->file;
    YkProgram *p = &file->program;
    if (!m->variant || !yk_program_start(p, m->variant->mech, &m->variant->recipe, m->arena, m->problems)) return false;
    p->graph.joins_terms = true;
    file->prefix = p->prefix = "m";
    file->has_forces = yk_model_has_forces(m->model);
    file->state = yk_state_new(m->variant->mech);
    assert_true(yk_file_choose_names(p));
    yk_program_fix(p);
    yk_program_constants(p);
    if (yk_state_assemble(file->state) < 0 || !yk_file_members(file) || !yk_file_routines(file)) return false;
    m->numbers = calloc(p->graph.count, sizeof *m->numbers);
    m->results = calloc(p->graph.call_count + 1, sizeof *m->results);
    return m->numbers && m->results;
}

static void end(Printed *m)
{
    for (size_t k = 0; m->results && k < m->file.program.graph.call_count; k++) free(m->results[k]);
    free(m->results);
    free(m->numbers);
    if (m->file.program.arena) yk_program_end(&m->file.program);
    yk_state_free(m->file.state);
    yk_variant_free(m->variant);
    yk_mechanism_free(m->mech);
    yk_model_free(m->model);
    yk_problems_free(m->problems);
    yk_arena_free(m->arena);
}

// --- calls

// Gauss and Jordan with row exchanges on A[n][n + m]; returns the determinant.
static double eliminate(double *A, size_t n, size_t m)
{
    double determinant = 1;
    for (size_t c = 0; c < n; c++) {
        size_t best = c, w = n + m;
        for (size_t r = c + 1; r < n; r++)
            if (fabs(A[r * w + c]) > fabs(A[best * w + c])) best = r;
        determinant *= best == c ? A[best * w + c] : -A[best * w + c];
        for (size_t k = 0; k < w; k++) {
            double swap = A[c * w + k];
            A[c * w + k] = A[best * w + k];
            A[best * w + k] = swap;
        }
        for (size_t r = 0; r < n; r++) {
            double share = r == c ? 0 : A[r * w + c] / A[c * w + c];
            for (size_t k = 0; k < w; k++) A[r * w + k] -= share * A[c * w + k];
        }
        for (size_t k = w; k-- > c;) A[c * w + k] /= A[c * w + c];
    }
    return determinant;
}

static void call_solve(const YkCall *call, double *A)
{
    size_t n = (size_t)call->n, m = (size_t)call->m;
    double lengths = 1;
    for (size_t c = 0; c < n; c++) {
        double sum = 0;
        for (size_t r = 0; r < n; r++) sum += A[r * (n + m) + c] * A[r * (n + m) + c];
        lengths *= sqrt(sum);
    }
    A[n * (n + m)] = eliminate(A, n, m) / lengths;
}

// x_k = a_k |V_k + W_k x|, by repetition; x stands behind the rows a_k, V_k, W_k.
static void call_friction(const YkCall *call, double *rows)
{
    size_t n = (size_t)call->n;
    double *x = rows + n * (3 + 2 * n);
    for (size_t k = 0; k < 2 * n; k++) x[k] = 0;
    for (int round = 0; round < 1000; round++)
        for (size_t k = 0; k < n; k++) {
            const double *r = rows + k * (3 + 2 * n);
            double along = r[1], across = r[2];
            for (size_t i = 0; i < n; i++) along += r[3 + 2 * i] * x[i], across += r[4 + 2 * i] * x[i];
            x[k] = r[0] * hypot(along, across);
        }
    x[2 * n] = 1;
}

static void evaluate(Printed *m, size_t from, size_t to);

// Newton's method with the values of residual and Jacobian, which stand before the call.
static void call_group(Printed *m, const YkCall *call, double *x, size_t to)
{
    const YkPlaced *placed = &m->file.program.placed[call->index];
    size_t n = (size_t)call->n;
    double *A = calloc(n * (n + 1) + 1, sizeof *A);
    assert_non_null(A);
    for (int round = 0; round < 20; round++) {
        for (size_t k = 0; k < n; k++) m->numbers[placed->unknown[k]] = x[k];
        evaluate(m, (size_t)placed->unknown[0], to);
        for (size_t r = 0; r < n; r++) {
            for (size_t c = 0; c < n; c++) A[r * (n + 1) + c] = m->numbers[placed->jacobian[r * n + c]];
            A[r * (n + 1) + n] = -m->numbers[placed->residual[r]];
        }
        x[n + 1] = eliminate(A, n, 1);
        for (size_t k = 0; k < n; k++) x[k] += A[k * (n + 1) + n];
    }
    x[n] = 0;
    free(A);
}

static void run_call(Printed *m, int32_t index, size_t to)
{
    const YkCall *call = &m->file.program.graph.calls[index];
    size_t room = call->argument_count + call->result_count;
    double *x = realloc(m->results[index], room * sizeof *x), d[YK_LAW_ORDER + 1];
    assert_non_null(x);
    m->results[index] = x;
    for (size_t k = 0; k < call->argument_count; k++) x[k] = m->numbers[call->arguments[k]];
    if (call->kind == YK_CALL_SOLVE) {
        call_solve(call, x);
    } else if (call->kind == YK_CALL_MOTION) {
        eliminate(x, (size_t)call->n, 1);
        x[call->argument_count] = 1;
    } else if (call->kind == YK_CALL_GROUP) {
        call_group(m, call, x, to);
    } else if (call->kind == YK_CALL_FRICTION) {
        call_friction(call, x);
    } else {
        yk_law_eval(m->model->laws[call->index].law, x[0], d);
        memcpy(x, d, 3 * sizeof *x);
    }
}

// All values of a range; calls are made when their first result is asked for.
static void evaluate(Printed *m, size_t from, size_t to)
{
    const YkGraph *g = &m->file.program.graph;
    for (size_t k = from; k < to; k++) {
        const YkValue *v = &g->values[k];
        if (v->op == YK_VALUE_LEAF) continue;
        if (v->op == YK_VALUE_RESULT) {
            bool is_first = true;
            for (size_t i = 0; i < k && is_first; i++)
                is_first = g->values[i].op != YK_VALUE_RESULT || g->values[i].a != v->a;
            if (is_first) run_call(m, v->a, k);
            m->numbers[k] = m->results[v->a][v->b];
            continue;
        }
        double a = v->a >= 0 ? m->numbers[v->a] : 0, b = v->b >= 0 ? m->numbers[v->b] : 0;
        m->numbers[k] = v->op == YK_VALUE_WITNESS ? a - a : graph_operate(v, a, b, v->c >= 0 ? m->numbers[v->c] : 0);
    }
}

// --- leaves

static void set(Printed *m, double number, const char *format, ...)
{
    char name[200];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(name, sizeof name, format, arguments);
    va_end(arguments);
    int32_t leaf = yk_names_find(&m->file.program.graph.leaves, name);
    if (leaf != YK_NONE) m->numbers[leaf] = number; // otherwise nothing depends on it
}

// Branches, guesses, angles that others come out nearest to: of the machine where it starts.
static void set_configuration(Printed *m)
{
    const YkFile *file = &m->file;
    for (size_t k = 0; k < file->configuration_count; k++) {
        const YkLeafNote *note = &file->configuration[k];
        if (note->count == 0) set(m, note->value, "c->%s", note->name);
        for (size_t i = 0; i < note->count; i++)
            set(m, file->state->groups.x[(size_t)note->value + i], "c->%s[%d]", note->name, (int)i);
    }
}

// --- the engine beside it

typedef struct Engine {
    YkVariant *variant;
    const YkMechanism *mech;
    YkState *state;
    YkDynamics *dynamics;
    uint64_t seed;
    bool is_from_rest;
} Engine;

// Another design: each parameter a little different. Returns false if it stands in another configuration.
static bool engine_start(Engine *e, Printed *m, double apart)
{
    double *values = calloc(m->count + 1, sizeof *values);
    assert_non_null(values);
    e->variant = yk_variant_new(m->mech, m->names, m->count, m->problems);
    e->mech = yk_variant_mechanism(e->variant);
    for (size_t k = 0; k < m->count; k++) {
        size_t own = (size_t)yk_names_find(&m->model->parameter_names, m->names[k]);
        values[k] = m->model->parameters[own].value * (1 + check_uniform(&e->seed, -apart, apart));
        set(m, values[k], "%s", m->file.program.names.parameter[own]);
    }
    bool good = apart == 0 || yk_variant_set(e->variant, values) == YK_OK;
    free(values);
    e->state = yk_state_new(e->mech);
    assert_non_null(e->state);
    if (!good || yk_state_assemble(e->state) < 0) return false;
    for (size_t k = 0; k < e->mech->block_count; k++)
        good &= yk_state_branch(e->state, k) == yk_state_branch(m->file.state, k);
    for (size_t k = 0; k < e->mech->coordinate_count; k++)
        good &= fabs(yk_state_coordinate(e->state, k).position - yk_state_coordinate(m->file.state, k).position) < 0.5;
    return good;
}

static void engine_end(Engine *e)
{
    yk_dynamics_free(e->dynamics);
    yk_state_free(e->state);
    yk_variant_free(e->variant);
}

static void set_inputs(Printed *m, Engine *e)
{
    set(m, yk_state_time(e->state), "in->t");
    for (size_t i = 0; i < e->mech->input_count; i++) {
        const char *name = m->file.program.names.coordinate[e->mech->inputs[i]];
        YkMotion q = yk_state_input(e->state, i);
        set(m, q.position, "in->%s", name);
        set(m, q.velocity, "in->%s_rate", name);
        set(m, q.acceleration, "in->%s_accel", name);
    }
}

// Moves the inputs a little; from_rest: they only begin to move there. Returns false where the machine does not close,
// or is near a dead point.
static bool move(Engine *e, double by, bool from_rest)
{
    e->is_from_rest = from_rest;
    for (size_t i = 0; i < e->mech->input_count; i++) {
        double unit = e->mech->coordinates[e->mech->inputs[i]].is_distance ? e->mech->size : 1;
        YkMotion q = yk_state_input(e->state, i);
        q.position += by * unit * check_uniform(&e->seed, -1, 1);
        q.velocity = from_rest ? 0 : q.velocity + unit * check_uniform(&e->seed, -1, 1);
        q.acceleration += unit * check_uniform(&e->seed, -2, 2);
        yk_state_set_input(e->state, i, q);
    }
    bool good = yk_state_solve(e->state) >= 0 && yk_state_has_rates(e->state) && !e->state->is_kept;
    for (size_t k = 0; good && k < e->mech->block_count; k++) {
        YkBlockKind kind = e->mech->blocks[k].kind; // loops that repeat others have no dead point
        good = kind == YK_BLOCK_LINK || kind == YK_BLOCK_CHECK || e->state->space.block_margin[k] > 1e-4;
    }
    return good;
}

// Forces with the inputs prescribed or, of a routine that finds accelerations, free; these with random efforts, which
// the engine is given besides those of the file.
static bool find_forces(Printed *m, Engine *e, YkRoutineKind kind)
{
    bool is_forward = kind == YK_ROUTINE_FORWARD;
    yk_dynamics_free(e->dynamics);
    e->dynamics = yk_dynamics_new(e->mech, m->problems); // with the file's efforts
    assert_non_null(e->dynamics);
    for (size_t i = 0; i < e->mech->input_count; i++)
        yk_dynamics_prescribe(e->dynamics, i, !is_forward || !m->file.forces.is_free[i]);
    YkStatus status = yk_dynamics_solve(e->dynamics, e->state, YK_METHOD_REDUCED);
    for (size_t i = 0; is_forward && status >= 0 && i < e->mech->input_count; i++) {
        size_t coordinate = (size_t)e->mech->inputs[i];
        if (!m->file.forces.is_free[i]) continue;
        double effort = check_uniform(&e->seed, -1, 1);
        set(m, effort, "in->%s_effort", m->file.program.names.coordinate[coordinate]);
        bool has_law = yk_law_relation(e->mech, coordinate) != YK_NONE; // then the engine gives what the law exerts
        double given = has_law ? 0 : yk_dynamics_effort(e->dynamics, coordinate);
        yk_dynamics_set_effort(e->dynamics, coordinate, given + effort);
    }
    if (is_forward && status >= 0) status = yk_dynamics_solve(e->dynamics, e->state, YK_METHOD_REDUCED);
    return (status == YK_OK || status == YK_REDUNDANT) && yk_state_has_rates(e->state);
}

static double engine_value(const Engine *e, YkRoutineKind kind, YkChannel c)
{
    if (kind == YK_ROUTINE_FORWARD)
        return yk_state_input(e->state, (size_t)e->mech->coordinates[c.index].input).acceleration;
    return kind == YK_ROUTINE_MOTION ? yk_state_channel(e->state, c) : yk_dynamics_channel(e->dynamics, e->state, c);
}

// --- comparing

static size_t compared, begun; // results; routines under dry friction where the machine begins to move

static void check_routine(Printed *m, Engine *e, const YkRoutine *r, const char *path)
{
    const double *numbers = m->numbers;
    double *wanted = calloc(r->count + 1, sizeof *wanted);
    assert_non_null(wanted);
    bool has = r->kind == YK_ROUTINE_MOTION || find_forces(m, e, r->kind);
    for (size_t k = 0; has && k < r->count; k++) wanted[k] = engine_value(e, r->kind, r->results[k].channel);
    set_inputs(m, e);
    evaluate(m, 0, m->file.program.graph.count);
    if (has && r->moves >= 0 && numbers[r->moves] <= 1e-3) has = false; // near rest under dry friction
    begun += has && r->moves >= 0 && e->is_from_rest;
    if (has) {
        CHECK_NEAR(numbers[r->witness], 0, 0);
        if (r->regular >= 0) assert_true(numbers[r->regular] > 0);
        if (r->settled >= 0) assert_true(numbers[r->settled] == 1);
    }
    for (size_t k = 0; has && k < r->count; k++) {
        YkChannel c = r->results[k].channel;
        if (r->kind == YK_ROUTINE_INVERSE && c.kind == YK_CHANNEL_EFFORT &&
            yk_law_relation(e->mech, (size_t)c.index) != YK_NONE)
            continue; // the same
        double scale = 1e-2, got = numbers[r->results[k].value];
        for (size_t i = 0; i < r->count; i++)
            if (!strcmp(r->results[i].comment, r->results[k].comment)) scale = fmax(scale, fabs(wanted[i]));
        compared++;
        if (fabs(got - wanted[k]) <= 1e-9 * scale) continue;
        print_error("%s of %s is %.17g, the engine's %.17g, of %g:\n", r->results[k].name, r->name, got, wanted[k],
                    scale);
        print_error("%s\n", path);
        fail();
    }
    free(wanted);
}

// Equations between the coordinates hold at the pose, and their Jacobian times the rates is nothing.
static void check_residuals(Printed *m, const Engine *e, const char *path)
{
    const YkFile *file = &m->file;
    const YkMechanism *mech = e->mech;
    double *rate = calloc(file->coordinate_count + 1, sizeof *rate);
    bool *is_in_tree = calloc(mech->distance_count + 1, sizeof *is_in_tree);
    assert_true(rate && is_in_tree);
    size_t k = 0;
    for (; k < mech->coordinate_count; k++) {
        YkMotion q = yk_state_coordinate(e->state, k);
        set(m, q.position, "q[%d]", (int)k);
        rate[k] = q.velocity;
        if (mech->coordinates[k].is_distance) is_in_tree[mech->coordinates[k].distance] = true;
    }
    for (size_t d = 0; d < mech->distance_count; d++) {
        if (is_in_tree[d]) continue;
        set(m, *e->state->space.slide[d].d, "q[%d]", (int)k);
        rate[k++] = *e->state->space.slide[d].v;
    }
    assert_int_equal(k, file->coordinate_count);
    evaluate(m, 0, file->program.graph.count);
    for (size_t i = 0; i < file->row_count; i++) {
        double sum = 0, scale = 1e-2;
        for (k = 0; k < file->coordinate_count; k++) {
            double term = rate[k] * m->numbers[file->residuals[file->row_count + i * file->coordinate_count + k]];
            sum += term;
            scale += fabs(term);
        }
        if (fabs(m->numbers[file->residuals[i]]) > 1e-9 || fabs(sum) > 1e-9 * scale)
            print_error("%s: row %d is %.3g, its rate %.3g\n", path, (int)i, m->numbers[file->residuals[i]], sum);
        CHECK_NEAR(m->numbers[file->residuals[i]], 0, 1e-9);
        CHECK_NEAR(sum, 0, 1e-9 * scale);
        compared += 2;
    }
    free(is_in_tree);
    free(rate);
}

// Inputs at a time, as drives move them.
static void check_drives(Printed *m, Engine *e, const char *path)
{
    size_t at = 0;
    if (yk_state_set_time(e->state, 0.03, NULL) < 0) return;
    set_inputs(m, e);
    evaluate(m, 0, m->file.program.graph.count);
    for (size_t i = 0; i < e->mech->input_count; i++) {
        YkMotion q = yk_state_input(e->state, i);
        if (e->mech->coordinates[e->mech->inputs[i]].drive == YK_NONE) continue;
        const double wanted[] = {q.position, q.velocity, q.acceleration};
        for (int k = 0; k < 3; k++, at++, compared++) {
            double got = m->numbers[m->file.drives[at].value];
            if (fabs(got - wanted[k]) > 1e-11 * fmax(1, fabs(wanted[k])))
                print_error("%s: drive %s\n", path, m->file.drives[at].name);
            CHECK_NEAR(got, wanted[k], 1e-11 * fmax(1, fabs(wanted[k])));
        }
    }
    assert_int_equal(at, m->file.drive_count);
}

static size_t check_design(Printed *m, const char *path, double apart)
{
    Engine e = {.seed = 5};
    size_t seen = 0;
    if (engine_start(&e, m, apart)) {
        set_configuration(m);
        for (int pose = 0; pose < 5; pose++) {
            if (!move(&e, m->mech->has_groups ? 0.03 : 0.2, pose == 4)) break;
            for (size_t k = 0; k < m->file.routine_count; k++) check_routine(m, &e, &m->file.routines[k], path);
            check_residuals(m, &e, path);
            seen = 1;
        }
        check_drives(m, &e, path);
    }
    engine_end(&e);
    return seen;
}

static size_t designs;

static size_t check(const char *path, size_t number)
{
    Printed m;
    (void)number;
    size_t seen = 0;
    if (start(&m, path)) {
        seen = check_design(&m, path, 0);
        if (!m.variant->is_of_file && m.count > 0) designs += check_design(&m, path, 0.01);
    }
    end(&m);
    return seen;
}

static void values_of_every_example_are_the_engine_s(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof more / sizeof *more; k++) {
        size_t before = designs;
        size_t seen = check(more[k], k);
        if (seen != 1 || (more[k][0] == 'p' && designs != before + 1)) print_error("machine %zu is not printed\n", k);
        assert_int_equal(seen, 1);
        if (strncmp(more[k], "parameters:", 11) == 0) assert_int_equal(designs, before + 1);
    }
    assert_true(each_example(check) > 60);
    assert_true(designs >= 8 && compared > 4000 && begun > 2); // of one example in four, at least
}

// A joint that is driven, at a rate that changes.
static void drive(RandomMachine *m, int a, int b, bool slides)
{
    double y = random_draw(m, -2, 2), x = random_draw(m, -2, 2);
    random_joint(m, a, b, slides, true, false, x, y);
    int c = m->declared - 1;
    const char *u = slides ? "m" : "rad";
    double rate = random_draw(m, -1, 1), swing = random_draw(m, -0.1, 0.1);
    RANDOM_ADD(m->drive_text, "  %s: %.17g %s + %.3g %s/s * t + %.3g %s * sin(2 rad/s * t)\n", m->coordinate[c],
               m->at[c], u, rate, u, swing, u);
    m->is_driven[c] = true;
}

// A dyad of any kind between two bodies that are driven. Each of its links is two bodies, the second driven on the
// first, so that its arms change their length and the lines of its slides turn.
static void driven_dyad(RandomMachine *m, uint64_t seed)
{
    static const bool slides[6][3] = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {1, 0, 1}, {1, 1, 0}};
    const bool *s = slides[seed % 6];
    *m = (RandomMachine){.seed = 77 * seed + 5, .bodies = 1};
    int link[6]; // from the first base to the second
    bool is_rigid[2] = {random_chance(m, 0.3), random_chance(m, 0.3)};
    for (int k = 0; k < 6; k++) {
        bool is_one = (k == 2 && is_rigid[0]) || (k == 4 && is_rigid[1]);
        link[k] = is_one ? link[k - 1] : random_body(m, 0.8);
    }
    drive(m, 0, link[0], random_chance(m, 0.2));
    drive(m, 0, link[5], random_chance(m, 0.2));
    random_joint_anywhere(m, link[0], link[1], s[0], true);
    if (!is_rigid[0]) drive(m, link[1], link[2], random_chance(m, 0.5));
    if (random_chance(m, 0.5))
        random_joint_anywhere(m, link[2], link[3], s[1], true);
    else
        random_joint_anywhere(m, link[3], link[2], s[1], true);
    if (!is_rigid[1]) drive(m, link[3], link[4], random_chance(m, 0.5));
    random_joint_anywhere(m, link[5], link[4], s[2], false);
    random_drives(m);
    if (random_chance(m, 0.5)) random_springs(m);
    random_write(m);
}

// Linkages of all kinds of dyads, triads and parallelograms with springs, forces and efforts, whose points are
// parameters; and gears, belts, racks, cams and laws on the links of a loop.
static void values_of_random_machines_are_the_engine_s(void **state)
{
    (void)state;
    static RandomMachine machine;
    static Geared geared;
    size_t seen[3] = {0, 0, 0}, count = check_cases(60);
    random_numbers = RANDOM_NAMED;
    for (uint64_t number = 0; number < count; number++) {
        driven_dyad(&machine, number);
        seen[0] += check(machine.text, number);
        if (number % 4 != 0) continue;
        random_machine(&machine, 31 * number + 7);
        seen[1] += 4 * check(machine.text, number);
        geared_machine(&geared, number);
        seen[2] += 4 * check(geared.text, number);
    }
    for (size_t k = 0; k < 3; k++) assert_true(2 * seen[k] > count); // the others do not move, or are near a dead point
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(values_of_every_example_are_the_engine_s),
                                       cmocka_unit_test(values_of_random_machines_are_the_engine_s)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
