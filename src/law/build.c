// The builder of laws: pieces in order, and the segments they belong to.
#include "law/build.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "law/inside.h"

// Ends and periods that differ only by rounding agree.
#define SAME 1e-9

YkLawBuilder *yk_law_builder_new(double from, double value)
{
    YkLawBuilder *builder = malloc(sizeof *builder);
    if (builder) *builder = (YkLawBuilder){.from = from, .at = from, .value = value};
    return builder;
}

void yk_law_builder_free(YkLawBuilder *builder)
{
    if (!builder) return;
    free(builder->pieces);
    free(builder->numbers);
    free(builder->segments);
    free(builder->conditions);
    free(builder);
}

double yk_law_builder_at(const YkLawBuilder *builder)
{
    return builder->at;
}
double yk_law_builder_value(const YkLawBuilder *builder)
{
    return builder->value;
}
size_t yk_law_builder_culprit(const YkLawBuilder *builder)
{
    return builder->culprit;
}

double yk_law_builder_trouble(const YkLawBuilder *builder)
{
    return builder->trouble;
}

bool yk_law_add_piece(YkLawBuilder *builder, const YkPiece *frame, const double *numbers)
{
    size_t count = frame->terms + 3u * frame->waves, first = builder->number_count;
    for (size_t i = 0; i < count; i++) {
        if (!YK_ROOM(builder->numbers, builder->number_count, builder->number_capacity)) return false;
        builder->numbers[builder->number_count++] = numbers[i];
    }
    if (!YK_ROOM(builder->pieces, builder->piece_count, builder->piece_capacity)) return false;
    YkPiece *piece = &builder->pieces[builder->piece_count++];
    *piece = *frame;
    piece->first = first;
    return true;
}

void yk_law_take_back(YkLawBuilder *builder, size_t first, size_t conditions)
{
    if (first < builder->piece_count) builder->number_count = builder->pieces[first].first;
    builder->piece_count = first;
    builder->condition_count -= conditions;
}

// Returns whether every piece from `first` on is finite at its ends, with all derivatives.
static bool are_finite(const YkLawBuilder *builder, size_t first)
{
    for (size_t i = first; i < builder->piece_count; i++) {
        const YkPiece *piece = &builder->pieces[i];
        double a[YK_LAW_ORDER + 1], b[YK_LAW_ORDER + 1];
        yk_piece_eval(piece, builder->numbers, piece->from, a);
        yk_piece_eval(piece, builder->numbers, piece->to, b);
        for (int m = 0; m <= YK_LAW_ORDER; m++) {
            if (!isfinite(a[m]) || !isfinite(b[m])) return false;
        }
    }
    return true;
}

YkLawFault yk_law_end_segment(YkLawBuilder *builder, YkLawKind kind, size_t first, size_t conditions,
                              double condition_number)
{
    bool is_finite = are_finite(builder, first);
    if (!is_finite || !YK_ROOM(builder->segments, builder->segment_count, builder->segment_capacity)) {
        yk_law_take_back(builder, first, conditions);
        return is_finite ? YK_LAW_NO_MEMORY : YK_LAW_NOT_FINITE;
    }
    const YkPiece *last = &builder->pieces[builder->piece_count - 1];
    double d[YK_LAW_ORDER + 1];
    yk_piece_eval(last, builder->numbers, last->to, d);
    builder->segments[builder->segment_count++] = (YkLawSegment){.kind = kind,
                                                                 .from = builder->pieces[first].from,
                                                                 .to = last->to,
                                                                 .first_piece = first,
                                                                 .piece_count = builder->piece_count - first,
                                                                 .condition_count = conditions,
                                                                 .condition_number = condition_number};
    builder->at = last->to;
    builder->value = d[0];
    return YK_LAW_OK;
}

// Adds a straight line from the builder's present end.
static YkLawFault add_line(YkLawBuilder *builder, double to, double v, YkLawKind kind)
{
    double line[2] = {builder->value, v};
    size_t first = builder->piece_count;
    YkPiece frame = {.from = builder->at, .to = to, .middle = builder->at, .scale = 1, .terms = v == 0 ? 1 : 2};
    if (!(to > builder->at)) return YK_LAW_BACKWARD;
    if (yk_law_add_piece(builder, &frame, line)) return yk_law_end_segment(builder, kind, first, 0, 1);
    yk_law_take_back(builder, first, 0);
    return YK_LAW_NO_MEMORY;
}

YkLawFault yk_law_add_dwell(YkLawBuilder *builder, double to)
{
    return add_line(builder, to, 0, YK_LAW_DWELL);
}

YkLawFault yk_law_add_velocity(YkLawBuilder *builder, double to, double v)
{
    return add_line(builder, to, v, YK_LAW_CONSTANT_VELOCITY);
}

static void *copy(YkArena *arena, const void *items, size_t count, size_t size)
{
    void *memory = yk_arena_alloc(arena, count, size);
    if (memory && count > 0) memcpy(memory, items, count * size);
    return memory;
}

// Copies the segments with their conditions, which the builder stores separately while they still move.
static const YkLawSegment *copy_segments(const YkLawBuilder *builder, YkArena *arena)
{
    size_t count = builder->segment_count;
    YkLawSegment *segments = copy(arena, builder->segments, count, sizeof *segments);
    const YkLawCondition *conditions = copy(arena, builder->conditions, builder->condition_count, sizeof *conditions);
    if (!segments || !conditions) return NULL;
    for (size_t i = 0; i < count; i++) {
        segments[i].conditions = segments[i].condition_count > 0 ? conditions : NULL;
        conditions += segments[i].condition_count;
    }
    return segments;
}

static void set_end_values(YkLaw *law)
{
    double d[YK_LAW_ORDER + 1];
    yk_piece_eval(&law->pieces[0], law->numbers, law->from, d);
    law->start = d[0];
    yk_piece_eval(&law->pieces[law->piece_count - 1], law->numbers, law->to, d);
    law->end = d[0];
}

YkLawFault yk_law_finish(YkLawBuilder *builder, double period, YkArena *arena, YkLaw **result)
{
    *result = NULL;
    if (builder->piece_count == 0) return YK_LAW_EMPTY;
    double from = builder->pieces[0].from, left = from + period - builder->at;
    if (period > 0 && left > SAME * period) return YK_LAW_NOT_FILLED;
    if (period > 0 && left < -SAME * period) return YK_LAW_OVERFILLED;
    YkLaw *law = YK_NEW(arena, YkLaw, 1);
    if (!law) return YK_LAW_NO_MEMORY;
    *law = (YkLaw){.from = from,
                   .to = builder->at,
                   .period = period > 0 ? period : 0,
                   .pieces = copy(arena, builder->pieces, builder->piece_count, sizeof *builder->pieces),
                   .piece_count = builder->piece_count,
                   .numbers = copy(arena, builder->numbers, builder->number_count, sizeof *builder->numbers),
                   .segments = copy_segments(builder, arena),
                   .segment_count = builder->segment_count};
    if (!law->pieces || !law->numbers || !law->segments) return YK_LAW_NO_MEMORY;
    set_end_values(law);
    *result = law;
    return YK_LAW_OK;
}
