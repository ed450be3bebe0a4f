// Shared by the searches of a sketch: its counts, and a list of what it lacks.
#include <stdarg.h>
#include "sketch/sketch.h"

YkLack *yk_sketch_add(YkSketch *sketch, YkLackKind kind)
{
    if (!YK_ROOM(sketch->lacks, sketch->lack_count, sketch->lack_capacity)) {
        sketch->failed = true;
        return NULL;
    }
    YkLack *lack = &sketch->lacks[sketch->lack_count++];
    *lack = (YkLack){
        .kind = kind, .body = YK_NOT_FOUND, .point = YK_NOT_FOUND, .other = YK_NOT_FOUND, .coordinate = YK_NOT_FOUND};
    return lack;
}

const char *yk_sketch_words(YkSketch *sketch, const char *format, ...)
{
    va_list arguments;
    yk_text_clear(&sketch->text);
    va_start(arguments, format);
    yk_text_vformat(&sketch->text, format, arguments);
    va_end(arguments);
    return yk_arena_copy(sketch->arena, yk_text_get(&sketch->text), sketch->text.length);
}

size_t yk_sketch_joint_count(const YkSketch *sketch)
{
    return sketch->model->joint_count - sketch->model->carriage_count - sketch->model->held_joints;
}

int yk_sketch_freedom(const YkSketch *sketch)
{
    YkFreedom freedom = yk_mechanism_freedom(sketch->mech);
    return (freedom.by_rank >= 0 ? freedom.by_rank : freedom.gruebler) + 3 * (int)sketch->model->held_joints;
}
