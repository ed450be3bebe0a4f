// Any bytes as a model file: loaded, compiled, assembled, turned a little. Whatever the machine, no answer is NaN or
// infinite.
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <yoke/yoke.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void demand(bool condition)
{
    if (!condition) abort();
}

static void demand_finite(YkMotion motion)
{
    demand(isfinite(motion.position) && isfinite(motion.velocity) && isfinite(motion.acceleration));
}

// Every number that the state answers with.
static void check_answers(const YkModel *model, const YkMechanism *mech, const YkState *state)
{
    char label[32];
    for (size_t i = 0; i < yk_coordinate_count(mech); i++) demand_finite(yk_state_coordinate(state, i));
    for (size_t i = 0; i < yk_model_body_count(model); i++) demand_finite(yk_state_body(state, i));
    for (size_t i = 0; i < yk_model_point_count(model); i++) {
        YkPointMotion point = yk_state_point(state, i);
        for (int k = 0; k < 2; k++)
            demand_finite((YkMotion){point.position[k], point.velocity[k], point.acceleration[k]});
    }
    for (size_t i = 0; i < yk_block_count(mech); i++) demand(isfinite(yk_state_transmission(state, i)));
    demand(isfinite(yk_state_residuals(state).position));
    yk_state_label(state, label, sizeof label);
}

static void turn_a_little(const YkModel *model, const YkMechanism *mech, YkState *state)
{
    for (int pose = 1; pose <= 3 && yk_input_count(mech) > 0; pose++) {
        YkMotion input = yk_state_input(state, 0);
        input.position += 0.01;
        yk_state_set_input(state, 0, input);
        if (yk_state_solve(state) < 0) break;
        check_answers(model, mech, state);
    }
}

static void compile_and_solve(const YkModel *model, YkProblems *problems)
{
    YkMechanism *mech = yk_mechanism_compile(model, NULL, problems);
    YkState *state = mech ? yk_state_new(mech) : NULL;
    if (state && yk_state_set_time(state, 0, problems) >= 0) {
        if (yk_state_assemble(state) >= 0) {
            check_answers(model, mech, state);
            turn_a_little(model, mech, state);
        } else {
            demand(yk_state_report(state)->message[0] != '\0');
        }
    }
    yk_state_free(state);
    yk_mechanism_free(mech);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    YkProblems *problems = yk_problems_new();
    YkModel *model = problems ? yk_model_parse((const char *)data, size, "fuzz", NULL, problems) : NULL;
    if (problems) {
        demand((model == NULL) == (yk_problems_error_count(problems) > 0));
        if (model) compile_and_solve(model, problems);
        demand(yk_problems_text(problems, 0) != NULL);
    }
    yk_model_free(model);
    yk_problems_free(problems);
    return 0;
}
