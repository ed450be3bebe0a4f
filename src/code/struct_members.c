// The members of the inputs and the configuration of the printed program, with their values at the start.
#include <string.h>
#include "code/file.h"

static void add(YkLeafNote *notes, size_t *count, const char *name, const char *comment, double value, size_t of)
{
    notes[(*count)++] = (YkLeafNote){.name = name, .comment = comment, .value = value, .count = of};
}

static void add_inputs(YkFile *file)
{
    static const char *const units[2][3] = {{"rad", "rad/s", "rad/s^2"}, {"m", "m/s", "m/s^2"}};
    YkProgram *p = &file->program;
    add(file->inputs, &file->input_count, "t", "s: time, for drives and loads", yk_state_time(file->state), 0);
    for (size_t i = 0; i < p->mech->input_count; i++) {
        const YkTreeCoordinate *c = &p->mech->coordinates[p->mech->inputs[i]];
        const char *name = p->names.coordinate[p->mech->inputs[i]];
        YkMotion m = yk_state_input(file->state, i);
        const char *const *unit = units[c->is_distance];
        add(file->inputs, &file->input_count, name, unit[0], m.position, 0);
        add(file->inputs, &file->input_count, yk_graph_text(&p->graph, "%s_rate", name), unit[1], m.velocity, 0);
        add(file->inputs, &file->input_count, yk_graph_text(&p->graph, "%s_accel", name), unit[2], m.acceleration, 0);
        if (!file->has_forces || c->drive != YK_NONE) continue;
        add(file->inputs, &file->input_count, yk_graph_text(&p->graph, "%s_effort", name),
            c->is_distance ? "N, besides the loads: of a motor, say" : "N m, besides the loads: of a motor, say", 0, 0);
        file->inputs[file->input_count - 1].is_effort = true;
    }
}

static void add_branches(YkFile *file)
{
    YkProgram *p = &file->program;
    for (size_t b = 0; b < p->mech->block_count; b++) {
        const YkBlock *block = &p->mech->blocks[b];
        const char *name = p->names.block[b];
        if (block->kind > YK_BLOCK_RPR && block->kind != YK_BLOCK_GROUP) continue;
        add(file->configuration, &file->configuration_count, name,
            yk_graph_text(&p->graph, "branch of %s: +1 or -1", block->label), yk_state_branch(file->state, b), 0);
        if (block->kind != YK_BLOCK_GROUP) continue;
        add(file->configuration, &file->configuration_count, yk_graph_text(&p->graph, "%s_guess", name),
            "where Newton's method begins: rad, m", (double)block->first_column, block->column_count);
    }
}

static void add_references(YkFile *file)
{
    YkProgram *p = &file->program;
    for (size_t k = 0; k < p->mech->coordinate_count; k++) {
        const YkTreeCoordinate *c = &p->mech->coordinates[k];
        if (c->is_distance || c->input != YK_NONE) continue;
        add(file->configuration, &file->configuration_count, p->names.near_coordinate[k],
            "rad: of the angles that differ by turns, the nearest to this",
            yk_state_coordinate(file->state, k).position, 0);
    }
    for (size_t k = 0; k < p->mech->source_count; k++) {
        const YkRelationSource *s = &p->mech->sources[k];
        if (s->kind != YK_SOURCE_SLOT) continue;
        const char *name = p->names.near_slot[s->index];
        bool is_there = false;
        for (size_t i = 0; i < file->configuration_count; i++)
            if (strcmp(file->configuration[i].name, name) == 0) is_there = true;
        if (!is_there)
            add(file->configuration, &file->configuration_count, name, "rad: a wheel's angle comes out nearest to this",
                file->state->slot_reference[s->reference], 0);
    }
}

bool yk_file_members(YkFile *file)
{
    const YkMechanism *mech = file->program.mech;
    YkArena *arena = file->program.arena;
    file->inputs = YK_NEW(arena, YkLeafNote, 4 * mech->input_count + 1);
    file->configuration =
        YK_NEW(arena, YkLeafNote, 2 * mech->block_count + mech->coordinate_count + mech->source_count + 1);
    if (yk_arena_failed(arena)) return false;
    add_inputs(file);
    add_branches(file);
    add_references(file);
    return !file->program.failed;
}
