// Reads the segments of a law: each is a map in which one key gives the kind.
#include <string.h>
#include "model/laws/read.h"

typedef struct SegmentKind {
    const char *key;
    YkLawKind kind;
    void (*read)(YkLawReader *reader, const YkNode *node, YkLawPart *part);
} SegmentKind;

static void read_condition(YkLawReader *reader, const YkNode *node, YkLawGiven *given)
{
    static const char *const keys[] = {"at", "s", "v", "a", "j", "p", NULL};
    const YkModelLaw *law = reader->law;
    given->place = node->place;
    if (!yk_load_law_expect(reader, node, YK_NODE_MAP, "condition")) return;
    yk_load_check_keys(reader->loader, node, keys, &(YkSubject){.noun = "condition", .owner = law->name});
    yk_load_law_required(reader, node, "at", law->of, &given->at);
    bool has_any = false;
    for (int order = 0; order <= YK_LAW_ORDER; order++) {
        YkDimension dimension = yk_dimension_times(law->value, law->of, -order);
        has_any |= yk_load_law_optional(reader, node, keys[1 + order], dimension, &given->d[order]);
    }
    if (has_any) return;
    yk_problem(reader->loader->problems, YK_CODE_LAW_CONDITIONS, node->place,
               "a condition of law %q gives only its place", law->name);
    yk_problem_hint(reader->loader->problems, "give one or more of s, v, a, j, p, as in {at: 0, s: 0, v: 0}");
    reader->source->is_bad = true;
}

static void read_conditions(YkLawReader *reader, const YkNode *node, YkLawPart *part)
{
    if (!yk_load_law_expect(reader, node, YK_NODE_LIST, "list of conditions")) return;
    part->given = YK_NEW(reader->loader->arena, YkLawGiven, node->count + 1);
    if (!part->given) return;
    part->given_count = node->count;
    for (size_t i = 0; i < node->count; i++) read_condition(reader, node->items[i], &part->given[i]);
}

static void read_dwell(YkLawReader *reader, const YkNode *node, YkLawPart *part)
{
    static const char *const keys[] = {"to", NULL};
    if (!yk_load_law_expect(reader, node, YK_NODE_MAP, "dwell")) return;
    yk_load_check_keys(reader->loader, node, keys, &(YkSubject){.noun = "dwell", .owner = reader->law->name});
    yk_load_law_required(reader, node, "to", reader->law->of, &part->to);
}

static void read_velocity(YkLawReader *reader, const YkNode *node, YkLawPart *part)
{
    static const char *const keys[] = {"to", "v", NULL};
    const YkModelLaw *law = reader->law;
    if (!yk_load_law_expect(reader, node, YK_NODE_MAP, "constant-velocity")) return;
    yk_load_check_keys(reader->loader, node, keys, &(YkSubject){.noun = "constant-velocity", .owner = law->name});
    yk_load_law_required(reader, node, "to", law->of, &part->to);
    yk_load_law_required(reader, node, "v", yk_dimension_times(law->value, law->of, -1), &part->v);
}

// Reads {s: expression of x, to: ..., of: x}; `of` names the argument.
static void read_formula(YkLawReader *reader, const YkNode *node, YkLawPart *part)
{
    static const char *const keys[] = {"to", "s", "of", NULL};
    YkLoader *loader = reader->loader;
    const YkModelLaw *law = reader->law;
    if (!yk_load_law_expect(reader, node, YK_NODE_MAP, "formula")) return;
    yk_load_check_keys(loader, node, keys, &(YkSubject){.noun = "formula", .owner = law->name});
    yk_load_law_required(reader, node, "to", law->of, &part->to);
    const YkNode *of = yk_node_get(node, "of"), *s = yk_node_get(node, "s");
    if (!s) {
        YkLawNumber missing;
        yk_load_law_required(reader, node, "s", law->value, &missing);
        return;
    }
    if (of && (!yk_load_law_expect(reader, of, YK_NODE_SCALAR, "of") || !yk_load_symbol_name(loader, of, "argument"))) {
        reader->source->is_bad = true;
        return;
    }
    yk_text_clear(&loader->text);
    yk_text_format(&loader->text, "%s%s", YK_LAW_ARGUMENT, law->name);
    const char *argument = yk_arena_copy(loader->arena, yk_text_get(&loader->text), loader->text.length);
    if (!argument) return;
    const YkOwnName own[] = {{of ? of->text : "x", argument, "the law's argument"}, {0}};
    YkWant want = {.dimension = law->value, .subject = {.noun = "formula", .owner = law->name}, .own = own};
    part->formula = yk_load_value(loader, s, &want, NULL);
    part->argument = argument;
    part->written = s->kind == YK_NODE_SCALAR ? yk_arena_copy(loader->arena, s->text, s->length) : NULL;
    part->called = yk_arena_copy(loader->arena, own[0].name, strlen(own[0].name));
    if (!part->formula) reader->source->is_bad = true;
}

static void wrong_word(YkLawReader *reader, const YkNode *node, const char *wanted, const char *const *words)
{
    yk_problem(reader->loader->problems, YK_CODE_WRONG_WORD, node->place, "%s, not %q", wanted, node->text);
    yk_load_hint_nearest_key(reader->loader, node->text, words);
    reader->source->is_bad = true;
}

static void read_rise_law(YkLawReader *reader, const YkNode *node, YkLawPart *part)
{
    const char *words[20] = {"spline"};
    if (!yk_load_law_expect(reader, node, YK_NODE_SCALAR, "law")) return;
    part->is_spline = strcmp(node->text, "spline") == 0;
    if (part->is_spline || yk_rise_find(node->text, &part->rise.law)) return;
    for (int i = 0; i < 18 && yk_rise_name((YkRiseLaw)i); i++) words[i + 1] = yk_rise_name((YkRiseLaw)i);
    wrong_word(reader, node, "there is no such law of a rise or fall", words);
}

static void read_half(YkLawReader *reader, const YkNode *node, YkLawPart *part)
{
    static const char *const words[] = {"first", "second", NULL};
    if (!yk_load_law_expect(reader, node, YK_NODE_SCALAR, "half")) return;
    if (strcmp(node->text, "first") == 0)
        part->rise.half = YK_RISE_FIRST_HALF;
    else if (strcmp(node->text, "second") == 0)
        part->rise.half = YK_RISE_SECOND_HALF;
    else
        wrong_word(reader, node, "a half is the `first` or the `second`", words);
}

static void read_scca(YkLawReader *reader, const YkNode *node, YkLawPart *part)
{
    static const char *const keys[] = {"b", "c", "d", NULL};
    if (!yk_load_law_expect(reader, node, YK_NODE_MAP, "scca")) return;
    yk_load_check_keys(reader->loader, node, keys, &(YkSubject){.noun = "scca", .owner = reader->law->name});
    yk_load_law_required(reader, node, "b", YK_DIM_NUMBER, &part->b);
    yk_load_law_required(reader, node, "c", YK_DIM_NUMBER, &part->c);
    yk_load_law_required(reader, node, "d", YK_DIM_NUMBER, &part->d);
}

// Returns a key that belongs to one law only.
static const YkNode *key_of(YkLawReader *reader, const YkNode *node, const char *key, bool belongs, const char *law)
{
    const YkNode *value = yk_node_get(node, key);
    if (!value || belongs) return value;
    yk_problem(reader->loader->problems, YK_CODE_LAW_SHAPE, yk_load_key(node, key)->place, "`%s` is for `law: %s` only",
               key, law);
    reader->source->is_bad = true;
    return NULL;
}

static void read_rise(YkLawReader *reader, const YkNode *node, YkLawPart *part)
{
    static const char *const keys[] = {"to", "by", "law", "half", "scca", "blend", "through", "degree", NULL};
    const YkModelLaw *law = reader->law;
    const char *noun = part->kind == YK_LAW_RISE ? "rise" : "fall";
    if (!yk_load_law_expect(reader, node, YK_NODE_MAP, noun)) return;
    yk_load_check_keys(reader->loader, node, keys, &(YkSubject){.noun = noun, .owner = law->name});
    yk_load_law_required(reader, node, "to", law->of, &part->to);
    yk_load_law_required(reader, node, "by", law->value, &part->by);
    const YkNode *word = yk_node_get(node, "law"), *half = yk_node_get(node, "half");
    if (!word) {
        yk_problem(reader->loader->problems, YK_CODE_MISSING_KEY, node->place, "a %s of law %q needs `law`", noun,
                   law->name);
        yk_problem_hint(reader->loader->problems, "for instance `law: cycloidal`, or `law: 3-4-5`");
        reader->source->is_bad = true;
        return;
    }
    read_rise_law(reader, word, part);
    bool is_scca = !part->is_spline && part->rise.law == YK_RISE_SCCA;
    const YkNode *scca = is_scca ? yk_node_get(node, "scca") : key_of(reader, node, "scca", false, "scca");
    if (is_scca && !scca) yk_load_law_required(reader, node, "scca", YK_DIM_NUMBER, &part->b);
    if (scca) read_scca(reader, scca, part);
    bool blends = !part->is_spline && part->rise.law == YK_RISE_CONSTANT_VELOCITY;
    const YkNode *blend = key_of(reader, node, "blend", blends, "constant-velocity");
    if (blend) yk_load_law_number(reader, blend, "blend", YK_DIM_NUMBER, &part->blend);
    const YkNode *through = key_of(reader, node, "through", part->is_spline, "spline");
    if (through) read_conditions(reader, through, part);
    const YkNode *degree = key_of(reader, node, "degree", part->is_spline, "spline");
    if (degree) yk_load_law_number(reader, degree, "degree", YK_DIM_NUMBER, &part->degree);
    if (half) read_half(reader, half, part);
}

static const SegmentKind kinds[] = {
    {"polynomial", YK_LAW_POLYNOMIAL, read_conditions},
    {"spline", YK_LAW_SPLINE, read_conditions},
    {"dwell", YK_LAW_DWELL, read_dwell},
    {"rise", YK_LAW_RISE, read_rise},
    {"fall", YK_LAW_FALL, read_rise},
    {"constant-velocity", YK_LAW_CONSTANT_VELOCITY, read_velocity},
    {"formula", YK_LAW_FORMULA, read_formula},
};
enum { KIND_COUNT = sizeof kinds / sizeof *kinds };
static const char *const segment_keys[] = {"polynomial",        "spline",  "dwell",  "rise", "fall",
                                           "constant-velocity", "formula", "degree", NULL};

static bool is_segment_key(const char *key)
{
    for (size_t i = 0; segment_keys[i]; i++) {
        if (strcmp(segment_keys[i], key) == 0) return true;
    }
    return false;
}

// Returns the kind of a segment; NULL (reported) if it has none or several.
static const SegmentKind *kind_of(YkLawReader *reader, const YkNode *node)
{
    const SegmentKind *found = NULL;
    size_t count = 0, strange = 0;
    for (size_t i = 0; i < KIND_COUNT; i++) {
        if (!yk_load_key(node, kinds[i].key)) continue;
        found = &kinds[i];
        count++;
    }
    for (size_t i = 0; i < node->count; i++) strange += !is_segment_key(node->pairs[i].key->text);
    if (count == 1) return found;
    reader->source->is_bad = true;
    if (count == 0 && strange > 0) return NULL; // a misspelt key, which is reported
    yk_problem(reader->loader->problems, YK_CODE_LAW_SEGMENT, node->place,
               count ? "a segment of law %q has two kinds" : "a segment of law %q does not say which kind it is",
               reader->law->name);
    yk_problem_hint(
        reader->loader->problems,
        "a segment is one of polynomial, spline, dwell, rise, fall, constant-velocity, formula, each between its "
        "own braces, as in {dwell: {to: 90 deg}}");
    return NULL;
}

static void read_segment(YkLawReader *reader, const YkNode *node, YkLawPart *part)
{
    part->place = node->place;
    if (!yk_load_law_expect(reader, node, YK_NODE_MAP, "segment")) return;
    yk_load_check_keys(reader->loader, node, segment_keys, &(YkSubject){.noun = "segment", .owner = reader->law->name});
    const SegmentKind *kind = kind_of(reader, node);
    if (!kind) return;
    part->kind = kind->kind;
    part->place = yk_load_key(node, kind->key)->place;
    kind->read(reader, yk_node_get(node, kind->key), part);
    const YkNode *degree = yk_node_get(node, "degree");
    if (degree && kind->kind == YK_LAW_SPLINE) {
        yk_load_law_number(reader, degree, "degree", YK_DIM_NUMBER, &part->degree);
    } else if (degree) {
        yk_problem(reader->loader->problems, YK_CODE_LAW_SEGMENT, yk_load_key(node, "degree")->place,
                   "`degree` is for splines only; a polynomial's follows from the number of its conditions");
        reader->source->is_bad = true;
    }
}

void yk_load_law_segments(YkLawReader *reader, const YkNode *segments)
{
    YkLawSource *source = reader->source;
    if (!yk_load_law_expect(reader, segments, YK_NODE_LIST, "segments")) return;
    if (segments->count == 0) {
        yk_problem(reader->loader->problems, YK_CODE_LAW_KIND, segments->place, "law %q has no segments",
                   reader->law->name);
        source->is_bad = true;
        return;
    }
    source->parts = YK_NEW(reader->loader->arena, YkLawPart, segments->count);
    if (!source->parts) return;
    source->part_count = segments->count;
    for (size_t i = 0; i < segments->count; i++) read_segment(reader, segments->items[i], &source->parts[i]);
}
