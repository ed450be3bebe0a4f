// The table of options.
#include "option_table.h"
#include <string.h>
#include "cli.h"

#define POSE " solve sweep draw derive report study "
#define START " solve sweep draw simulate derive report study "
#define FORCES " solve sweep simulate gears derive "
#define MODEL " check solve sweep draw simulate cam gears rest derive code report study cognates balance map "
#define LOCKS " check solve sweep draw simulate gears rest derive code report study map "
#define FIELD(name) offsetof(YkRequest, name)

const YkOption yk_options[] = {
    {"at", 0, YK_OPTION_VALUES, FIELD(at), "NAME=VALUE", START "map ",
     "set a coordinate, in place of its drive's value; repeatable"},
    {"rate", 0, YK_OPTION_VALUES, FIELD(rate), "NAME=VALUE", START, "set a coordinate's rate; repeatable"},
    {"accel", 0, YK_OPTION_VALUES, FIELD(accel), "NAME=VALUE", POSE, "set a coordinate's acceleration; repeatable"},
    {"time", 0, YK_OPTION_WORD, FIELD(time), "VALUE", POSE "gears rest map ",
     "evaluate the drives at this time (default 0)"},
    {"param", 0, YK_OPTION_VALUES, FIELD(param), "NAME=VALUE", MODEL, "change a parameter; repeatable"},
    {"effort", 0, YK_OPTION_VALUES, FIELD(effort), "NAME=VALUE", FORCES,
     "set the effort along a coordinate, in place of what efforts: says; repeatable"},
    {"assembly", 0, YK_OPTION_WORD, FIELD(assembly), "LABEL|nearest|K",
     " solve sweep draw simulate derive report study rest map ",
     "take another configuration: by its label, the one nearest to start:, or line K of solve --all"},
    {"all", 0, YK_OPTION_SWITCH, FIELD(all), NULL, " solve ",
     "every assembly configuration at the requested pose, not only the machine's own"},
    {"within", 0, YK_OPTION_WORD, FIELD(within), "TIME", " solve synthesize ",
     "with --all: stop after this time, with what is proved by then"},
    {"solver", 0, YK_OPTION_WORD, FIELD(solver), "NAME", " solve ",
     "with --all: find the solutions of groups by elimination, by paths, or by both (default), whichever finds them "
     "all"},
    {"trust", 0, YK_OPTION_SWITCH, FIELD(trust), NULL, " solve sweep simulate draw report ",
     "do not prove that groups stay on their configuration between poses"},
    {"centers", 0, YK_OPTION_SWITCH, FIELD(centers), NULL, " solve draw ",
     "also the instant centres of all bodies, in the order in which Kennedy's theorem finds them"},
    {"centrodes", 0, YK_OPTION_WORD, FIELD(centrodes), "BODY[,BODY]", " draw ",
     "also the centrodes of two bodies, or of a body and the ground: they roll on each other"},
    {"polygon", 0, YK_OPTION_WORD, FIELD(polygon), "KIND", " solve draw ",
     "the polygon of velocities, accelerations or forces, to scale, with its construction in words"},
    {"sketch", 0, YK_OPTION_SWITCH, FIELD(sketch), NULL, " check ",
     "say what the machine still needs before it can move; the file need not be finished"},
    {"modes", 0, YK_OPTION_SWITCH, FIELD(modes), NULL, " rest ", "also the matrices M, C, K of the small motions"},
    {"over", 0, YK_OPTION_WORD, FIELD(over), "NAME=FROM:TO", " sweep draw report study map ",
     "the coordinate, or t for the time, that moves through a range"},
    {"steps", 0, YK_OPTION_WORD, FIELD(steps), "N", " sweep simulate cam draw report study balance ",
     "the number of steps, one less than the rows (default 36)"},
    {"of", 0, YK_OPTION_WORD, FIELD(of), "LIST", " solve sweep simulate study map ",
     "columns, separated by commas: coordinates, bodies, points, forces, each with .rate or .accel where it has one, "
     "as "
     "in d5,d5.rate,ram.C.x,A.force.x,theta1.effort"},
    {"plot", 0, YK_OPTION_WORD, FIELD(plot), "FILE", " sweep simulate cam map ",
     "draw the columns: FILE.svg, .pdf or .png (needs gnuplot)"},
    {"poses", 0, YK_OPTION_WORD, FIELD(poses), "N", " draw ", "with --over: N poses, faint, as a stroboscope"},
    {"trace", 0, YK_OPTION_WORDS, FIELD(trace), "BODY.POINT", " draw report cognates map ",
     "draw a point's path; repeatable"},
    {"animate", 0, YK_OPTION_WORD, FIELD(animate), "FILE", " draw ",
     "the motion as FILE.svg, .gif, .mp4 or .webm (the last three need rsvg-convert and ffmpeg)"},
    {"plain", 0, YK_OPTION_SWITCH, FIELD(plain), NULL, " report ",
     "a page without motion: no script, diagrams as pictures (needs gnuplot)"},
    {"no-labels", 0, YK_OPTION_SWITCH, FIELD(no_labels), NULL, " draw ", "without names and scale"},
    {"output", 'o', YK_OPTION_WORD, FIELD(output), "FILE", MODEL "new synthesize studio ",
     "write the answer here instead of standard output"},
    {"format", 0, YK_OPTION_WORD, FIELD(format_word), "text|json|csv",
     " check solve sweep simulate gears rest cam derive code report study synthesize cognates balance map ",
     "text for people; json and csv in SI and radians"},
    {"from", 0, YK_OPTION_WORD, FIELD(from), "TIME", " simulate ", "the time at the start (default 0)"},
    {"to", 0, YK_OPTION_WORD, FIELD(to), "TIME", " simulate draw report ", "the time at the end, as in 10s"},
    {"every", 0, YK_OPTION_WORD, FIELD(every), "TIME", " simulate ",
     "the time between two rows (default: --steps 100)"},
    {"tol", 0, YK_OPTION_WORD, FIELD(tolerance), "NUMBER", " simulate map ", "error allowed per step (default 1e-9)"},
    {"method", 0, YK_OPTION_WORD, FIELD(method), "NAME", " solve sweep simulate ",
     "how forces are found: reduced (default) or newton-euler"},
    {"step", 0, YK_OPTION_WORD, FIELD(step), "TIME", " simulate ", "the step of rk4 (default 1 ms)"},
    {"starts", 0, YK_OPTION_WORD, FIELD(starts), "N", " rest ",
     "how many random poses the search begins from (default 100)"},
    {"event", 0, YK_OPTION_PAIRS, FIELD(event), "CHANNEL=VALUE", " simulate ",
     "report when a column passes a value; repeatable"},
    {"lock", 0, YK_OPTION_WORD, FIELD(lock), "NAME", LOCKS, "engage one of the file's locks: (default: none)"},
    {"in", 0, YK_OPTION_WORD, FIELD(in), "BODY", " gears ", "input of the ratio (default: the driven body)"},
    {"out", 0, YK_OPTION_WORD, FIELD(out), "BODY", " gears ", "output of the ratio; it takes the load"},
    {"efficiency", 0, YK_OPTION_WORD, FIELD(efficiency), "NUMBER", " gears ",
     "efficiency of every mesh, for the power rolling through it (default 1)"},
    {"cam", 0, YK_OPTION_WORD, FIELD(cam), "NAME", " cam ", "which cam (default: the file's first)"},
    {"profile", 0, YK_OPTION_WORD, FIELD(profile), "FILE", " cam ",
     "write the outline to scale: FILE.svg, .dxf (in mm) or .csv (in m)"},
    {"tolerance", 0, YK_OPTION_WORD, FIELD(chord), "LENGTH", " cam ",
     "how far a chord of --profile may lie off the curve (default 0.01 mm)"},
    {"cutter", 0, YK_OPTION_WORD, FIELD(cutter), "LENGTH", " cam ", "also the path of a cutter of this radius"},
    {"compare", 0, YK_OPTION_WORD, FIELD(compare), "LIST", " cam ",
     "other laws in place of the file's, separated by commas: cycloidal,modified-sine,3-4-5"},
    {"limits", 0, YK_OPTION_WORD, FIELD(limits), "LIST", " cam ",
     "for the smallest base circle: pressure=30deg,curvature=5mm"},
    {"speed", 0, YK_OPTION_WORD, FIELD(speed), "VALUE", " cam ",
     "the cam's speed, as in 600rpm (default: its drive's)"},
    {"what", 0, YK_OPTION_WORD, FIELD(what), "LIST", " derive ",
     "parts, separated by commas: loops, jacobian, velocity, acceleration, points, free-bodies, newton-euler, energy, "
     "lagrange, gears, cam, or all of these (default); on request centers, polygons"},
    {"svg", 0, YK_OPTION_WORD, FIELD(svg), "DIR", " derive ",
     "also draw the free bodies, one SVG file for each, into this folder"},
    {"numbers", 0, YK_OPTION_SWITCH, FIELD(numbers), NULL, " derive ", "put the values of a pose beside the symbols"},
    {"check", 0, YK_OPTION_WORDS, FIELD(checks), "EQUATION", " derive ",
     "say whether an equation is true for this machine; - reads equations from standard input, one a line; repeatable"},
    {"vary", 0, YK_OPTION_WORDS, FIELD(vary), "NAME=FROM:TO:N", " study ",
     "N values of a parameter, ends included; several span a grid; repeatable"},
    {"sample", 0, YK_OPTION_WORD, FIELD(sample), "FILE", " study ",
     "draw the parameters from the distributions of a file"},
    {"designs", 0, YK_OPTION_WORD, FIELD(designs), "N", " study ",
     "how many random designs --sample makes (default: the file's designs:, or 1000)"},
    {"seed", 0, YK_OPTION_WORD, FIELD(seed), "N", " study synthesize ",
     "the seed of the random numbers of --sample (default: the file's, or 1)"},
    {"sensitivities", 0, YK_OPTION_SWITCH, FIELD(sensitivities), NULL, " study ",
     "derivatives by each parameter (of positions in two ways), and the worst case"},
    {"threads", 0, YK_OPTION_WORD, FIELD(threads), "N", " study synthesize ",
     "how many threads (default: as many as there are processors); the results do not depend on it"},
    {"fresh", 0, YK_OPTION_SWITCH, FIELD(fresh), NULL, " study ",
     "start again instead of continuing an interrupted study"},
    {"weights", 0, YK_OPTION_WORD, FIELD(weights), "F,M,T", " balance ",
     "a compromise: how much shaking force, shaking moment and input effort count"},
    {"fluctuation", 0, YK_OPTION_WORD, FIELD(fluctuation), "NUMBER", " balance ",
     "the fluctuation that the flywheel allows, (largest - least speed) / mean (default 0.05)"},
    {"defects", 0, YK_OPTION_SWITCH, FIELD(defects), NULL, " synthesize ",
     "also show the machines that were left out, each with its reason"},
    {"so-far", 0, YK_OPTION_SWITCH, FIELD(so_far), NULL, " synthesize ",
     "with --format json: also a line for each per cent of the search, and for each machine as soon as it is found"},
    {"task", 0, YK_OPTION_WORD, FIELD(task), "KIND", " new ",
     "a task file to begin with: path, motion, function, stroke or machine"},
    {"prefix", 0, YK_OPTION_WORD, FIELD(prefix), "NAME", " code ",
     "the beginning of all names in the file (default: made of the machine's name)"},
    {"kinematics", 0, YK_OPTION_SWITCH, FIELD(kinematics), NULL, " code ", "the motion alone, no forces"},
    {"single", 0, YK_OPTION_SWITCH, FIELD(single), NULL, " code ", "float in place of double"},
    {"pose", 0, YK_OPTION_VALUES, FIELD(pose), "NAME=VALUE", " map ",
     "with --reach: where the machine stands (default: its start); repeatable"},
    {"reach", 0, YK_OPTION_VALUES, FIELD(reach), "NAME=VALUE", " map ",
     "say whether the machine gets to this pose without being taken apart, and how; repeatable"},
    {"port", 0, YK_OPTION_WORD, FIELD(port), "N", " studio ", "the port of its address (default: a free one)"},
    {"no-browser", 0, YK_OPTION_SWITCH, FIELD(no_browser), NULL, " studio ",
     "only print the address, and open no browser"},
    {"quiet", 'q', YK_OPTION_SWITCH, FIELD(quiet), NULL, "*", "no notes and warnings"},
    {"help", 'h', YK_OPTION_SWITCH, FIELD(help), NULL, "*", "this help"},
    {"version", 0, YK_OPTION_SWITCH, FIELD(version), NULL, "*", "the version"},
    {NULL, 0, YK_OPTION_SWITCH, 0, NULL, NULL, NULL},
};

bool yk_option_lists(const char *verbs, const char *verb)
{
    if (*verbs == '*') return true;
    size_t length = strlen(verb);
    for (const char *at = strstr(verbs, verb); at; at = strstr(at + 1, verb))
        if (at[-1] == ' ' && at[length] == ' ') return true;
    return false;
}

bool yk_option_is_for(const YkOption *option, const char *verb)
{
    return yk_option_lists(option->verbs, verb);
}
