// The sketch: a machine that is not finished, and what it lacks to move. A part that is missing is no mistake here - a
// body that no joint holds, a machine without joints or drives; what is wrong with the parts that are there still is.
#ifndef YOKE_SKETCH_H
#define YOKE_SKETCH_H

#include <yoke/builder.h>
#include <yoke/mechanism.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkSketch YkSketch;

// Read like a model. NULL with problems added. Cost: of loading, which asks
// options->progress, and of compiling.
YK_API YkSketch *yk_sketch_load(const char *path, const YkLoadOptions *options, YkProblems *problems);
YK_API YkSketch *yk_sketch_parse(const char *text, size_t length, const char *name, const YkLoadOptions *options,
                                 YkProblems *problems);
YK_API YkSketch *yk_sketch_build(YkBuilder *builder, const YkLoadOptions *options, YkProblems *problems);
YK_API void yk_sketch_free(YkSketch *sketch);

// The machine as far as it goes, to be drawn and moved. Bodies that nothing connects to the ground are held there: the
// first of each group by a weld, axes on axes. These welds stand behind the sketch's own joints.
YK_API const YkModel *yk_sketch_model(const YkSketch *sketch);
YK_API const YkMechanism *yk_sketch_mechanism(const YkSketch *sketch);
YK_API size_t yk_sketch_joint_count(const YkSketch *sketch); // of its own
// Degrees of freedom in all, three for each group that floats; by rank where the loops close, otherwise by Gruebler's
// count.
YK_API int yk_sketch_freedom(const YkSketch *sketch);

typedef enum YkLackKind {
    YK_LACK_BODY,       // there is nothing but the ground
    YK_LACK_CONNECTION, // a group of bodies that no chain of joints connects to the ground
    YK_LACK_FREEDOM,    // all is connected, and nothing can move
    YK_LACK_DRIVE,      // a freedom that nothing drives
    YK_LACK_END         // a point at the end of a chain, which nothing uses
} YkLackKind;
// Something that is missing, and what would mend it. Texts belong to the sketch.
typedef struct YkLack {
    YkLackKind kind;
    bool is_optional;         // the machine moves without it: open ends, and freedoms that masses and loads move
    size_t freedom;           // how many degrees of freedom it leaves open
    size_t body;              // CONNECTION: the group's first; END: whose end; else YK_NOT_FOUND
    size_t body_count;        // CONNECTION: how many the group has
    size_t point;             // END: the point; CONNECTION: the point at which it could be pinned, or YK_NOT_FOUND
    size_t other;             // the point of another body to which that one could be pinned, or YK_NOT_FOUND
    size_t coordinate;        // DRIVE: of the mechanism; else YK_NOT_FOUND
    const char *text;         // one sentence: "nothing drives `theta`"
    const char *mend;         // one sentence
    const char *path, *value; // the same for yk_builder_set: "drives/theta", "1 rad/s * t"; NULL: there is a choice
} YkLack;
// Missing parts in the order of the kinds.
YK_API size_t yk_sketch_lack_count(const YkSketch *sketch);
YK_API YkLack yk_sketch_lack(const YkSketch *sketch, size_t index);
YK_API const char *yk_lack_kind_name(YkLackKind kind); // "body", "connection", "freedom", "drive", "end"
// Does it lack nothing but what is optional?
YK_API bool yk_sketch_moves(const YkSketch *sketch);

#ifdef __cplusplus
}
#endif

#endif
