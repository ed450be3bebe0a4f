// Prints the equations of a machine, and whether an equation is true of it.
//   cc equations.c $(pkg-config --cflags --libs yoke) && ./a.out quick-return.yaml "l1*cos(theta1) = d3*cos(theta2)"
#include <stdio.h>
#include <yoke/yoke.h>

static int check(YkDerivation *derivation, const YkMechanism *mech, const char *equation, YkProblems *problems)
{
    YkState *state = yk_state_new(mech);
    int exit_code = 2;
    if (state && yk_state_set_time(state, 0, problems) >= 0 && yk_state_assemble(state) >= 0) {
        YkCheckVerdict verdict = yk_derivation_check(derivation, state, NULL, equation, problems);
        printf("%s: %s\n", equation, yk_check_kind_name(verdict.kind));
        exit_code = verdict.kind == YK_CHECK_TRUE ? 0 : 1;
    } else if (state) {
        fprintf(stderr, "%s\n", yk_state_report(state)->message); // which joint does not close
    }
    yk_state_free(state);
    return exit_code;
}

int main(int argc, char **argv)
{
    YkProblems *problems = yk_problems_new();
    YkModel *model = argc > 1 ? yk_model_load(argv[1], NULL, problems) : NULL;
    YkMechanism *mech = model ? yk_mechanism_compile(model, NULL, problems) : NULL;
    YkDerivation *derivation = mech ? yk_derivation_new(model, mech, problems) : NULL;
    int exit_code = 2;
    if (derivation && yk_derivation_page(derivation, NULL, problems) == YK_OK) {
        fputs(yk_derivation_text(derivation), stdout);
        exit_code = argc > 2 ? check(derivation, mech, argv[2], problems) : 0;
    }
    fputs(yk_problems_text(problems, 0), stderr);
    yk_derivation_free(derivation);
    yk_mechanism_free(mech);
    yk_model_free(model);
    yk_problems_free(problems);
    return exit_code;
}
