// Blocks of a study: designs by their numbers, and their rows.
#include <math.h>
#include <yoke/blocks.h>
#include "study/study.h"

enum { REDUCTIONS = 4 }; // least, largest, mean, range

void yk_designs_at(const YkDesigns *designs, uint64_t design, double *values)
{
    uint64_t rest = design;
    if (!designs || !values) return;
    for (size_t k = designs->axis_count; k-- > 0;) { // the last axis varies fastest
        const YkDesignAxis *axis = &designs->axes[k];
        if (designs->is_sample) {
            values[k] = yk_distribution_draw(&axis->distribution, designs->seed, design, k);
        } else {
            size_t at = axis->count > 0 ? (size_t)(rest % axis->count) : 0,
                   last = axis->count > 0 ? axis->count - 1 : 0;
            rest = axis->count > 0 ? rest / axis->count : rest;
            values[k] = at == 0      ? axis->from
                        : at == last ? axis->to
                                     : axis->from + (axis->to - axis->from) * (double)at / (double)last;
        }
    }
}

size_t yk_study_row_width(const YkStudy *study, const YkRowCase *asked)
{
    if (!study || !asked) return 0;
    return study->parameter_count + 2 + study->channel_count * (asked->is_reduced ? REDUCTIONS : 1);
}

typedef struct Room { // for one call of the study
    YkArena *arena;
    double *values; // [axis][design], then [channel][design]
    double *own;    // [axis]
    const double **rows;
    double **outputs;
    YkExtent *extents;
    signed char *status;
    size_t *standing;
} Room;

static bool start_room(const YkStudy *study, Room *room, size_t count)
{
    size_t axes = study->parameter_count, channels = study->channel_count;
    YkArena *a = yk_arena_new();
    *room = (Room){.arena = a,
                   .values = YK_NEW(a, double, (axes + channels) * count),
                   .own = YK_NEW(a, double, axes),
                   .rows = YK_NEW(a, const double *, axes),
                   .outputs = YK_NEW(a, double *, channels),
                   .extents = YK_NEW(a, YkExtent, channels * count),
                   .status = YK_NEW(a, signed char, count),
                   .standing = YK_NEW(a, size_t, count)};
    if (yk_arena_failed(a)) return false;
    for (size_t k = 0; k < axes; k++) room->rows[k] = room->values + k * count;
    for (size_t c = 0; c < channels; c++) room->outputs[c] = room->values + (axes + c) * count;
    return true;
}

// Fills in status, number of valid poses and answers of the k-th design of a block.
static void fill_row(const YkStudy *study, const YkRowCase *asked, const Room *room, size_t k, size_t count,
                     double *row)
{
    YkStatus status = (YkStatus)room->status[k];
    size_t first = study->parameter_count + 2, standing = asked->is_reduced ? room->standing[k] : status >= 0;
    row[first - 2] = status;
    row[first - 1] = (double)standing;
    for (size_t c = 0; c < study->channel_count; c++) {
        bool stands = standing > 0 && (asked->is_reduced || yk_study_counts(study->channels[c], status));
        YkExtent e = room->extents[c * count + k];
        const double value[REDUCTIONS] = {e.least, e.largest, e.mean, e.largest - e.least};
        if (!asked->is_reduced) row[first + c] = stands ? room->outputs[c][k] : NAN;
        for (size_t r = 0; asked->is_reduced && r < REDUCTIONS; r++)
            row[first + c * REDUCTIONS + r] = stands ? value[r] : NAN;
    }
}

static YkStatus run(YkStudy *study, const YkRowCase *asked, const Room *room, uint64_t from, size_t count, double *rows)
{
    size_t width = yk_study_row_width(study, asked);
    for (size_t k = 0; k < count; k++) {
        yk_designs_at(asked->designs, from + k, room->own);
        for (size_t p = 0; p < study->parameter_count; p++)
            rows[k * width + p] = room->values[p * count + k] = room->own[p];
    }
    YkStudyCase block = {room->rows, count, asked->inputs, asked->pose_count, false, asked->times};
    YkStatus worst = asked->is_reduced ? yk_study_reduce(study, &block, room->extents, room->status, room->standing)
                                       : yk_study_run(study, &block, room->outputs, room->status);
    if (worst == YK_STOPPED || worst == YK_BAD_ARGUMENT) return worst;
    for (size_t k = 0; k < count; k++) {
        if (room->status[k] == YK_NO_MEMORY) return YK_NO_MEMORY;
        fill_row(study, asked, room, k, count, rows + k * width);
    }
    return YK_OK;
}

YkStatus yk_study_rows(YkStudy *study, const YkRowCase *asked, uint64_t from, size_t count, double *rows)
{
    Room room;
    if (!study || !asked || !asked->designs || !rows || asked->designs->axis_count != study->parameter_count)
        return YK_BAD_ARGUMENT;
    if (!asked->is_reduced && asked->pose_count != 1) return YK_BAD_ARGUMENT;
    YkStatus status = start_room(study, &room, count) ? run(study, asked, &room, from, count, rows) : YK_NO_MEMORY;
    yk_arena_free(room.arena);
    return status;
}
