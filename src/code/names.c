// Chooses the printed file's names for the things of the model: unique among the members of a struct, and functions.
#include "code/file.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

typedef struct Scope { // members of one struct, or functions of one kind
    YkProgram *program;
    YkNames taken;
    const char *const *endings; // each name is also used with each of these endings
    size_t ending_count;
} Scope;

static void take(Scope *scope, const char *name)
{
    int32_t existing;
    if (!yk_names_add(&scope->taken, name, 0, &existing)) scope->program->failed = scope->program->graph.failed = true;
}

static bool is_free(Scope *scope, const char *name)
{
    for (size_t k = 0; k < scope->ending_count; k++) {
        const char *member = yk_graph_text(&scope->program->graph, "%s%s", name, scope->endings[k]);
        if (yk_file_is_reserved(scope->program, member) || yk_names_find(&scope->taken, member) != YK_NONE)
            return false;
    }
    return true;
}

// Returns the first of NAME, NAME_2, NAME_3, ... with all forms free.
static const char *choose(Scope *scope, const char *wish)
{
    const char *name = wish;
    for (int k = 2; !scope->program->graph.failed && !is_free(scope, name); k++)
        name = yk_file_name(scope->program, yk_graph_text(&scope->program->graph, "%s_%d", wish, k));
    for (size_t k = 0; k < scope->ending_count; k++)
        take(scope, yk_graph_text(&scope->program->graph, "%s%s", name, scope->endings[k]));
    return name;
}

static Scope open_scope(YkProgram *p, const char *const *endings, size_t count)
{
    return (Scope){.program = p, .endings = endings, .ending_count = count};
}

static void close_scope(Scope *scope)
{
    yk_names_free(&scope->taken);
}

// --- each kind

static const char *const alone[] = {""};

static void name_parameters(YkProgram *p)
{
    Scope scope = open_scope(p, alone, COUNT(alone));
    for (size_t k = 0; k < p->model->parameter_count; k++)
        p->names.parameter[k] = choose(&scope, yk_file_name(p, p->model->parameters[k].name));
    close_scope(&scope);
}

static void name_coordinates(YkProgram *p)
{
    static const char *const endings[] = {"", "_rate", "_accel", "_effort"};
    Scope scope = open_scope(p, endings, COUNT(endings));
    take(&scope, "t");
    for (size_t k = 0; k < p->mech->coordinate_count; k++)
        p->names.coordinate[k] = choose(&scope, yk_file_name(p, p->mech->coordinates[k].name));
    close_scope(&scope);
}

// Names blocks first, by their joints' names, then the angles that others come out nearest to.
static void name_configuration(YkProgram *p)
{
    static const char *const endings[] = {"", "_guess"};
    Scope scope = open_scope(p, endings, COUNT(endings));
    for (size_t b = 0; b < p->mech->block_count; b++)
        p->names.block[b] = choose(&scope, yk_file_name(p, p->mech->blocks[b].label));
    scope.endings = alone;
    scope.ending_count = COUNT(alone);
    for (size_t k = 0; k < p->mech->coordinate_count; k++) {
        const YkTreeCoordinate *c = &p->mech->coordinates[k];
        if (!c->is_distance && c->input == YK_NONE)
            p->names.near_coordinate[k] = choose(&scope, yk_graph_text(&p->graph, "near_%s", p->names.coordinate[k]));
    }
    for (size_t k = 0; k < p->mech->source_count; k++) {
        const YkRelationSource *s = &p->mech->sources[k];
        if (s->kind == YK_SOURCE_SLOT && !p->names.near_slot[s->index])
            p->names.near_slot[s->index] =
                choose(&scope, yk_file_name(p, yk_graph_text(&p->graph, "near_%s", yk_program_slot_name(p, s->index))));
    }
    close_scope(&scope);
}

static void name_points(YkProgram *p)
{
    static const char *const endings[] = {"_x", "_y", "_x_rate", "_y_rate", "_x_accel", "_y_accel"};
    Scope scope = open_scope(p, endings, COUNT(endings));
    for (size_t k = 0; k < p->model->point_count; k++) {
        const YkPoint *point = &p->model->points[k];
        if (point->body == 0) continue;
        const char *both = yk_graph_text(&p->graph, "%s_%s", p->model->bodies[point->body].name, point->name);
        p->names.point[k] = choose(&scope, yk_file_name(p, both));
    }
    close_scope(&scope);
}

static void name_joints(YkProgram *p)
{
    static const char *const endings[] = {"_force_x", "_force_y", "_moment"};
    Scope scope = open_scope(p, endings, COUNT(endings));
    for (size_t k = 0; k < p->model->joint_count; k++)
        p->names.joint[k] = choose(&scope, yk_file_name(p, p->model->joints[k].name));
    for (size_t k = 0; k < p->mech->relation_count; k++)
        p->names.contact[k] = choose(&scope, yk_file_name(p, p->mech->relations[k].name));
    close_scope(&scope);
}

static void name_laws(YkProgram *p)
{
    Scope scope = open_scope(p, alone, COUNT(alone));
    for (size_t k = 0; k < p->model->law_count; k++)
        p->names.law[k] = choose(&scope, yk_file_name(p, p->model->laws[k].name));
    close_scope(&scope);
}

void yk_program_name_fields(YkProgram *p, YkPrinter *pr)
{
    Scope scope = open_scope(p, alone, COUNT(alone));
    take(&scope, "p");
    for (size_t k = 0; k < pr->field_count; k++) {
        const char *wish = p->graph.values[pr->fields[k]].name;
        wish = wish ? yk_file_name(p, wish) : yk_graph_text(&p->graph, "k%d", (int)k + 1);
        pr->field[pr->fields[k]] = choose(&scope, wish);
    }
    close_scope(&scope);
}

bool yk_file_choose_names(YkProgram *p)
{
    YkCNames *n = &p->names;
    n->parameter = YK_NEW(p->arena, const char *, p->model->parameter_count + 1);
    n->coordinate = YK_NEW(p->arena, const char *, p->mech->coordinate_count + 1);
    n->near_coordinate = YK_NEW(p->arena, const char *, p->mech->coordinate_count + 1);
    n->near_slot = YK_NEW(p->arena, const char *, p->mech->slot_count + 1);
    n->block = YK_NEW(p->arena, const char *, p->mech->block_count + 1);
    n->point = YK_NEW(p->arena, const char *, p->model->point_count + 1);
    n->joint = YK_NEW(p->arena, const char *, p->model->joint_count + 1);
    n->contact = YK_NEW(p->arena, const char *, p->mech->relation_count + 1);
    n->law = YK_NEW(p->arena, const char *, p->model->law_count + 1);
    if (yk_arena_failed(p->arena)) return false;
    name_parameters(p);
    name_coordinates(p);
    name_configuration(p);
    name_points(p);
    name_joints(p);
    name_laws(p);
    return !p->failed && !p->graph.failed;
}
