// The model: one planar machine as its file describes it, by name, validated, in SI units and radians.
#ifndef YOKE_MODEL_H
#define YOKE_MODEL_H

#include <stdbool.h>
#include <yoke/problem.h>
#include <yoke/progress.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkModel YkModel;

// A value that replaces the one in the file, as `--param NAME=VALUE` gives it.
typedef struct YkOverride {
    const char *name;
    const char *value; // an expression of parameters, with units: "750 mm"
} YkOverride;

typedef struct YkLoadOptions {
    const YkOverride *parameters;
    size_t parameter_count;
    const char *lock; // entry of `locks:` that is engaged: holds its bodies and coordinates from the start; NULL: none
    YkProgress progress; // watches the loading; {NULL}: not watched
} YkLoadOptions;

YK_API YkLoadOptions yk_default_load_options(void);

// Reads and validates a model file. Adds every problem of the file to `problems`, even if the model loads.
// Returns NULL if there was an error. options may be NULL. Cost: linear in the size of the file.
YK_API YkModel *yk_model_load(const char *path, const YkLoadOptions *options, YkProblems *problems);
// Does the same for text in memory; `name` stands for the file's name in messages.
YK_API YkModel *yk_model_parse(const char *text, size_t length, const char *name, const YkLoadOptions *options,
                               YkProblems *problems);
YK_API void yk_model_free(YkModel *model);

// The contents of the machine. Body 0 is the ground. Names live as long as the model.
YK_API const char *yk_model_name(const YkModel *model);
YK_API size_t yk_model_body_count(const YkModel *model);
YK_API const char *yk_model_body_name(const YkModel *model, size_t body);
YK_API size_t yk_model_point_count(const YkModel *model); // points of all bodies
YK_API const char *yk_model_point_name(const YkModel *model, size_t point);
YK_API size_t yk_model_point_body(const YkModel *model, size_t point);
YK_API size_t yk_model_joint_count(const YkModel *model);
YK_API const char *yk_model_joint_name(const YkModel *model, size_t joint);
// A joint's kind as the file writes it ("pin", "slide", "pin-slot", "weld", "free"), and its first (side 0) and second
// body.
YK_API const char *yk_model_joint_kind(const YkModel *model, size_t joint);
YK_API size_t yk_model_joint_body(const YkModel *model, size_t joint, int side);
// Writes the place of a point in its body's axes, m: as yk_drag_new and YkPull take it.
YK_API void yk_model_point_place(const YkModel *model, size_t point, double place[2]);
// Returns the index of a name, YK_NOT_FOUND if there is none. The name of a point is "body.point".
YK_API size_t yk_model_find_body(const YkModel *model, const char *name);
YK_API size_t yk_model_find_point(const YkModel *model, const char *body_dot_point);
YK_API size_t yk_model_find_joint(const YkModel *model, const char *name);
// The numbers of masses and loads in the file. Gravity counts if it is given and not zero.
typedef struct YkLoadCounts {
    bool has_gravity;
    size_t masses; // number of bodies with mass or inertia
    double mass;   // total, kg
    size_t efforts, forces, springs, dampers, frictions, stops;
} YkLoadCounts;
YK_API YkLoadCounts yk_model_loads(const YkModel *model);
YK_API double yk_model_body_mass(const YkModel *model, size_t body); // kg; 0 if the file gives none
// The kind of quantity that a text such as "30deg", "a1/2" or "0.5 rad/s" stands for.
typedef enum YkQuantity {
    YK_QUANTITY_NUMBER,
    YK_QUANTITY_ANGLE,
    YK_QUANTITY_LENGTH,
    YK_QUANTITY_TIME,
    YK_QUANTITY_ANGLE_RATE,
    YK_QUANTITY_SPEED,
    YK_QUANTITY_ANGLE_ACCELERATION,
    YK_QUANTITY_ACCELERATION,
    YK_QUANTITY_FORCE,
    YK_QUANTITY_TORQUE,
    YK_QUANTITY_ENERGY,
    YK_QUANTITY_MASS,
    YK_QUANTITY_UNBALANCE, // a mass times its distance
    YK_QUANTITY_INERTIA
} YkQuantity;
// Reads `text` as such a quantity and converts it to SI. Returns YK_OK, or YK_BAD_ARGUMENT with a problem added.
YK_API YkStatus yk_model_value(const YkModel *model, const char *text, YkQuantity quantity, double *value,
                               YkProblems *problems);
// Returns the unit in which the file gives such a quantity, for tables: its name ("deg"), and its size in SI (pi/180).
YK_API const char *yk_model_unit(const YkModel *model, YkQuantity quantity, double *size);

// Returns the value of a parameter in the file, SI; NaN for an unknown name.
YK_API double yk_model_parameter(const YkModel *model, const char *name);
// Reads a value for a parameter, as --param takes it: units, other parameters, bare numbers in the file's units.
// Returns YK_OK, or YK_BAD_ARGUMENT with a problem added.
YK_API YkStatus yk_model_parameter_read(const YkModel *model, const char *name, const char *text, double *value,
                                        YkProblems *problems);
// Returns the size in SI of the unit in which the file gives a parameter (0.001 for mm); 1 for an unknown name.
YK_API double yk_model_parameter_unit(const YkModel *model, const char *name);

#ifdef __cplusplus
}
#endif

#endif
