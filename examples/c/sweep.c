// Sweeps the first input of a machine through a turn and prints where a point goes: sweep FILE X-CHANNEL Y-CHANNEL
#include <stdio.h>
#include <yoke/yoke.h>

static YkSweep *run(YkState *state, const YkChannel channels[2], YkProblems *problems)
{
    const YkMechanism *mech = yk_state_mechanism(state);
    YkSweepOptions options = yk_default_sweep_options();
    options.coordinate = (int)yk_input_coordinate(mech, 0);
    options.to = 6.283185307179586;
    options.steps = 72;
    return yk_sweep_run(state, &options, channels, 2, problems);
}

int main(int count, char **word)
{
    if (count != 4) return fputs("usage: sweep FILE X-CHANNEL Y-CHANNEL\n", stderr), 2;
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_load(word[1], NULL, problems);
    YkMechanism *mech = model ? yk_mechanism_compile(model, NULL, problems) : NULL;
    YkState *state = mech ? yk_state_new(mech) : NULL;
    YkChannel channels[2];
    bool ok = state && yk_channel_parse(mech, word[2], &channels[0], problems) == YK_OK &&
              yk_channel_parse(mech, word[3], &channels[1], problems) == YK_OK &&
              yk_state_set_time(state, 0, problems) >= 0 && yk_state_assemble(state) >= 0;
    YkSweep *sweep = ok ? run(state, channels, problems) : NULL;
    for (size_t row = 0; sweep && row < yk_sweep_row_count(sweep); row++)
        printf("%g %g %g\n", yk_sweep_at(sweep, row), yk_sweep_value(sweep, row, 0), yk_sweep_value(sweep, row, 1));
    YkStatus status = sweep ? yk_sweep_status(sweep) : YK_BAD_ARGUMENT;
    const char *why = state && status < 0 ? yk_state_report(state)->message : ""; // where it does not close
    if (status < 0) fprintf(stderr, "%s %s\n%s", yk_status_name(status), why, yk_problems_text(problems, 0));
    yk_sweep_free(sweep);
    yk_state_free(state);
    yk_mechanism_free(mech);
    yk_model_free(model);
    yk_problems_free(problems);
    return status < 0;
}
