// Balances the pole of examples/cart-pendulum.yaml upright, by a controller that samples a hundred times a second.
#include <math.h>
#include <stdio.h>
#include <yoke/yoke.h>

// The effort on the cart until the next sample, from the state of cart (0) and pole (1).
static bool balance(void *context, YkSimulation *simulation, double time)
{
    const double pi = 3.141592653589793, gain[] = {-13.0, 101.5, -16.8, 19.8};
    YkMotion cart = yk_state_coordinate(yk_simulation_state(simulation), 0);
    YkMotion pole = yk_state_coordinate(yk_simulation_state(simulation), 1);
    double effort =
        -(gain[0] * cart.position + gain[1] * (pole.position - pi) + gain[2] * cart.velocity + gain[3] * pole.velocity);
    *(double *)context = fmax(*(double *)context, fabs(effort));
    return time >= 0 && yk_simulation_act_effort(simulation, 0, effort) == YK_OK;
}

int main(int count, char **word)
{
    double largest = 0, tilt = NAN;
    YkStartValue upright[] = {{"theta", false, 3.0}, {"theta", true, 0}};
    YkSimulationOptions options = yk_default_simulation_options();
    options.values = upright;
    options.value_count = 2;
    YkProblems *problems = yk_problems_new();
    YkModel *model = count == 2 ? yk_model_load(word[1], NULL, problems) : NULL;
    YkSimulation *simulation = model ? yk_simulation_new(model, &options, problems) : NULL;
    if (simulation && yk_simulation_set_effort(simulation, "x", 0) == YK_OK &&
        yk_simulation_set_control(simulation, 0.01, balance, &largest) == YK_OK &&
        yk_simulation_advance(simulation, 5) == YK_OK)
        tilt = yk_state_coordinate(yk_simulation_state(simulation), 1).position - 3.141592653589793;
    printf("after %zu samples of at most %.1f N: %.1e rad off\n",
           simulation ? yk_simulation_sample_count(simulation) : 0, largest, tilt);
    fputs(simulation ? yk_simulation_report(simulation)->message : yk_problems_text(problems, 0), stderr);
    yk_simulation_free(simulation);
    yk_model_free(model);
    yk_problems_free(problems);
    return !(fabs(tilt) < 1e-3);
}
