// Variants against compiling anew: random values of many parameters at once, in the examples and in random machines;
// poses, accelerations, efforts, reactions, energies, bit for bit. YOKE_TEST_RANDOM=2000 in the environment tries more.
#include <stdlib.h>
#include "base/problems.h"
#include "model/model.h"
#include "random_geared.h"
#include "random_machine.h"
#include "rig.h"

enum { MACHINES = 60, DESIGNS = 3, PARAMETERS = 400 };

// A machine's text, its parameters that vary, and values for them.
typedef struct Case {
    const char *label;
    char path[512];   // of an example; empty: the text
    const char *text; // of a random machine
    const char *name[PARAMETERS];
    double value[PARAMETERS];
    size_t count, compared;
    bool is_special; // at the file's values the machine is another one than beside them
    uint64_t seed;
} Case;

static bool same(double a, double b)
{
    return a == b || (isnan(a) && isnan(b));
}

#define CHECK_SAME(what, a, b)                                                                                         \
    do {                                                                                                               \
        double one_ = (a), two_ = (b);                                                                                 \
        if (!same(one_, two_)) {                                                                                       \
            print_error("%s: %s %zu is %.17g, compiled anew %.17g\n", c->label, what, k, one_, two_);                  \
            fail();                                                                                                    \
        }                                                                                                              \
    } while (0)

// --- the same machine, compiled anew --------------------------------------------------------------

static YkModel *load(const Case *c, size_t count, YkProblems *problems)
{
    static char text[PARAMETERS][32];
    YkOverride override[PARAMETERS];
    for (size_t k = 0; k < count; k++) {
        snprintf(text[k], sizeof text[k], "%.17g", c->value[k]);
        override[k] = (YkOverride){c->name[k], text[k]};
    }
    YkLoadOptions options = {override, count};
    return c->path[0] ? yk_model_load(c->path, &options, problems)
                      : yk_model_parse(c->text, strlen(c->text), "random.yaml", &options, problems);
}

// Values of the file's units.
static bool fresh_of(const Case *c, Rig *rig)
{
    *rig = (Rig){.problems = yk_problems_new()};
    rig->model = load(c, c->count, rig->problems);
    if (rig->model) rig->mech = yk_mechanism_compile(rig->model, NULL, rig->problems);
    if (!rig->mech) return false;
    rig->state = yk_state_new(rig->mech);
    rig->dynamics = yk_dynamics_new(rig->mech, rig->problems);
    return rig->state && rig->dynamics;
}

// --- comparing ------------------------------------------------------------------------------------

static void check_motion(const char *what, Case *c, size_t k, YkMotion a, YkMotion b)
{
    CHECK_SAME(what, a.position, b.position);
    CHECK_SAME(what, a.velocity, b.velocity);
    CHECK_SAME(what, a.acceleration, b.acceleration);
}

static void check_poses(Case *c, const Rig *a, const Rig *b)
{
    for (size_t k = 0; k < yk_coordinate_count(a->mech); k++)
        check_motion("coordinate", c, k, yk_state_coordinate(a->state, k), yk_state_coordinate(b->state, k));
    for (size_t k = 0; k < yk_model_point_count(a->model); k++) {
        YkPointMotion x = yk_state_point(a->state, k), y = yk_state_point(b->state, k);
        for (int i = 0; i < 2; i++)
            check_motion("point", c, k, (YkMotion){x.position[i], x.velocity[i], x.acceleration[i]},
                         (YkMotion){y.position[i], y.velocity[i], y.acceleration[i]});
    }
}

static void check_forces(Case *c, const Rig *a, const Rig *b)
{
    if (!a->dynamics->has_mass || !yk_state_has_rates(a->state)) return;
    for (YkMethod method = YK_METHOD_REDUCED; method <= YK_METHOD_NEWTON_EULER; method++) {
        YkStatus one = yk_dynamics_solve(a->dynamics, a->state, method),
                 two = yk_dynamics_solve(b->dynamics, b->state, method);
        size_t k = 0;
        CHECK_SAME("status", one, two);
        if (one < 0 || one == YK_SINGULAR) continue;
        for (; k < a->mech->input_count; k++) {
            CHECK_SAME("acceleration", a->dynamics->acceleration[k], b->dynamics->acceleration[k]);
            CHECK_SAME("effort", yk_dynamics_effort(a->dynamics, (size_t)a->mech->inputs[k]),
                       yk_dynamics_effort(b->dynamics, (size_t)b->mech->inputs[k]));
        }
        for (k = 0; k < yk_model_joint_count(a->model); k++) {
            YkReaction x = yk_dynamics_reaction(a->dynamics, k), y = yk_dynamics_reaction(b->dynamics, k);
            CHECK_SAME("force", x.force[0], y.force[0]);
            CHECK_SAME("force", x.force[1], y.force[1]);
            CHECK_SAME("moment", x.moment, y.moment);
        }
        YkEnergy x = yk_dynamics_energy(a->dynamics), y = yk_dynamics_energy(b->dynamics);
        CHECK_SAME("kinetic energy", x.kinetic, y.kinetic);
        CHECK_SAME("potential energy", x.potential, y.potential);
    }
}

static bool is_same_plan(const YkMechanism *a, const YkMechanism *b)
{
    bool same_plan = a->input_count == b->input_count && a->block_count == b->block_count;
    for (size_t k = 0; same_plan && k < a->input_count; k++) same_plan = a->inputs[k] == b->inputs[k];
    for (size_t k = 0; same_plan && k < a->block_count; k++) same_plan = a->blocks[k].kind == b->blocks[k].kind;
    return same_plan;
}

static void compare(Case *c, Rig *a, Rig *b)
{
    size_t k = 0;
    YkStatus one = yk_state_assemble(a->state), two = yk_state_assemble(b->state);
    CHECK_SAME("status of assembling", one, two);
    if (one < 0) return;
    for (; k < a->mech->block_count; k++)
        CHECK_SAME("branch", yk_state_branch(a->state, k), yk_state_branch(b->state, k));
    check_poses(c, a, b);
    uint64_t seed = c->seed, again = c->seed;
    rig_move(a, &seed, 0.05, 1, 1);
    rig_move(b, &again, 0.05, 1, 1);
    one = yk_state_solve(a->state), two = yk_state_solve(b->state), k = 0;
    CHECK_SAME("status of a pose", one, two);
    if (one < 0) return;
    check_poses(c, a, b);
    check_forces(c, a, b);
    c->compared++;
}

// --- designs --------------------------------------------------------------------------------------

// follower: dynamics made once, for whatever values the variant had then.
static void check_design(Case *c, YkVariant *variant, YkDynamics *follower)
{
    double value[PARAMETERS];
    Rig fresh, rig = {.problems = yk_problems_new()};
    if (fresh_of(c, &fresh)) {
        for (size_t k = 0; k < c->count; k++) value[k] = yk_model_parameter(fresh.model, c->name[k]);
        assert_int_equal(yk_variant_set(variant, value), YK_OK);
        rig.mech = (YkMechanism *)(uintptr_t)yk_variant_mechanism(variant);
        rig.model = (YkModel *)(uintptr_t)yk_mechanism_model(rig.mech);
        rig.state = yk_state_new(rig.mech);
        rig.dynamics = follower;
        assert_non_null(rig.state);
        bool same_plan = is_same_plan(rig.mech, fresh.mech);
        if (!same_plan && !c->is_special) print_error("%s: solved in another order than anew\n", c->label);
        assert_true(same_plan || c->is_special);
        if (same_plan) compare(c, &rig, &fresh);
    }
    rig.model = NULL;
    rig.mech = NULL;
    rig.dynamics = NULL;
    rig_free(&rig);
    rig_free(&fresh);
}

// A variant of those parameters that can vary, chosen at random; NULL where none can.
static YkVariant *variant_of(Case *c, const YkModel *model, const YkMechanism *mech)
{
    c->count = 0;
    for (size_t k = 0; k < model->parameter_count && c->count < PARAMETERS; k++) {
        const char *name = model->parameters[k].name;
        YkVariant *alone = check_random(&c->seed) % 4 == 0 ? NULL : yk_variant_new(mech, &name, 1, NULL);
        if (alone) c->name[c->count++] = name;
        yk_variant_free(alone);
    }
    if (c->count == 0) return NULL;
    YkProblems *problems = yk_problems_new();
    YkVariant *variant = yk_variant_new(mech, c->name, c->count, problems);
    c->is_special = yk_problems_count(problems) > 0;
    if (variant && c->is_special) assert_int_equal(yk_problems_get(problems, 0)->code, YK_CODE_SPECIAL_VALUES);
    yk_problems_free(problems);
    return variant;
}

static void check_machine(Case *c)
{
    YkProblems *problems = yk_problems_new();
    YkModel *model = load(c, 0, problems);
    if (!model) print_error("%s\n", yk_problems_text(problems, 0));
    assert_non_null(model);
    YkMechanism *mech = yk_mechanism_compile(model, NULL, problems);
    YkVariant *variant = mech ? variant_of(c, model, mech) : NULL;
    YkDynamics *follower = variant ? yk_dynamics_new(yk_variant_mechanism(variant), problems) : NULL;
    assert_true(!variant || follower);
    for (int design = 0; variant && design < DESIGNS; design++) {
        for (size_t k = 0; k < c->count; k++) {
            double own = yk_model_parameter(model, c->name[k]) / yk_model_parameter_unit(model, c->name[k]);
            double off = check_uniform(&c->seed, -0.02, 0.02);
            c->value[k] = own == 0 ? off : design == 0 ? own : own * (1 + off);
        }
        check_design(c, variant, follower);
    }
    yk_dynamics_free(follower);
    yk_variant_free(variant);
    yk_mechanism_free(mech);
    yk_model_free(model);
    yk_problems_free(problems);
}

// --- machines -------------------------------------------------------------------------------------

static const char *const examples[] = {"andrews",
                                       "car-axis",
                                       "cart-pendulum",
                                       "chebyshev",
                                       "crank-press",
                                       "double-butterfly",
                                       "double-pendulum",
                                       "elliptic-trammel",
                                       "excavator",
                                       "five-bar",
                                       "five-bar-motors",
                                       "flat-faced-cam",
                                       "four-bar",
                                       "gas-engine",
                                       "geared-five-bar",
                                       "inverted-slider-crank",
                                       "jansen",
                                       "klann",
                                       "marghitu",
                                       "n-four-bar",
                                       "oscillating-cylinder",
                                       "parallelogram",
                                       "peaucellier",
                                       "pendulum",
                                       "quick-return",
                                       "scotch-yoke",
                                       "shaking-table",
                                       "slider-crank",
                                       "spring-slider-crank",
                                       "steam-engine",
                                       "stephenson-awkward",
                                       "swing-cam",
                                       "toggle",
                                       "torsion-spring",
                                       "valve-cam",
                                       "watt-with-masses"};

static void test_examples(void **unused)
{
    (void)unused;
    size_t compared = 0;
    for (size_t k = 0; k < sizeof examples / sizeof *examples; k++) {
        Case c = {.label = examples[k], .seed = k};
        snprintf(c.path, sizeof c.path, "%s/examples/%s.yaml", YOKE_ROOT, examples[k]);
        check_machine(&c);
        compared += c.compared;
    }
    assert_true(compared > 50);
}

// Bare numbers of the text - places, masses, directions, the start - become parameters, most of them; but not the laws.
static void parametrise(const char *text, uint64_t *seed, char *out, size_t room)
{
    static char body[2 * RANDOM_TEXT];
    size_t length = 0, count = 0, written = (size_t)snprintf(out, room, "parameters: {none: 1");
    const char *laws = strstr(text, "\nlaws:"), *start = strstr(text, "\nstart:");
    for (char before = ' '; *text; before = body[length - 1]) {
        char *behind = NULL;
        bool may = strchr(" [", before) && strchr("-.0123456789", *text) && !(laws && text > laws && text < start);
        double value = may ? strtod(text, &behind) : 0;
        if (behind && behind > text && strchr(",]}\n", *behind) && count + 1 < PARAMETERS &&
            check_random(seed) % 3 != 0) {
            written += (size_t)snprintf(out + written, room - written, ", p%zu: %.17g", count, value);
            length += (size_t)snprintf(body + length, sizeof body - length, "p%zu", count++);
            text = behind;
        } else {
            body[length++] = *text++;
        }
    }
    body[length] = 0;
    snprintf(out + written, room - written, "}\n%s", body);
}

static void check_text(const char *kind, uint64_t number, const char *text, size_t *compared)
{
    static char with_parameters[3 * RANDOM_TEXT];
    char label[60];
    uint64_t seed = number;
    snprintf(label, sizeof label, "%s %d", kind, (int)number);
    parametrise(text, &seed, with_parameters, sizeof with_parameters);
    Case c = {.label = label, .text = with_parameters, .seed = number};
    check_machine(&c);
    *compared += c.compared;
}

static uint64_t machine_count(void)
{
    const char *wish = getenv("YOKE_TEST_RANDOM");
    return wish ? strtoull(wish, NULL, 10) : MACHINES;
}

static void test_random_machines(void **unused)
{
    (void)unused;
    static RandomMachine machine;
    size_t compared = 0;
    for (uint64_t k = 0; k < machine_count(); k++) {
        random_machine(&machine, 104729 * k + 7);
        check_text("random machine", k, machine.text, &compared);
    }
    assert_true(compared > machine_count());
}

static void test_geared_linkages(void **unused)
{
    (void)unused;
    static Geared machine;
    size_t compared = 0;
    for (uint64_t k = 0; k < machine_count(); k++) {
        geared_machine(&machine, k);
        check_text("geared linkage", k, machine.text, &compared);
    }
    assert_true(compared > machine_count() / 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_examples),
        cmocka_unit_test(test_random_machines),
        cmocka_unit_test(test_geared_linkages),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
