// The builder: a machine made by calls, and machines written as model files.
//
// A builder collects what a model file would contain, and the loader reads it. So everything in the file format is
// available, and the same checks find what is wrong. A problem then says in `where` what it is about, as in
// "body `crank`, point `A`".
#ifndef YOKE_BUILDER_H
#define YOKE_BUILDER_H

#include <yoke/model.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkBuilder YkBuilder;

// Starts an empty machine; name may be NULL. Returns NULL when out of memory.
YK_API YkBuilder *yk_builder_new(const char *name);
YK_API void yk_builder_free(YkBuilder *builder);

// Each of the calls below adds one thing, in any order unless the comment gives one; texts are copied. They return
// nothing: mistakes, and memory that ran out, are kept and reported by yk_builder_model. Numbers are in the file's
// units: SI and radians unless "units" is set. A value that is a text is an expression as in a file, with units:
// "30 deg", "l1 + l2", "20 rpm * t".

YK_API void yk_builder_parameter(YkBuilder *builder, const char *name, const char *value);
YK_API void yk_builder_gravity(YkBuilder *builder, double x, double y);

// Make a body before its points and masses; the ground, "ground", exists from the start.
YK_API void yk_builder_body(YkBuilder *builder, const char *body);
YK_API void yk_builder_point(YkBuilder *builder, const char *body, const char *point, double x, double y);
// The centre of mass in the body's axes; the inertia is about it.
YK_API void yk_builder_mass(YkBuilder *builder, const char *body, double mass, double center_x, double center_y,
                            double inertia);
// A uniform rod between two points of the body.
YK_API void yk_builder_rod(YkBuilder *builder, const char *body, double mass, const char *from, const char *to);

// Joints. The names of coordinates (angle, distance: of the second body relative to the first) may be NULL.
// A pin or weld lies at the point `at` of both bodies; NULL: at the points that have the joint's name.
YK_API void yk_builder_pin(YkBuilder *builder, const char *joint, const char *first, const char *second, const char *at,
                           const char *angle);
YK_API void yk_builder_weld(YkBuilder *builder, const char *joint, const char *first, const char *second,
                            const char *at);
// Leaves everything free. x, y and angle name the coordinates (give all three, or NULL for all): the position of the
// point `to` of the second body relative to the point `from` of the first, in the first body's axes, and the angle.
// from, to: NULL means the origins.
YK_API void yk_builder_free_joint(YkBuilder *builder, const char *joint, const char *first, const char *second,
                                  const char *from, const char *to, const char *x, const char *y, const char *angle);
// A slide along a line of the first body through its point `from`. along: "x", "y", "-x", "-y" or an angle. from, to:
// NULL means the origins.
YK_API void yk_builder_slide(YkBuilder *builder, const char *joint, const char *first, const char *second,
                             const char *along, const char *from, const char *to, const char *distance);
// A pin in a slot: the point `at` of the second body stays on a line of the first, and the body is free to turn. at
// NULL: the point that has the joint's name.
YK_API void yk_builder_slot(YkBuilder *builder, const char *joint, const char *first, const char *second,
                            const char *along, const char *from, const char *at, const char *distance,
                            const char *angle);

YK_API void yk_builder_drive(YkBuilder *builder, const char *coordinate, const char *value); // of t
YK_API void yk_builder_start(YkBuilder *builder, const char *coordinate, double value);      // also "theta.rate"
YK_API void yk_builder_effort(YkBuilder *builder, const char *coordinate, const char *value);
// A force in world axes; x and y may depend on t, coordinates and rates. point NULL: the body's origin.
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
// it, on one line: "mm", "true", "[a, 0]", "{rise: {to: 120 deg, by: 2 cm, law: cycloidal}}"; "springs/k/force" to
// "{law: coil, of: length}". Replaces what is there; makes the maps on the way.
YK_API void yk_builder_set(YkBuilder *builder, const char *path, const char *value);
YK_API void yk_builder_set_number(YkBuilder *builder, const char *path, double value); // the same bits when read back
YK_API void yk_builder_remove(YkBuilder *builder, const char *path); // with all its contents; does nothing if absent

// Checks the machine and makes the model, as yk_model_parse does; the builder stays usable. Returns NULL with problems
// added. options may be NULL. Cost: linear in the machine's size.
YK_API YkModel *yk_builder_model(YkBuilder *builder, const YkLoadOptions *options, YkProblems *problems);
// Returns what the builder has so far, as a model file. The text is valid until the builder's next call. Returns NULL
// when out of memory.
YK_API const char *yk_builder_text(YkBuilder *builder);

// Returns the same machine with two slides and a pin that carry a point, so that the point's place is a pair of
// coordinates and can be an input: PREFIXx and PREFIXy are the coordinates, bodies and joints that are added (and the
// joint PREFIXpin), and the point stands at `at`, m, at the start. The point is to move with its body. options as for
// loading. Returns NULL with problems added.
YK_API YkModel *yk_model_carry_point(const YkModel *model, size_t point, const char *prefix, const double at[2],
                                     const YkLoadOptions *options, YkProblems *problems);

// Returns the model as a model file: read back, it is the same machine to the last bit. If the model came from a file
// or a text, it is that text, byte for byte, with its comments and in its order; only values that overrides replaced
// are new. (If such a value is folded over lines by `>`, everything is laid out anew, without comments.) An engaged
// lock is not written. The text lives as long as the model.
YK_API const char *yk_model_text(const YkModel *model);
// Writes the model to a file, which appears whole or not at all. Returns YK_OK, or YK_IO or YK_NO_MEMORY with a problem
// added.
YK_API YkStatus yk_model_write(const YkModel *model, const char *path, YkProblems *problems);

#ifdef __cplusplus
}
#endif

#endif
