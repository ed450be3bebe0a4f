// Platforms on three legs with pins and slides under test.
#ifndef TESTS_CONFIGURATIONS_SLIDES_H
#define TESTS_CONFIGURATIONS_SLIDES_H
#include <yoke/configurations.h>
#include "solve/machine.h"

// The legs of a platform: a bar between two pins (R), a body on a line of the ground that is pinned to the platform
// (P), or a body pinned to the ground on which the platform slides (S). Dimensions are those of one configuration, in
// which no angle is turned.
static inline Machine platform_machine(const char legs[3], uint64_t seed)
{
    static const char *const leg_names[] = {"leg1", "leg2", "leg3"};
    static const char *const pins[] = {"A", "B", "C"}, *const others[] = {"D", "E", "F"};
    YkBuilder *b = yk_builder_new("platform");
    Machine m = {.problems = yk_problems_new()};
    assert_non_null(b);
    yk_builder_body(b, "platform");
    for (int k = 0; k < 3; k++) {
        double x = check_uniform(&seed, -2, 2), y = check_uniform(&seed, -2, 2), u = check_uniform(&seed, -2, 2),
               v = check_uniform(&seed, -2, 2), line = check_uniform(&seed, 0, 3);
        char along[32], coordinate[8];
        snprintf(along, sizeof along, "%.17g rad", line);
        snprintf(coordinate, sizeof coordinate, "s%d", k);
        yk_builder_body(b, leg_names[k]);
        yk_builder_point(b, "ground", pins[k], x, y);
        yk_builder_point(b, leg_names[k], pins[k], legs[k] == 'P' ? 0 : x, legs[k] == 'P' ? 0 : y);
        yk_builder_point(b, "platform", others[k], u, v);
        if (legs[k] == 'P') { // its pin is somewhere along the line from its place on the ground
            double d = check_uniform(&seed, 0.5, 2);
            yk_builder_point(b, leg_names[k], others[k], u - x - d * yk_cos(line), v - y - d * yk_sin(line));
            yk_builder_slide(b, pins[k], "ground", leg_names[k], along, pins[k], pins[k], coordinate);
        } else {
            yk_builder_point(b, leg_names[k], others[k], u, v);
            yk_builder_pin(b, pins[k], "ground", leg_names[k], pins[k], NULL);
        }
        if (legs[k] == 'S')
            yk_builder_slide(b, others[k], leg_names[k], "platform", along, others[k], others[k], coordinate);
        else
            yk_builder_pin(b, others[k], leg_names[k], "platform", others[k], NULL);
    }
    m.model = yk_builder_model(b, NULL, m.problems);
    machine_compile(&m, NULL);
    yk_builder_free(b);
    return m;
}
#endif
