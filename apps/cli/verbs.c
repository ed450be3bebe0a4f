// The table of verbs.
#include <string.h>
#include "cli.h"

const YkVerb yk_verbs[] = {
    {"new", "a machine to begin with, from the gallery", "[NAME]",
     "Prints a model file of the gallery with a comment on what it shows; without a name, lists them all.",
     "yoke new four-bar > my.yaml", yk_run_new},
    {"check", "what the machine is: freedom, loops, order of solution", "FILE [options]",
     "Reads a model file and describes the machine: its bodies, joints and coordinates; its degrees of freedom, by "
     "Gruebler's count and by the rank of the loop equations; its loops; the order of solution, block by block; "
     "redundant constraints; the Grashof class of its four-bars. --sketch says what an unfinished machine still needs "
     "before it can move.",
     "yoke check examples/quick-return.yaml", yk_run_check},
    {"solve", "one pose: positions, velocities, accelerations, forces", "FILE [options]",
     "Solves one pose: by default that of `start:` at t = 0. Values take units and parameters: 30deg, a1/2. "
     "--at keeps the rate and acceleration of the coordinate's drive unless they are given too. --of prints any "
     "quantity by its name: S.distance, rod.B.speed, theta1.effort.",
     "yoke solve examples/quick-return.yaml --at theta1=30deg", yk_run_solve},
    {"sweep", "many poses: a table or a plot over a coordinate or time", "FILE --over NAME=FROM:TO [options]",
     "Moves a coordinate, or time (t), through a range and tabulates what --of names: coordinates (theta2, "
     "theta2.rate, theta2.accel), bodies (lever.angle), points (ram.C.x, ram.C.speed), transmission angles "
     "(C.transmission). Finds limits, dead points, change points and extremes. At a limit it "
     "gives the rows so far and every range in which this configuration closes, and exits with 1.",
     "yoke sweep examples/quick-return.yaml --over theta1=0:180deg --of d5,d5.rate --plot ram.svg", yk_run_sweep},
    {"simulate", "motion in time under loads", "FILE --to TIME [options]",
     "Lets the machine move from `start:` with its masses, gravity, efforts, forces, springs, friction and "
     "stops, and prints the columns of --of row by row; then the events on the way, the work of each load, and "
     "the errors of energy and loops.",
     "yoke simulate examples/double-pendulum.yaml --to 10s --every 0.5s --of theta1,theta2,energy", yk_run_simulate},
    {"rest", "equilibria, and small vibrations about them", "FILE [options]",
     "Finds the poses in which the machine stands still under its loads: with one freedom by searching all circuits of "
     "its map, otherwise by a search from `start:` and from many random poses, which may miss some. Says whether each "
     "equilibrium is stable, and gives the natural frequencies, damping and shapes of "
     "the small motions about it; with --modes also the matrices M, C, K. Drives are held; stops and dry friction are "
     "ignored.",
     "yoke rest examples/rocking-four-bar.yaml --modes", yk_run_rest},
    {"study", "many designs: grids, tolerances, sensitivities", "FILE --vary NAME=FROM:TO:N | --sample FILE [options]",
     "Computes the columns of --of for many values of the file's parameters: a grid (--vary) or random designs "
     "(--sample, with uniform, normal and triangular distributions), at one pose or, with --over, through a whole "
     "cycle, with the least, largest and mean value and the range of each design. --sensitivities adds the "
     "derivatives by every parameter and the worst case. A design that does not close is a row with its status. "
     "With -o, repeat the command to continue an interrupted study.",
     "yoke study examples/four-bar.yaml --vary b=110mm:130mm:5 --over theta2=0:360deg --of theta4,coupler.P.y",
     yk_run_study},
    {"draw", "the machine as a picture: SVG, PDF, PNG", "FILE [options]",
     "Draws the machine at one pose, as SVG on standard output or as a file in the format of its ending. "
     "--over with --poses draws many poses in one picture, --trace the paths of points.",
     "yoke draw examples/quick-return.yaml --over theta1=0:180deg --poses 9 --trace ram.C -o ram.svg", yk_run_draw},
    {"cam", "motion program, profile and forces of a cam", "FILE [options]",
     "Analyses a cam: its motion program (segments, conditions, peak factors, peak values at the drive's speed), "
     "pressure angle, radii of curvature, undercut, the smallest base circle within limits, and with masses and "
     "springs the contact force, the camshaft's torque and the speed above which the follower lifts off. --compare "
     "puts other laws beside the file's own; --profile writes the outline to scale.",
     "yoke cam examples/cep-cam.yaml --plot svaj.svg --profile cam.dxf --tolerance 0.005mm", yk_run_cam},
    {"explain", "what a message's code means", "[CODE]",
     "Explains the code of a message, such as E0401; without a code, lists them all.", "yoke explain E0602",
     yk_run_explain},
    {"derive", "the equations, in symbols", "FILE [options]",
     "Derives the equations that an engineer would write by hand: loop equations as vector sums and in x and y, the "
     "Jacobian with its blocks and their determinants, velocities and accelerations block by block, points; free "
     "bodies, Newton's and Euler's equations, energies, Lagrange's equations. --numbers puts the values of a pose "
     "beside the symbols; --svg DIR draws the free bodies. --check 'EQUATION' says whether an equation in the file's "
     "names is true for this machine (rates: theta1' or theta1.rate; numbers in SI and radians, or with a unit); the "
     "exit status is 0 if it is true and 1 if it is false.",
     "yoke derive examples/quick-return.yaml --check 'l1*cos(theta1) - d3*cos(theta2) = 0'", yk_run_derive},
    {"gears", "ratios, torques and power flow of a gear train", "FILE [options]",
     "Computes the speeds of all wheels and carriers of a gear train exactly, as fractions of the inputs and as "
     "formulas in numbers of teeth; shows Willis' equation of every mesh, the tabular method and the degrees of "
     "freedom, and says what is locked or undetermined. If the file has locks:, prints a shift table, or with --lock "
     "one of its gears. efforts: or --effort add the torques on all members and the power flow; --efficiency counts "
     "losses.",
     "yoke gears examples/gearbox-8hp70.yaml --in input --out output", yk_run_gears},
    {"report", "everything about the machine on one page", "FILE [options]",
     "Writes one self-contained HTML page: findings in sentences, the machine drawn and moving, diagrams, "
     "forces, gears, cams, dimensions, structure, the equations with their values, and the numerical errors. "
     "It shows the motion of the drives, or that of --over, or the motion under the machine's loads for as long as "
     "--to says.",
     "yoke report examples/quick-return.yaml -o report.html", yk_run_report},
    {"code", "C for this machine", "FILE [options]",
     "Prints C11 for this one machine, from the steps by which yoke solves it: positions, velocities and "
     "accelerations of coordinates and points, efforts, accelerations of free coordinates, reactions, energies; for "
     "one pose or for arrays of poses, with the parameters in a struct. The file needs only the C library, allocates "
     "nothing, and tests itself if it is compiled with -DPREFIX_TEST.",
     "yoke code examples/quick-return.yaml -o quick_return.c", yk_run_code},
    {"synthesize", "from a task to machines that fulfil it", "TASK [options]",
     "Finds machines for a task: a point through points, a body through two to five positions, an angle that follows\n"
     "another, a swing or a stroke with its time ratio, or parameters of a machine that meet goals. Every machine is\n"
     "written as a model file and driven through the task by the ordinary engine, in order, without changing branch\n"
     "or circuit. Failures are counted by reason. -o DIR writes the files, one picture of all, and task.json.",
     "yoke synthesize examples/tasks/five-positions.yaml -o machines", yk_run_synthesize},
    {"studio", "draw the machine, move it and read it, in the browser", "[FILE] [options]",
     "Opens Studio, a page on which you draw, move and read a machine, for this file: it saves into the file and\n"
     "follows changes by other programs. A small server on this computer serves the page, at an address that contains\n"
     "a secret word; Ctrl-C ends it. With -o, writes the page with the machine in it as one HTML file that opens\n"
     "from disk and needs no server.",
     "yoke studio examples/four-bar.yaml -o four-bar.html", yk_run_studio},
    {"map", "all circuits of the motion, or regions over two freedoms", "FILE [options]",
     "Follows every configuration along one coordinate and shows the whole motion: all circuits of the machine with\n"
     "their ranges, where each turns back (limits), where branches cross (change points), where the drive is at a\n"
     "dead point, which joints turn fully, and which circuit contains the start. Between events the number of\n"
     "configurations is proved constant, so that none is missing. --plot draws the map, with --trace also the coupler\n"
     "curves of all circuits. --over A,B maps two freedoms: regions of equally many configurations; over a point's x\n"
     "and y, its workspace.",
     "yoke map examples/four-bar.yaml --over theta4", yk_run_map},
    {"cognates", "other machines with the same coupler curve", "FILE [options]",
     "Finds the two other four-bars, or the other slider-crank, whose couplers trace the same curve (Roberts), and\n"
     "measures with the engine the distance between the curves. --trace BODY.POINT names the coupler's point. -o DIR\n"
     "writes a model file for each and a picture of all.",
     "yoke cognates examples/four-bar.yaml -o cognates", yk_run_cognates},
    {"balance", "counterweights and flywheel", "FILE [options]",
     "Computes how a machine with masses shakes its frame over a cycle: force, moment and torque. Finds the\n"
     "counterweights that keep its centre of mass still, or as still as possible, and the shaking with them; then the\n"
     "flywheel for a given fluctuation of speed. -o DIR writes the model with its counterweights.",
     "yoke balance examples/watt-with-masses.yaml", yk_run_balance},
    {NULL, NULL, NULL, NULL, NULL, NULL},
};

const YkVerb *yk_verb_find(const char *name)
{
    for (const YkVerb *verb = yk_verbs; verb->name; verb++)
        if (strcmp(verb->name, name) == 0) return verb;
    return NULL;
}
