// The builder: a machine made by calls, and machines written as model files.
//
// Calls and files are the same thing: a builder collects what a model file would say, and the loader reads it. Whatever
// the format has can be said; whatever is wrong is found by the same checks. A problem then says in `where` what it is
// about, as in "body `crank`, point `A`".
#ifndef YOKE_BUILDER_H
#define YOKE_BUILDER_H

#include <yoke/model.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkBuilder YkBuilder;

// Starts an empty machine; name may be NULL. NULL when out of memory.
YK_API YkBuilder *yk_builder_new(const char *name);
YK_API void yk_builder_free(YkBuilder *builder);

// The calls below say one thing each, in any order where no order is told; texts are copied. They return nothing: what
// is wrong, and memory that ran out, is kept and told by yk_builder_model. Numbers are in the file's units: SI and
// radians unless "units" is set. Where a value is a text it is an expression as in a file, with units: "30 deg",
// "l1 + l2", "20 rpm * t".

YK_API void yk_builder_parameter(YkBuilder *builder, const char *name, const char *value);
YK_API void yk_builder_gravity(YkBuilder *builder, double x, double y);

// Bodies before what stands on them; the ground, "ground", is there from the start.
YK_API void yk_builder_body(YkBuilder *builder, const char *body);
YK_API void yk_builder_point(YkBuilder *builder, const char *body, const char *point, double x, double y);
// The centre of mass in the body's axes; the inertia is about it.
YK_API void yk_builder_mass(YkBuilder *builder, const char *body, double mass, double center_x, double center_y,
                            double inertia);
// A uniform rod between two points of the body.
YK_API void yk_builder_rod(YkBuilder *builder, const char *body, double mass, const char *from, const char *to);

// Joints. Coordinates (angle, distance: of the second body relative to the first) may be NULL: they have no name then.
// A pin or weld lies at the point `at` of both bodies; NULL: at the points of the joint's own name.
YK_API void yk_builder_pin(YkBuilder *builder, const char *joint, const char *first, const char *second, const char *at,
                           const char *angle);
YK_API void yk_builder_weld(YkBuilder *builder, const char *joint, const char *first, const char *second,
                            const char *at);
// Leaves everything free: x and y of the point `to` of the second body from the point `from` of the first, in its
// axes, and the angle. from, to: NULL, the origins. x, y, angle: all three, or all NULL.
YK_API void yk_builder_free_joint(YkBuilder *builder, const char *joint, const char *first, const char *second,
                                  const char *from, const char *to, const char *x, const char *y, const char *angle);
// Along a line of the first body through its point `from`: "x", "y", "-x", "-y" or an angle. from, to: NULL, the
// origins.
YK_API void yk_builder_slide(YkBuilder *builder, const char *joint, const char *first, const char *second,
                             const char *along, const char *from, const char *to, const char *distance);
// The point `at` of the second body on a line of the first, free to turn. at NULL: the point of the joint's own name.
YK_API void yk_builder_slot(YkBuilder *builder, const char *joint, const char *first, const char *second,
                            const char *along, const char *from, const char *at, const char *distance,
                            const char *angle);

YK_API void yk_builder_drive(YkBuilder *builder, const char *coordinate, const char *value); // of t
YK_API void yk_builder_start(YkBuilder *builder, const char *coordinate, double value);      // also "theta.rate"
YK_API void yk_builder_effort(YkBuilder *builder, const char *coordinate, const char *value);
// In world axes, of t, coordinates and rates; point NULL: the body's origin.
YK_API void yk_builder_force(YkBuilder *builder, const char *name, const char *body, const char *point, const char *x,
                             const char *y);
// A spring and damper between two points, "ground.P" and "link.Q"; and one along a coordinate.
YK_API void yk_builder_spring(YkBuilder *builder, const char *name, const char *from, const char *to, double stiffness,
                              double length, double damping);
YK_API void yk_builder_spring_along(YkBuilder *builder, const char *name, const char *coordinate, double stiffness,
                                    double free_value, double damping);
YK_API void yk_builder_stop(YkBuilder *builder, const char *coordinate, double low, double high);
YK_API void yk_builder_gear(YkBuilder *builder, const char *name, const char *first, const char *second,
                            int first_teeth, int second_teeth);
YK_API void yk_builder_rack(YkBuilder *builder, const char *name, const char *pinion, const char *rack, double radius);
YK_API void yk_builder_belt(YkBuilder *builder, const char *name, const char *first, const char *second,
                            double first_radius, double second_radius);

// Everything else: sets a key by its path, "units/length" or "gears/sun-planet/internal", to a value as a file writes
// it, on one line: "mm", "true", "[a, 0]", "{rise: {to: 120 deg, by: 2 cm, law: cycloidal}}", "springs/k/force" to
// "{law: coil, of: length}". What stood there is replaced; maps on the way are made.
YK_API void yk_builder_set(YkBuilder *builder, const char *path, const char *value);
YK_API void yk_builder_set_number(YkBuilder *builder, const char *path, double value); // the same bits when read back
YK_API void yk_builder_remove(YkBuilder *builder, const char *path); // with all that is in it; nothing where it is not

// Checks the machine and makes the model, as yk_model_parse does; the builder can go on to the next. NULL with problems
// added. options may be NULL. Cost linear in the machine's size.
YK_API YkModel *yk_builder_model(YkBuilder *builder, const YkLoadOptions *options, YkProblems *problems);
// What was said so far, as a model file. Belongs to the builder until its next call. NULL when out of memory.
YK_API const char *yk_builder_text(YkBuilder *builder);

// The model as a model file: read back, it is the same machine to the last bit. Of a model that came from a file or a
// text this is that text, byte for byte, with its comments and in its order, where only values that overrides
// replaced are new (and, where such a value is folded over lines by `>`, all is laid out anew, without comments). An
// engaged lock is not written. The text lives as long as the model.
YK_API const char *yk_model_text(const YkModel *model);
// Writes it to a file, which appears whole or not at all. YK_OK, YK_IO or YK_NO_MEMORY with a problem added.
YK_API YkStatus yk_model_write(const YkModel *model, const char *path, YkProblems *problems);

#ifdef __cplusplus
}
#endif

#endif
