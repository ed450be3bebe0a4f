#include <string.h>
#include "cli.h"

const YkVerb yk_verbs[] = {
    {"check", "what the machine is: freedom, loops, order of solution", "FILE [options]",
     "Reads a model file and tells what machine it describes: bodies, joints, coordinates; its degrees of\n"
     "freedom, by Gruebler's count and by the rank of the loop equations; its loops; the order in which it is\n"
     "solved, block by block; constraints that repeat others; the Grashof class of its four-bars.",
     "yoke check examples/quick-return.yaml", yk_run_check},
    {"solve", "one pose: positions, velocities, accelerations", "FILE [options]",
     "Solves one pose: by default that of `start:` at t = 0. Values take units and parameters: 30deg, a1/2.\n"
     "--at keeps the rate and acceleration of the coordinate's drive unless they are given too.",
     "yoke solve examples/quick-return.yaml --at theta1=30deg", yk_run_solve},
    {"sweep", "many poses: a table or a plot over a coordinate or time", "FILE --over NAME=FROM:TO [options]",
     "Moves a coordinate, or time (t), through a range and tabulates what --of names: coordinates (theta2,\n"
     "theta2.rate, theta2.accel), bodies (lever.angle), points (ram.C.x, ram.C.speed), transmission angles\n"
     "(C.transmission). Finds limits, dead points, change points and extremes. At a limit the rows so far\n"
     "come, the exit code is 1, and every range in which this configuration closes is told.",
     "yoke sweep examples/quick-return.yaml --over theta1=0:180deg --of d5,d5.rate --plot ram.svg", yk_run_sweep},
    {"draw", "the machine as a picture: SVG, PDF, PNG", "FILE [options]",
     "Draws the machine at one pose, as SVG on standard output or as a file of the kind its ending says.\n"
     "With --over and --poses a stroboscope; with --trace the paths of points.",
     "yoke draw examples/quick-return.yaml --over theta1=0:180deg --poses 9 --trace ram.C -o ram.svg", yk_run_draw},
    {"explain", "what a message's code means", "[CODE]",
     "Explains a code such as E0401 as it stands behind every message; without one, lists them all.",
     "yoke explain E0602", yk_run_explain},
    {"derive", "the equations, in symbols", "FILE [options]", "", "", NULL},
    {"gears", "ratios, torques and power flow of a gear train", "FILE [options]", "", "", NULL},
    {"cam", "motion program, profile and pressure angle of a cam", "FILE [options]", "", "", NULL},
    {"simulate", "motion in time under loads", "FILE [options]", "", "", NULL},
    {"report", "all of it as one page", "FILE [options]", "", "", NULL},
    {"code", "C for this machine", "FILE [options]", "", "", NULL},
    {NULL, NULL, NULL, NULL, NULL, NULL},
};

const YkVerb *yk_verb_find(const char *name)
{
    for (const YkVerb *verb = yk_verbs; verb->name; verb++)
        if (strcmp(verb->name, name) == 0) return verb;
    return NULL;
}
