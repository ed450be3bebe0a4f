// `yoke check` for a first-course reader: counts with their sum, loops by name, the order of solution.
#include "verbs/check/check.h"
#include "verbs/solve/solve.h"
#include "write/table.h"

enum { LIST_MAX = 400 }; // lines of a list; a machine with thousands of links is described by its counts

static const char *plural(size_t count)
{
    return count == 1 ? "" : "s";
}

static void write_table(YkText *out, const char *title, YkTable *table, size_t rows, size_t all)
{
    if (rows > 0) {
        yk_text_format(out, "\n%s\n", title);
        yk_table_write(table, 2, out);
        if (all > rows) yk_text_format(out, "  ... and %z more\n", all - rows);
    }
    yk_table_free(table);
}

static size_t at_most(size_t count)
{
    return count < LIST_MAX ? count : LIST_MAX;
}

static const char *body(const YkCheckAnswer *answer, size_t index)
{
    return yk_model_body_name(answer->session->model, index);
}
static const char *joint(const YkCheckAnswer *answer, size_t index)
{
    return yk_model_joint_name(answer->session->model, index);
}

static void add_head(const YkCheckAnswer *answer)
{
    const YkModel *model = answer->session->model;
    size_t bodies = yk_model_body_count(model), joints = yk_model_joint_count(model),
           loops = yk_loop_count(answer->session->mech);
    yk_text_format(&answer->session->out, "%s\n  %z bodies (the ground and %z that move), %z joint%s, %z loop%s\n",
                   yk_model_name(model), bodies, bodies - 1, joints, plural(joints), loops, plural(loops));
}

static void add_joints(const YkCheckAnswer *answer)
{
    const YkModel *model = answer->session->model;
    size_t all = yk_model_joint_count(model), count = at_most(all);
    YkTable *table = yk_table_new(4);
    static const char *const heads[] = {"joint", "kind", "first body", "second body"};
    for (size_t i = 0; i < 4; i++) yk_table_head(table, heads[i], NULL);
    for (size_t j = 0; j < count; j++) {
        yk_table_word(table, joint(answer, j));
        yk_table_word(table, yk_model_joint_kind(model, j));
        yk_table_word(table, body(answer, yk_model_joint_body(model, j, 0)));
        yk_table_word(table, body(answer, yk_model_joint_body(model, j, 1)));
    }
    write_table(&answer->session->out, "Joints", table, count, all);
}

static const char *role(YkCoordinateInfo info)
{
    if (info.input >= 0)
        return info.is_held ? "held by the lock" : info.has_drive ? "driven" : "held: an input without a drive";
    return info.is_declared ? "follows" : "follows (named by yoke)";
}

static void add_coordinates(const YkCheckAnswer *answer)
{
    const YkMechanism *mech = answer->session->mech;
    size_t all = yk_coordinate_count(mech), count = at_most(all);
    YkTable *table = yk_table_new(4);
    static const char *const heads[] = {"coordinate", "is", "at joint", ""};
    for (size_t i = 0; i < 4; i++) yk_table_head(table, heads[i], NULL);
    for (size_t i = 0; i < count; i++) {
        YkCoordinateInfo info = yk_coordinate_info(mech, i);
        yk_table_word(table, info.name);
        yk_table_word(table, info.is_distance ? "a distance" : "an angle");
        yk_table_word(table, joint(answer, info.joint));
        yk_table_word(table, role(info));
    }
    write_table(&answer->session->out, "Coordinates (second body relative to first)", table, count, all);
}

static void add_freedom(const YkCheckAnswer *answer)
{
    YkText *out = &answer->session->out;
    YkFreedom freedom = yk_mechanism_freedom(answer->session->mech);
    int moving = (int)yk_model_body_count(answer->session->model) - 1;
    yk_text_puts(out, "\nDegrees of freedom\n");
    yk_text_format(out, "  Gruebler: 3 x %d moving bodies - %d constraints = %d\n", moving,
                   3 * moving - freedom.gruebler, freedom.gruebler);
    if (freedom.by_rank >= 0) {
        yk_text_format(out, "  by the rank of the loop equations: %d\n", freedom.by_rank);
    } else {
        yk_text_puts(out,
                     "  by the rank of the loop equations: not known, since the machine could not be put together\n");
    }
    int degrees = yk_freedom_of(answer->session->mech), driven = (int)freedom.driven;
    if (degrees == 0 && driven == 0) {
        yk_text_puts(out, "  it cannot move\n");
    } else if (driven == degrees) {
        yk_text_format(out, "  %d driven: the motion is determined\n", driven);
    } else if (driven < degrees) {
        yk_text_format(out, "  %d driven: %d more can be set with --at, or stay at their start\n", driven,
                       degrees - driven);
    } else {
        yk_text_format(out, "  %d driven: more than the machine has\n", driven);
    }
}

static void add_loops(const YkCheckAnswer *answer)
{
    YkText *out = &answer->session->out;
    size_t all = yk_loop_count(answer->session->mech), count = at_most(all);
    if (count > 0) yk_text_puts(out, "\nLoops\n");
    for (size_t l = 0; l < count; l++) {
        size_t bodies = at_most(yk_check_loop(answer, l));
        yk_text_format(out, "  %z: ", l + 1);
        for (size_t i = 0; i < bodies; i++) yk_text_format(out, "%s - ", body(answer, answer->bodies[i]));
        if (bodies > 0) yk_text_puts(out, body(answer, answer->bodies[0]));
        yk_text_format(out, ", closed at %s\n", joint(answer, yk_loop_joint(answer->session->mech, l)));
    }
    if (all > count) yk_text_format(out, "  ... and %z more\n", all - count);
}

static void add_names(const YkCheckAnswer *answer, size_t block, bool of_joints, size_t count, YkText *words)
{
    const YkMechanism *mech = answer->session->mech;
    size_t shown = at_most(count);
    yk_text_clear(words);
    for (size_t i = 0; i < shown; i++) {
        size_t index = of_joints ? yk_block_joint(mech, block, i) : yk_block_body(mech, block, i);
        yk_text_format(words, "%s%s", i > 0 ? ", " : "", of_joints ? joint(answer, index) : body(answer, index));
    }
    if (count > shown) yk_text_puts(words, ", ...");
    size_t relations = of_joints ? yk_block_info(mech, block).relation_count : 0;
    for (size_t i = 0; i < at_most(relations); i++)
        yk_text_format(words, "%s%s", i + shown > 0 ? ", " : "", yk_block_relation(mech, block, i));
}

static void add_block(const YkCheckAnswer *answer, YkTable *table, size_t b, YkText *words)
{
    static const char *const classes[] = {"-", "I", "II", "III", "IV", "V", "VI"};
    YkBlockInfo block = yk_block_info(answer->session->mech, b);
    yk_text_clear(words);
    yk_text_format(words, "%z", b + 1);
    yk_table_word(table, yk_text_get(words));
    yk_table_word(table, yk_block_kind_name(block.kind));
    yk_table_word(table, block.assur_class >= 0 && block.assur_class <= 6 ? classes[block.assur_class] : "over VI");
    yk_table_word(table, block.label ? block.label : "");
    yk_text_clear(words);
    yk_text_format(words, "%z", block.unknowns);
    yk_table_word(table, yk_text_get(words));
    add_names(answer, b, true, block.joint_count, words);
    yk_table_word(table, yk_text_get(words));
    add_names(answer, b, false, block.body_count, words);
    yk_table_word(table, yk_text_get(words));
}

static void add_blocks(const YkCheckAnswer *answer)
{
    static const char *const heads[] = {"step", "group", "class", "label", "unknowns", "joints", "places"};
    size_t all = yk_block_count(answer->session->mech), count = at_most(all);
    YkTable *table = yk_table_new(7);
    YkText words = {0};
    for (size_t i = 0; i < 7; i++) yk_table_head(table, heads[i], NULL);
    for (size_t b = 0; b < count; b++) add_block(answer, table, b, &words);
    yk_text_free(&words);
    write_table(&answer->session->out, "Order of solution (each step needs only the ones before)", table, count, all);
}

static void add_redundant(const YkCheckAnswer *answer)
{
    YkText *out = &answer->session->out;
    YkFreedom freedom = yk_mechanism_freedom(answer->session->mech);
    size_t count = yk_redundant_count(answer->session->mech);
    if (freedom.redundant == 0 && count == 0) return;
    yk_text_format(out, "\nRedundant: %z constraint%s repeat%s others", freedom.redundant, plural(freedom.redundant),
                   freedom.redundant == 1 ? "s" : "");
    for (size_t i = 0; i < at_most(count); i++)
        yk_text_format(out, "%s%s", i == 0 ? ", at joint " : ", ",
                       joint(answer, yk_redundant_joint(answer->session->mech, i)));
    yk_text_puts(out, "\n  It moves as long as the dimensions are exact.\n");
}

static void add_four_bars(const YkCheckAnswer *answer)
{
    YkText *out = &answer->session->out;
    if (answer->four_bar_count > 0) yk_text_puts(out, "\nFour-bars\n");
    for (size_t i = 0; i < answer->four_bar_count; i++) {
        const YkFourBar *bar = &answer->four_bars[i];
        double size = 1;
        const char *unit = yk_model_unit(answer->session->model, YK_QUANTITY_LENGTH, &size);
        yk_text_format(out, "  frame %s, input %s, coupler %s, output %s: %s\n    lengths", body(answer, bar->body[0]),
                       body(answer, bar->body[1]), body(answer, bar->body[2]), body(answer, bar->body[3]),
                       yk_four_bar_name(bar->kind));
        for (int k = 0; k < 4; k++) yk_text_format(out, "%s %e", k > 0 ? "," : "", bar->length[k] / size);
        yk_text_format(out, " %s\n", unit);
    }
}

// Adds "; 2 springs" if there are any.
static void add_kind(YkText *out, size_t count, const char *noun)
{
    if (count > 0) yk_text_format(out, "; %z %s%s", count, noun, plural(count));
}

static void add_forces(const YkCheckAnswer *answer)
{
    YkText *out = &answer->session->out;
    const YkLoadCounts *loads = &answer->loads;
    if (!answer->has_loads) return;
    yk_text_format(out, "\nMasses and loads\n  %z bod%s with mass", loads->masses, loads->masses == 1 ? "y" : "ies");
    if (loads->mass > 0) {
        yk_text_puts(out, ", ");
        yk_add_value(answer->session, out, loads->mass, YK_QUANTITY_MASS, YK_DIGITS);
        yk_text_puts(out, " in all");
    }
    yk_text_puts(out, loads->has_gravity ? "; gravity" : "; no gravity");
    add_kind(out, loads->efforts, "effort");
    add_kind(out, loads->forces, "force");
    add_kind(out, loads->springs, "spring");
    add_kind(out, loads->dampers, "damper");
    if (loads->frictions > 0)
        yk_text_format(out, "; friction at %z joint%s", loads->frictions, plural(loads->frictions));
    add_kind(out, loads->stops, "stop");
    yk_text_puts(out, "\n  free bodies: ");
    yk_add_count(out, answer->equations);
    yk_text_puts(out, "\n");
}

void yk_check_text(const YkCheckAnswer *answer)
{
    add_head(answer);
    add_joints(answer);
    add_coordinates(answer);
    add_freedom(answer);
    add_loops(answer);
    add_blocks(answer);
    add_redundant(answer);
    add_four_bars(answer);
    add_forces(answer);
    if (answer->status < 0)
        yk_text_format(&answer->session->out, "\nThe machine cannot be assembled at its start: %s\n", answer->message);
}
