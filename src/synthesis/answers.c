// Answers questions about a synthesis.
#include <math.h>
#include "elementary/elementary.h"
#include "synthesis/paths/path_bar.h"
#include "synthesis/synthesis.h"

bool yk_synthesis_was_stopped(const YkSynthesis *s)
{
    return s && s->was_stopped;
}

bool yk_synthesis_is_complete(const YkSynthesis *s)
{
    return s && s->is_complete;
}

bool yk_synthesis_solutions(const YkSynthesis *s, size_t *complex_count, size_t *real_count)
{
    if (!s || !s->has_solutions) return false;
    if (complex_count) *complex_count = s->complex_count;
    if (real_count) *real_count = s->real_count;
    return true;
}

size_t yk_synthesis_dyad_count(const YkSynthesis *s)
{
    return s ? s->dyad_count : 0;
}

YkDyad yk_synthesis_dyad(const YkSynthesis *s, size_t index)
{
    return s && index < s->dyad_count ? s->dyads[index] : (YkDyad){.length = NAN};
}

YkCandidate yk_found_candidate(const YkFound *found)
{
    const YkDesign *design = &found->design;
    YkCandidate c = {.file = found->file, .model = found->model, .defect = found->defect};
    if (found->value) {
        c.mechanism = c.type = "machine";
        c.error = found->error;
        c.worst = found->worst;
        c.dyads[0] = c.dyads[1] = -1;
        c.offset = NAN;
        return c;
    }
    c.mechanism = yk_design_kind_name(design->kind);
    c.type = yk_design_type(design);
    c.error = found->error;
    c.worst = found->worst;
    c.circuits = yk_design_has_circuits(design) ? 2 : 1;
    for (size_t i = 0; i < 2; i++) {
        c.transmission[i] = found->transmission[i];
        c.pivots[i][0] = design->pivot[i].x;
        c.pivots[i][1] = design->pivot[i].y;
        c.dyads[i] = design->dyad[i];
    }
    YkVec line = yk_vec(yk_cos(design->along), yk_sin(design->along));
    c.offset = design->kind == YK_DESIGN_SLIDER_CRANK ? yk_cross(line, yk_sub(design->pivot[1], design->pivot[0]))
               : design->kind == YK_DESIGN_INVERTED   ? design->length[3]
                                                      : NAN;
    for (size_t i = 0; i < 4; i++) {
        c.lengths[i] = i == 3 && design->kind == YK_DESIGN_INVERTED ? 0 : design->length[i];
        c.size = fmax(c.size, design->length[i]);
    }
    for (size_t i = 0; i < 2; i++) c.size = fmax(c.size, design->dyad_length[i]);
    c.point[0] = design->point.x;
    c.point[1] = design->point.y;
    return c;
}

size_t yk_synthesis_count(const YkSynthesis *s)
{
    return s ? s->candidates.count : 0;
}

YkCandidate yk_synthesis_candidate(const YkSynthesis *s, size_t index)
{
    return index < yk_synthesis_count(s) ? yk_found_candidate(&s->candidates.items[index])
                                         : (YkCandidate){.file = NULL};
}

size_t yk_synthesis_left_out(const YkSynthesis *s, YkDefect reason)
{
    return s && (size_t)reason < YK_DEFECT_COUNT ? s->left_out[reason] : 0;
}

size_t yk_synthesis_defect_count(const YkSynthesis *s)
{
    return s ? s->defects.count : 0;
}

YkCandidate yk_synthesis_defect(const YkSynthesis *s, size_t index)
{
    return index < yk_synthesis_defect_count(s) ? yk_found_candidate(&s->defects.items[index])
                                                : (YkCandidate){.file = NULL};
}

const char *yk_synthesis_parameter(const YkSynthesis *s, size_t candidate, size_t index, double *value)
{
    if (candidate >= yk_synthesis_count(s)) return NULL;
    const YkMachineTask *machine = &s->task->machine;
    if (s->task->kind == YK_TASK_MACHINE) {
        if (index >= machine->free_count) return NULL;
        if (value) *value = s->candidates.items[candidate].value[index];
        return machine->name[index];
    }
    const YkDesign *d = &s->candidates.items[candidate].design;
    bool has_dyad = yk_bar_size(d->kind) > YK_BAR_PLAIN, has_places = has_dyad && d->kind != YK_DESIGN_GEARED;
    const struct {
        const char *name;
        double value;
        bool is_there;
    } all[YK_PARAMETERS_MAX] = {{"x1", d->pivot[0].x, true},
                                {"y1", d->pivot[0].y, true},
                                {"x2", d->pivot[1].x, true},
                                {"y2", d->pivot[1].y, true},
                                {"a", d->length[1], true},
                                {"b", d->length[2], yk_bar_is_length(d->kind, YK_BAR_COUPLER)},
                                {"c", d->length[3], yk_bar_is_length(d->kind, YK_BAR_OUTPUT)},
                                {"e", d->length[3], d->kind == YK_DESIGN_INVERTED},
                                {"px", d->point.x, d->has_point},
                                {"py", d->point.y, d->has_point},
                                {"cx", d->end[0].x, has_places},
                                {"cy", d->end[0].y, has_places},
                                {"dx", d->end[1].x, has_places},
                                {"dy", d->end[1].y, has_places},
                                {"l", d->dyad_length[0], has_dyad},
                                {"m", d->dyad_length[1], has_dyad}};
    for (size_t k = 0; k < YK_PARAMETERS_MAX; k++) {
        if (!all[k].is_there || index-- > 0) continue;
        if (value) *value = all[k].value;
        return all[k].name;
    }
    return NULL;
}

const double *yk_synthesis_angles(const YkSynthesis *s, size_t candidate, size_t *count)
{
    const double *angle = candidate < yk_synthesis_count(s) ? s->candidates.items[candidate].angle : NULL;
    if (count) *count = angle ? s->task->path.count : 0;
    return angle;
}

double yk_synthesis_interpolating(const YkSynthesis *s, size_t candidate)
{
    return candidate < yk_synthesis_count(s) ? s->candidates.items[candidate].interpolating : NAN;
}

bool yk_synthesis_is_reversed(const YkSynthesis *s, size_t candidate, bool output)
{
    if (candidate >= yk_synthesis_count(s) || s->task->kind != YK_TASK_FUNCTION) return false;
    if (output && s->candidates.items[candidate].design.kind == YK_DESIGN_SLIDER_CRANK) return false;
    const YkGiven *phase = &s->task->function.phase[output];
    double begins = s->candidates.items[candidate].design.angle[output ? 2 : 0];
    return phase->is_given && yk_cos(begins - phase->value) < 0;
}

size_t yk_synthesis_curve(const YkSynthesis *s, size_t candidate, const double **xy)
{
    if (candidate >= yk_synthesis_count(s)) return 0;
    if (xy) *xy = s->candidates.items[candidate].curve;
    return s->candidates.items[candidate].rows;
}
