// The sketch: a machine that is not finished, and what it still needs before it can move. A missing part is not a
// mistake here, such as a body that no joint holds, or a machine without joints or drives. Mistakes in the parts that
// are there remain mistakes.
#ifndef YOKE_SKETCH_H
#define YOKE_SKETCH_H

#include <yoke/builder.h>
#include <yoke/mechanism.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkSketch YkSketch;

// Each reads a sketch as a model is read. Returns NULL with problems added. Cost: that of loading, which
// options->progress watches, and of compiling.
YK_API YkSketch *yk_sketch_load(const char *path, const YkLoadOptions *options, YkProblems *problems);
YK_API YkSketch *yk_sketch_parse(const char *text, size_t length, const char *name, const YkLoadOptions *options,
                                 YkProblems *problems);
YK_API YkSketch *yk_sketch_build(YkBuilder *builder, const YkLoadOptions *options, YkProblems *problems);
YK_API void yk_sketch_free(YkSketch *sketch);

// The machine as far as it is described, to be drawn and moved. Bodies that nothing connects to the ground are held
// there: the first of each group by a weld, with its axes on those of the ground. These welds follow the sketch's own
// joints.
YK_API const YkModel *yk_sketch_model(const YkSketch *sketch);
YK_API const YkMechanism *yk_sketch_mechanism(const YkSketch *sketch);
YK_API size_t yk_sketch_joint_count(const YkSketch *sketch); // of its own
// Returns all degrees of freedom, with three for each floating group; by rank if the loops close, otherwise by
// Gruebler's count.
YK_API int yk_sketch_freedom(const YkSketch *sketch);

typedef enum YkLackKind {
    YK_LACK_BODY,       // there is nothing but the ground
    YK_LACK_CONNECTION, // a group of bodies that no chain of joints connects to the ground
    YK_LACK_FREEDOM,    // all is connected, and nothing can move
    YK_LACK_DRIVE,      // a freedom that nothing drives
    YK_LACK_END         // a point at the end of a chain, which nothing uses
} YkLackKind;
// Something that is missing, and what would supply it. Texts belong to the sketch.
typedef struct YkLack {
    YkLackKind kind;
    bool is_optional;         // the machine moves without it: open ends, and freedoms that masses and loads move
    size_t freedom;           // the number of degrees of freedom that remain open without it
    size_t body;              // CONNECTION: the first of the group; END: the body with the end; else YK_NOT_FOUND
    size_t body_count;        // CONNECTION: the number of bodies in the group
    size_t point;             // END: the point; CONNECTION: the point at which it could be pinned, or YK_NOT_FOUND
    size_t other;             // the point of another body to which that one could be pinned, or YK_NOT_FOUND
    size_t coordinate;        // DRIVE: of the mechanism; else YK_NOT_FOUND
    const char *text;         // one sentence: "nothing drives `theta`"
    const char *mend;         // one sentence
    const char *path, *value; // the same for yk_builder_set: "drives/theta", "1 rad/s * t"; NULL: several are possible
} YkLack;
// Missing parts in the order of the kinds.
YK_API size_t yk_sketch_lack_count(const YkSketch *sketch);
YK_API YkLack yk_sketch_lack(const YkSketch *sketch, size_t index);
YK_API const char *yk_lack_kind_name(YkLackKind kind); // "body", "connection", "freedom", "drive", "end"
// Returns whether everything that is missing is optional.
YK_API bool yk_sketch_moves(const YkSketch *sketch);

#ifdef __cplusplus
}
#endif

#endif
