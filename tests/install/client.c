// A client program of the installed package: a slider-crank from text, one pose, one number.
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <yoke/yoke.h>

static const char text[] = "bodies:\n"
                           "  ground: {points: {O: [0, 0]}}\n"
                           "  crank: {points: {O: [0, 0], A: [0.3, 0]}}\n"
                           "  rod: {points: {A: [0, 0], B: [0.5, 0]}}\n"
                           "  piston: {points: {B: [0, 0]}}\n"
                           "joints:\n"
                           "  O: {pin: [ground, crank], angle: theta}\n"
                           "  A: {pin: [crank, rod], angle: phi}\n"
                           "  B: {pin: [rod, piston]}\n"
                           "  S: {slide: [ground, piston], along: x, distance: s}\n"
                           "drives: {theta: 90 deg + 1 rad/s * t}\n"
                           "start: {phi: -120 deg, s: 0.4}\n";

int main(void)
{
    int result = 1;
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_parse(text, strlen(text), "client", NULL, problems);
    YkMechanism *mech = model ? yk_mechanism_compile(model, NULL, problems) : NULL;
    YkState *state = mech ? yk_state_new(mech) : NULL;
    if (state && yk_state_set_time(state, 0, problems) == YK_OK && yk_state_assemble(state) == YK_OK) {
        const YkMotion s = yk_state_coordinate(state, yk_coordinate_find(mech, "s"));
        printf("yoke %s: s = %.15g m, s' = %.15g m/s\n", yk_version(), s.position, s.velocity);
        result = !(fabs(s.position - 0.4) < 1e-14 && fabs(s.velocity + 0.3) < 1e-14);
    } else {
        fputs(yk_problems_text(problems, 0), stderr);
    }
    yk_state_free(state);
    yk_mechanism_free(mech);
    yk_model_free(model);
    yk_problems_free(problems);
    return result;
}
