// Gear trains: speeds, ratios, torques and power of a model's gears, racks and belts, exactly and without a pose.
//
// Every body of the train has one angular speed against the ground. Each mesh gives one equation between those of its
// two gears and its carrier (Willis 1841); locks and drives give more. The solution is exact: each speed is a sum of
// fractions times the input speeds. The same equations give the torques by virtual work.
#ifndef YOKE_TRAIN_H
#define YOKE_TRAIN_H

#include <stdbool.h>
#include <yoke/model.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkTrain YkTrain;

typedef struct YkTrainEffort { // replaces what `efforts:` says
    const char *coordinate;
    double value; // N m, N
} YkTrainEffort;

typedef struct YkTrainOptions {
    const char *lock;  // one of `locks:`; NULL: none is engaged
    const char *in;    // body whose turning is the ratio's input; NULL: the driven one, or `input`, or `in`
    const char *out;   // body that takes the output; NULL: `output` or `out`
    double efficiency; // of every mesh: of the power that rolls through it (seen from its carrier); (0, 1]
    double time;       // s, at which drives that are not steady are evaluated
    const YkTrainEffort *efforts;
    size_t effort_count;
} YkTrainOptions;
YK_API YkTrainOptions yk_default_train_options(void);

// Analyses the train. Returns NULL with problems added: no gears in the model, an unknown name, numbers beyond
// 2048 bits. Locked and undetermined trains are answers: see yk_train_status. The model must outlive the train.
// Cost: an elimination in exact fractions, O(meshes * rows touched); formulas only for trains that are not too large.
YK_API YkTrain *yk_train_new(const YkModel *model, const YkTrainOptions *options, YkProblems *problems);
YK_API void yk_train_free(YkTrain *train);

typedef enum YkTrainStatus {
    YK_TRAIN_STATUS_OK,           // every body's speed is determined
    YK_TRAIN_STATUS_FREE,         // nothing drives it: there are relations, but no speeds
    YK_TRAIN_STATUS_UNDETERMINED, // the speeds of some bodies are not determined: the message names them
    YK_TRAIN_STATUS_LOCKED        // constraints and drives contradict each other: the message names them
} YkTrainStatus;
YK_API YkTrainStatus yk_train_status(const YkTrain *train);
YK_API const char *yk_train_status_name(YkTrainStatus status); // "ok", "free", "undetermined", "locked"
YK_API const char *yk_train_message(const YkTrain *train);     // one sentence; "" if all is well
YK_API int yk_train_freedom(const YkTrain *train);             // under the lock, before any drive
YK_API const char *yk_train_lock(const YkTrain *train);        // NULL: none

// An input, which turns the train: a drive or, without any, one turn of the body `in`.
typedef struct YkTrainInput {
    const char *name; // of the coordinate or body
    bool is_unit;     // no drive: speeds are per turn of this body
    bool is_distance;
    double speed;      // rad/s, m/s
    const char *exact; // "40 rpm", "740 rad/s"; NULL if the file does not give it exactly
} YkTrainInput;
YK_API size_t yk_train_input_count(const YkTrain *train);
YK_API YkTrainInput yk_train_input(const YkTrain *train, size_t input);

// A body of the train and its speed.
typedef struct YkTrainBody {
    size_t body; // its index in the model
    bool is_determined;
    double speed;      // rad/s, counter-clockwise; NaN unless determined
    const char *exact; // "460/29 rpm"; NULL unless exact
} YkTrainBody;
YK_API size_t yk_train_body_count(const YkTrain *train);
YK_API YkTrainBody yk_train_body(const YkTrain *train, size_t member);
// The share of one input in a body's speed: the speed is the sum over the inputs of share * input.
typedef struct YkTrainShare {
    const char *exact; // "-24/29"
    double value;
    const char *formula; // in tooth numbers, "-N1*N3/(N2*N4)"; NULL if there is none
} YkTrainShare;
YK_API YkTrainShare yk_train_share(const YkTrain *train, size_t member, size_t input);

// Gears in mesh, belts and racks, each kind in the order of the file.
typedef enum YkTrainKind { YK_TRAIN_KIND_GEARS, YK_TRAIN_KIND_BELT, YK_TRAIN_KIND_RACK } YkTrainKind;
typedef struct YkTrainMesh {
    YkTrainKind kind;
    const char *name;
    size_t body[2]; // rack: pinion and rack
    size_t carrier;
    bool is_internal;      // also for an open belt: both turn the same way
    long long teeth[2];    // 0 for belts and racks
    const char *symbol[2]; // how formulas name teeth or radii
    double module;         // m; 0 if not known
    double radius[2];      // of the pitch circles, m; 0 if not known
    double distance;       // between the centres, m; 0 if not known
    const char *willis;    // "(sun - arm)*N1 = -(planet - arm)*N2"
    bool has_power;        // whether the rest is known
    double torque[2];      // exerted by the mesh on its two bodies, N m (rack: N)
    double carrier_torque; // exerted on its carrier
    double rolling_power;  // into the mesh by its driving body, seen from the carrier, >= 0, W
    int driver;            // 0 or 1: the driving body in that sense; -1: none
    double loss;           // W
} YkTrainMesh;
YK_API size_t yk_train_mesh_count(const YkTrain *train);
YK_API YkTrainMesh yk_train_mesh(const YkTrain *train, size_t mesh);
YK_API double yk_train_rack_speed(const YkTrain *train, size_t mesh); // of a rack on its carrier, m/s; NaN unless known

// The ratio of `in` to `out` when nothing else turns the train, or of their speeds when several drives do.
typedef struct YkTrainRatio {
    bool is_known;
    bool is_by_drives; // at the drives' speeds
    bool out_stands;   // the output does not turn: the ratio is infinite
    size_t in, out;    // bodies; YK_NOT_FOUND: not asked
    const char *exact; // "108/23"; NULL unless exact
    double value;
    const char *formula; // NULL if there is none
} YkTrainRatio;
YK_API YkTrainRatio yk_train_ratio(const YkTrain *train);

// One row of the shift table for each lock of the model, when no lock was chosen.
typedef struct YkTrainGear {
    const char *lock;
    YkTrainStatus status;
    const char *message;
    int freedom;
    YkTrainRatio ratio;
} YkTrainGear;
YK_API size_t yk_train_gear_count(const YkTrain *train);
YK_API YkTrainGear yk_train_gear(const YkTrain *train, size_t gear);

// The tabular method for wheels on one moving carrier: the turns of each wheel while the carrier stands and the first
// turns once, times x, plus y, so that all conditions hold.
typedef struct YkTrainTable {
    size_t carrier;
    size_t count; // number of wheels
    const size_t *body;
    const char *const *turns; // exact, the first "1"
    const double *turns_value;
    bool has_speeds;
    double x, y; // rad/s
    const char *exact_x, *exact_y;
} YkTrainTable;
YK_API size_t yk_train_table_count(const YkTrain *train);
YK_API YkTrainTable yk_train_table(const YkTrain *train, size_t table);

// External torques: at drives and efforts, on the output, and on what holds bodies that are locked or welded to the
// ground.
typedef struct YkTrainTorque {
    const char *name; // of the coordinate, body or entry of the lock
    const char *role; // "drive", "effort", "load", "hold", "join"
    size_t on;        // the body it acts on
    size_t from;      // the body that takes its reaction
    double torque;    // N m
    double power;     // into the train, W
} YkTrainTorque;
YK_API size_t yk_train_torque_count(const YkTrain *train); // 0: not requested, or not determined (a problem says why)
YK_API YkTrainTorque yk_train_torque(const YkTrain *train, size_t torque);
typedef struct YkTrainPower {
    bool is_known;
    double in, out, loss; // W
    double efficiency;    // out / in; NaN if no power comes in
    double circulating;   // the excess of the largest power through a mesh over the power that comes in, W; 0: none
    const char *mesh;     // the mesh of that power; NULL if none
} YkTrainPower;
YK_API YkTrainPower yk_train_power(const YkTrain *train);

// Remarks on the teeth: equal spacing of planets, room between them, undercut.
typedef struct YkTrainRemark {
    const char *mesh;
    bool is_fault;    // cannot be built like this
    const char *text; // one sentence
} YkTrainRemark;
YK_API size_t yk_train_remark_count(const YkTrain *train);
YK_API YkTrainRemark yk_train_remark(const YkTrain *train, size_t remark);

#ifdef __cplusplus
}
#endif

#endif
