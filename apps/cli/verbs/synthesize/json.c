// `yoke synthesize` for programs.
#include <math.h>
#include <string.h>
#include "verbs/synthesize/synthesize.h"
#include "write/json.h"

static void add_dyad(YkJson *json, YkDyad dyad)
{
    static const char *const kinds[] = {"RR", "PR", "RP"};
    yk_json_object(json, NULL, YK_JSON_INLINE);
    yk_json_string(json, "kind", kinds[dyad.kind]);
    yk_json_numbers(json, "fixed", dyad.fixed, 2);
    yk_json_numbers(json, "moving", dyad.moving, 2);
    if (dyad.kind == YK_DYAD_RR)
        yk_json_number(json, "length", dyad.length);
    else
        yk_json_number(json, "direction", dyad.direction);
    yk_json_end(json);
}

static void add_dimensions(YkJson *json, const YkCandidate *c)
{
    static const char *const names[] = {"ground", "input", "coupler", "output"};
    bool is_slider = strcmp(c->mechanism, "slider-crank") == 0;
    yk_json_list(json, "pivots", YK_JSON_INLINE);
    yk_json_numbers(json, NULL, c->pivots[0], 2);
    if (!is_slider) yk_json_numbers(json, NULL, c->pivots[1], 2);
    yk_json_end(json);
    yk_json_object(json, "lengths", YK_JSON_INLINE);
    for (size_t k = 0; k < 4; k++) // of those that the machine has
        if (c->lengths[k] > 0) yk_json_number(json, names[k], c->lengths[k]);
    if (is_slider) yk_json_number(json, "offset", c->offset);
    yk_json_end(json);
    yk_json_numbers(json, "point", c->point, 2);
    if (c->dyads[0] < 0) return;
    yk_json_list(json, "dyads", YK_JSON_INLINE);
    for (size_t k = 0; k < 2; k++) yk_json_integer(json, NULL, c->dyads[k]);
    yk_json_end(json);
}

void yk_synthesis_json_machine(YkJson *json, const YkCandidate *c)
{
    yk_json_string(json, "model", c->model);
    yk_json_string(json, "mechanism", c->mechanism);
    yk_json_string(json, "type", c->type);
    yk_json_number(json, "error", c->error);
    yk_json_number(json, "worst", c->worst);
    yk_json_numbers(json, "transmission", c->transmission, 2);
    add_dimensions(json, c);
}

static void add_candidate(YkJson *json, const YkSynthesis *synthesis, size_t index)
{
    YkCandidate c = yk_synthesis_candidate(synthesis, index);
    const char *name;
    double value = 0;
    size_t count;
    yk_json_object(json, NULL, YK_JSON_LINES);
    yk_json_integer(json, "rank", (long long)index + 1);
    yk_json_string(json, "file", c.file);
    yk_json_string(json, "model", c.model);
    yk_json_string(json, "mechanism", c.mechanism);
    yk_json_number(json, "error", c.error);
    yk_json_number(json, "worst", c.worst);
    double interpolating = yk_synthesis_interpolating(synthesis, index);
    if (!isnan(interpolating)) yk_json_number(json, "interpolating", interpolating);
    bool is_reversed[] = {yk_synthesis_is_reversed(synthesis, index, false),
                          yk_synthesis_is_reversed(synthesis, index, true)};
    if (is_reversed[0] || is_reversed[1]) {
        yk_json_list(json, "reversed", YK_JSON_INLINE);
        if (is_reversed[0]) yk_json_string(json, NULL, "input");
        if (is_reversed[1]) yk_json_string(json, NULL, "output");
        yk_json_end(json);
    }
    bool has_dimensions = c.circuits > 0; // an existing machine has parameters alone
    if (has_dimensions) {
        yk_json_numbers(json, "transmission", c.transmission, 2);
        yk_json_number(json, "size", c.size);
        yk_json_integer(json, "circuits", (long long)c.circuits);
    }
    yk_json_string(json, "type", c.type);
    yk_json_object(json, "parameters", YK_JSON_INLINE);
    for (size_t k = 0; (name = yk_synthesis_parameter(synthesis, index, k, &value)) != NULL; k++)
        yk_json_number(json, name, value);
    yk_json_end(json);
    if (has_dimensions) add_dimensions(json, &c);
    const double *angle = yk_synthesis_angles(synthesis, index, &count);
    if (angle) yk_json_list(json, "angles", YK_JSON_INLINE);
    for (size_t k = 0; k < count; k++) yk_json_number(json, NULL, angle[k]);
    if (angle) yk_json_end(json);
    yk_json_end(json);
}

static void add_defects(YkJson *json, const YkSynthesis *synthesis)
{
    yk_json_list(json, "defects", YK_JSON_LINES);
    for (size_t k = 0; k < yk_synthesis_defect_count(synthesis); k++) {
        YkCandidate c = yk_synthesis_defect(synthesis, k);
        yk_json_object(json, NULL, YK_JSON_LINES);
        yk_json_string(json, "defect", yk_defect_name(c.defect));
        yk_json_string(json, "mechanism", c.mechanism);
        yk_json_string(json, "type", c.type);
        add_dimensions(json, &c);
        yk_json_end(json);
    }
    yk_json_end(json);
}

void yk_synthesis_json(const YkSynthesisAnswer *answer, YkText *text)
{
    const YkSynthesis *synthesis = answer->synthesis;
    YkJson json = {.text = text};
    size_t complex_count, real_count;
    yk_json_object(&json, NULL, YK_JSON_LINES);
    yk_json_string(&json, "task", yk_task_name(answer->task));
    yk_json_string(&json, "synthesis", yk_task_kind(answer->task));
    yk_json_string(&json, "status", yk_synthesis_word(answer));
    yk_json_bool(&json, "complete", yk_synthesis_is_complete(synthesis));
    yk_json_bool(&json, "reproducible", !yk_synthesis_was_stopped(synthesis));
    if (yk_synthesis_solutions(synthesis, &complex_count, &real_count)) {
        yk_json_object(&json, "solutions", YK_JSON_INLINE);
        yk_json_integer(&json, "complex", (long long)complex_count);
        yk_json_integer(&json, "real", (long long)real_count);
        yk_json_end(&json);
    }
    yk_json_object(&json, "left_out", YK_JSON_INLINE);
    for (int k = 1; k < YK_DEFECT_COUNT; k++) {
        size_t count = yk_synthesis_left_out(synthesis, (YkDefect)k);
        if (count > 0) yk_json_integer(&json, yk_defect_name((YkDefect)k), (long long)count);
    }
    yk_json_end(&json);
    yk_json_integer(&json, "seed", (long long)answer->seed);
    yk_json_list(&json, "dyads", YK_JSON_LINES);
    for (size_t k = 0; k < yk_synthesis_dyad_count(synthesis); k++) add_dyad(&json, yk_synthesis_dyad(synthesis, k));
    yk_json_end(&json);
    yk_json_list(&json, "candidates", YK_JSON_LINES);
    for (size_t k = 0; k < yk_synthesis_count(synthesis); k++) add_candidate(&json, synthesis, k);
    yk_json_end(&json);
    if (answer->session->request->defects) add_defects(&json, synthesis);
    yk_json_end(&json);
}

const char *yk_synthesis_word(const YkSynthesisAnswer *answer)
{
    if (answer->is_late) return "time";
    if (yk_synthesis_was_stopped(answer->synthesis)) return "interrupted";
    return yk_synthesis_count(answer->synthesis) > 0 ? "ok" : "none";
}
