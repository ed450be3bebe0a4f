// Task files to begin with, one of each kind.
#include "verbs/new/tasks.h"

const YkTaskExample yk_task_examples[] = {
    {"path",
     "# A point of the coupler through points, in order. `yoke synthesize` searches from random starts.\n"
     "name: my path\n"
     "synthesis: path\n"
     "points: [[0, 0], [10, 4], [20, 6], [30, 5], [40, 1]]\n"
     "angles: {from: free, step: 20 deg}        # of the input; or one for each point; leave it out to have any\n"
     "mechanisms: [four-bar]                    # also slider-crank\n"
     "bounds: {lengths: [10, 200], pivots: [[-150, -150], [150, 150]]}   # also coupler_point: [from, to]\n"
     "require: {transmission: 30 deg}           # also input: turns, order: false, size_ratio: 6\n"
     "best: 5\n"
     "units: {length: mm, angle: deg}\n"},
    {"motion",
     "# A body through positions. Two to five are met exactly; `yoke synthesize` finds four-bars that do it.\n"
     "name: my motion\n"
     "synthesis: motion\n"
     "positions:                                # of the body's own axes: origin and angle\n"
     "  - {at: [0, 0], angle: 0 deg}\n"
     "  - {at: [50, 100], angle: 20 deg}\n"
     "  - {at: [150, 150], angle: 35 deg}\n"
     "fix: {input_pivot: [190, -70], output_pivot: [-190, -130]}   # with three positions; leave it out to have pivots "
     "found\n"
     "bounds: {lengths: [20, 1000]}             # also pivots: [[x, y], [x, y]], coupler_point: [from, to]\n"
     "require: {transmission: 15 deg}           # also input: turns, order: false, size_ratio: 6\n"
     "best: 10\n"
     "units: {length: mm, angle: deg}\n"},
    {"function", "# An output angle that follows an input angle: three, four or five points are met exactly.\n"
                 "name: my function\n"
                 "synthesis: function\n"
                 "of: log10(x)                              # or pairs: [[0, 0], [20 deg, 12 deg], [50 deg, 30 deg]]\n"
                 "x: [1, 2]\n"
                 "input: 60 deg                             # the range of the input while x goes through its own\n"
                 "output: 90 deg\n"
                 "samples: 4                                # 3, 4 or 5, in Chebyshev's spacing\n"
                 "require: {transmission: 30 deg}\n"
                 "units: {angle: deg}\n"},
    {"stroke", "# A rocker's swing with its time ratio, and the best transmission angle.\n"
               "name: my stroke\n"
               "synthesis: stroke\n"
               "swing: 40 deg                             # or stroke: 100 mm, of a slider\n"
               "time_ratio: 1.2\n"
               "fix: {output: 80 mm}                      # one length settles the size of a crank-rocker\n"
               "units: {length: mm, angle: deg}\n"},
    {"machine", "# Parameters of an existing machine: write `yoke new four-bar > four-bar.yaml` beside this file.\n"
                "name: my machine\n"
                "synthesis: machine\n"
                "machine: four-bar.yaml\n"
                "free: {a: [20 mm, 60 mm], b: [80 mm, 200 mm]}   # parameters of the machine with their ranges\n"
                "over: {input: theta2, range: [0 deg, 360 deg], steps: 72}\n"
                "goals:\n"
                "  - {value: coupler.P.y, equals: 100 mm, where: [60 deg, 120 deg]}\n"
                "# - {point: coupler.P, through: [[10 mm, 80 mm], [50 mm, 90 mm]], weight: 10}\n"
                "require: [\"min(B.transmission) > 20 deg\"]\n"
                "best: 3\n"},
};
const size_t yk_task_example_count = sizeof yk_task_examples / sizeof *yk_task_examples;
