// Prints pages as C: a struct of everything in the formulas, and one function per section, which computes what the
// section states. Shared parts are computed once (graph/graph.h).
#include <stdlib.h>
#include <string.h>
#include "base/number.h"
#include "page/print.h"
#include "ring/graph/graph.h"

// A result of a function: an array, a number, or a field of the struct.
typedef struct Result {
    const char *name; // NULL: a field
    int32_t field;
    size_t rows, columns; // of an array; 0: one number
    size_t first;         // of its values
} Result;

typedef struct Code {
    YkPrinting *printing;
    const YkPage *page;
    YkGraph *graph;
    YkText prototypes, functions, words;
    bool *is_field; // per symbol: some function writes it
    size_t symbol_count;
    // Of the present function:
    Result *results;
    size_t result_count, result_capacity;
    YkGraphValue *values;
    size_t value_count, value_capacity;
    YkArena *arena; // of names
    bool failed;
} Code;

// --- Results

static Result *add_result(Code *code, const char *name, int32_t field, size_t rows, size_t columns)
{
    if (!YK_ROOM(code->results, code->result_count, code->result_capacity)) {
        code->failed = true;
        return NULL;
    }
    Result *result = &code->results[code->result_count++];
    *result = (Result){name, field, rows, columns, code->value_count};
    return result;
}

static void add_value(Code *code, YkGraphValue value)
{
    if (value < 0 || !YK_ROOM(code->values, code->value_count, code->value_capacity)) {
        code->failed = true;
        return;
    }
    code->values[code->value_count++] = value;
}

static YkGraphValue value_of(Code *code, const YkPoisson *over, const YkPoisson *under)
{
    YkGraphValue value = yk_graph_of(code->graph, over);
    return under ? yk_graph_divide(code->graph, value, yk_graph_of(code->graph, under)) : value;
}

static void add_matrix(Code *code, const YkShownMatrix *matrix)
{
    size_t count = matrix->rows * matrix->columns;
    if (!add_result(code, matrix->target, -1, matrix->rows, matrix->columns)) return;
    YkGraphValue *entries = calloc(count + 1, sizeof *entries);
    if (!entries) {
        code->failed = true;
        return;
    }
    if (matrix->build) code->failed |= !matrix->build(matrix->build_context, code->graph, entries);
    for (size_t k = 0; k < count; k++) {
        const YkPoisson *entry = matrix->entries[k];
        bool is_built = matrix->build || !entry;
        add_value(code, matrix->build ? entries[k]
                        : is_built    ? yk_graph_number(code->graph, 0)
                                      : value_of(code, entry, NULL));
    }
    free(entries);
}

static bool is_constant(const Code *code, int32_t symbol)
{
    YkRingClass kind = yk_ring_symbol_class(code->page->ring, symbol);
    return kind <= YK_RING_CONSTANT || kind == YK_RING_GRAVITY;
}

// Adds a symbol that the line solves for: a field of the struct, known from now on. Names of constants are for readers.
static void add_field(Code *code, const YkLine *line)
{
    if (is_constant(code, line->solved) || !add_result(code, NULL, line->solved, 0, 0)) return;
    YkGraphValue value = value_of(code, line->over, line->under);
    add_value(code, value);
    code->is_field[line->solved] = true;
    if (!code->failed) yk_graph_define(code->graph, line->solved, value);
}

// Adds a loop's equation; one array holds them all.
static void add_row(Code *code, const YkLine *line)
{
    Result *last = code->result_count > 0 ? &code->results[code->result_count - 1] : NULL;
    if (!last || !last->name || strcmp(last->name, "Phi") != 0) last = add_result(code, "Phi", -1, 0, 1);
    if (last) last->rows++;
    add_value(code, value_of(code, line->over, line->under));
}

// --- Names: p^{A/O} is p_A_O; a name that two lines share gets a number

static bool is_taken(const Code *code, const char *name)
{
    for (size_t k = 0; k < code->result_count; k++)
        if (code->results[k].name && strcmp(code->results[k].name, name) == 0) return true;
    return false;
}

static const char *name_of(Code *code, const YkPagePiece *piece)
{
    const char *const parts[] = {piece->text, piece->super, piece->sub};
    YkText name = {0};
    for (int k = 0; k < 3; k++) {
        if (!parts[k] || !*parts[k]) continue;
        if (k > 0) yk_text_puts(&name, "_");
        for (const char *c = parts[k]; *c; c++) {
            bool fits = (*c >= 'a' && *c <= 'z') || (*c >= 'A' && *c <= 'Z') || (*c >= '0' && *c <= '9');
            yk_text_format(&name, "%c", fits ? *c : '_');
        }
    }
    size_t length = name.length;
    for (unsigned number = 2; !name.failed && is_taken(code, yk_text_get(&name)); number++) {
        name.length = length;
        yk_text_format(&name, "_%u", number);
    }
    const char *copy = yk_arena_copy(code->arena, yk_text_get(&name), name.length);
    yk_text_free(&name);
    if (!copy) code->failed = true;
    return copy ? copy : "";
}

// Returns whether it is "F_12 = ..." with a value, a definition.
static bool is_named_value(const YkLine *line)
{
    const YkPagePiece *first = line->first, *second = first ? first->next : NULL;
    if (line->value && line->target) return true;
    return line->value && first->kind == YK_PIECE_VECTOR && second && second->kind == YK_PIECE_SIGN &&
           strcmp(second->text, "=") == 0;
}

static void add_named(Code *code, const YkLine *line)
{
    YkRing *ring = code->page->ring;
    const char *name = line->target ? line->target : name_of(code, line->first);
    if (!add_result(code, name, -1, line->is_vector ? 2 : 0, 1)) return;
    if (!line->is_vector) {
        add_value(code, value_of(code, line->value, line->value_under));
        return;
    }
    add_value(code, value_of(code, yk_ring_real(ring, line->value), NULL));
    add_value(code, value_of(code, yk_ring_imaginary(ring, line->value), NULL));
}

static bool add_matrices(Code *code, const YkLine *line)
{
    bool found = false;
    for (const YkPagePiece *piece = line->first; piece; piece = piece->next) {
        if (piece->kind != YK_PIECE_MATRIX || !piece->matrix->target) continue;
        add_matrix(code, piece->matrix);
        found = true;
    }
    return found;
}

static void add_line(Code *code, const YkLine *line)
{
    if (line->kind != YK_LINE_FORMULA || add_matrices(code, line)) return;
    if (line->solved >= 0)
        add_field(code, line);
    else if (line->target && line->over && strcmp(line->target, "Phi") == 0)
        add_row(code, line);
    else if (is_named_value(line))
        add_named(code, line);
}

// --- Functions

static void put_comment(YkText *text, const char *indent, const char *words)
{
    yk_text_format(text, "%s// ", indent);
    size_t column = strlen(indent) + 3;
    if (words == yk_text_lost) yk_text_fail(text);
    for (const char *c = words; *c; c++, column++) {
        bool is_break = *c == ' ' && column + strcspn(c + 1, " ") > 116;
        if (is_break) column = strlen(indent) + 2;
        if (is_break)
            yk_text_format(text, "\n%s// ", indent);
        else
            yk_text_format(text, "%c", *c == '\\' || *c == '\n' ? '/' : *c);
    }
    yk_text_puts(text, "\n");
}

static void put_parameters(Code *code, YkText *text)
{
    bool writes = false;
    for (size_t k = 0; k < code->result_count; k++) writes = writes || !code->results[k].name;
    yk_text_puts(text, writes ? "(Machine *m" : "(const Machine *restrict m");
    for (size_t k = 0; k < code->result_count; k++) {
        const Result *r = &code->results[k];
        if (!r->name) continue;
        yk_text_format(text, r->rows > 0 ? ", double %s[%z]" : ", double *%s", r->name, r->rows);
        if (r->columns > 1) yk_text_format(text, "[%z]", r->columns);
    }
    yk_text_puts(text, ")");
}

static void put_target(Code *code, const Result *r, size_t k)
{
    YkText *text = &code->words;
    if (!r->name) {
        yk_text_format(text, "    m->%s = ", yk_ring_name_in(code->page->ring, r->field, YK_RING_C));
        return;
    }
    yk_text_format(text, r->rows > 0 ? "    %s" : "    *%s", r->name);
    if (r->rows > 0) yk_text_format(text, "[%z]", k / r->columns);
    if (r->columns > 1) yk_text_format(text, "[%z]", k % r->columns);
    yk_text_puts(text, " = ");
}

static size_t size_of(const Result *r)
{
    return r->rows > 0 ? r->rows * r->columns : 1;
}

// Writes the statements in `words`.
static void put_body(Code *code)
{
    YkText *text = &code->words;
    yk_text_clear(text);
    yk_graph_begin(code->graph);
    for (size_t k = 0; k < code->result_count; k++)
        if (!code->results[k].name) yk_graph_writes(code->graph, code->results[k].field);
    for (size_t k = 0; k < code->value_count; k++) yk_graph_want(code->graph, code->values[k]);
    yk_graph_put_shared(code->graph, text);
    for (size_t k = 0; k < code->result_count; k++)
        for (size_t e = 0; e < size_of(&code->results[k]); e++) {
            put_target(code, &code->results[k], e);
            yk_graph_put(code->graph, code->values[code->results[k].first + e], text);
            yk_text_puts(text, ";\n");
        }
}

static void put_identifier(YkText *text, const char *section)
{
    for (const char *c = section; *c; c++) yk_text_format(text, "%c", *c == '-' ? '_' : *c);
}

static void put_remarks(Code *code, const YkLine *first, const char *section)
{
    for (const YkLine *line = first; line && line->section == section; line = line->next)
        for (const YkPagePiece *piece = line->first; piece; piece = piece->next)
            if (piece->kind == YK_PIECE_MATRIX && piece->matrix->target && piece->matrix->code_remark)
                put_comment(&code->functions, "", piece->matrix->code_remark);
}

// Writes one section; returns the line after it.
static const YkLine *put_section(Code *code, const YkLine *first)
{
    const char *section = first->section;
    const YkLine *line = first;
    size_t known = yk_graph_definitions(code->graph);
    code->result_count = code->value_count = 0;
    for (; line && line->section == section && !code->failed; line = line->next) add_line(code, line);
    if (code->failed) return NULL;
    if (code->result_count > 0) {
        put_body(code);
        yk_text_puts(&code->prototypes, "void machine_");
        put_identifier(&code->prototypes, section);
        put_parameters(code, &code->prototypes);
        yk_text_puts(&code->prototypes, ";\n");
        yk_text_puts(&code->functions, "\n");
        put_comment(&code->functions, "", first->kind == YK_LINE_HEADING ? first->text : section);
        put_remarks(code, first, section);
        yk_text_puts(&code->functions, "void machine_");
        put_identifier(&code->functions, section);
        put_parameters(code, &code->functions);
        bool reads = strstr(yk_text_get(&code->words), "m->") != NULL;
        yk_text_format(&code->functions, "\n{\n%s%s}\n", reads ? "" : "    (void)m;\n", yk_text_get(&code->words));
    }
    yk_graph_forget(code->graph, known);
    return line;
}

// --- The whole

static bool is_in_struct(const Code *code, size_t symbol)
{
    return code->is_field[symbol] || yk_graph_reads(code->graph, (int32_t)symbol);
}

// Writes the fields: constants first, then the rest.
static void put_struct(Code *code, YkText *text)
{
    size_t count = 0;
    yk_text_puts(text, "typedef struct Machine {\n");
    for (int rest = 0; rest < 2; rest++)
        for (size_t s = 0; s < code->symbol_count; s++) {
            if (!is_in_struct(code, s) || is_constant(code, (int32_t)s) == (rest == 1)) continue;
            const char *name = yk_ring_symbol_name(code->page->ring, (int32_t)s);
            const char *field = yk_ring_name_in(code->page->ring, (int32_t)s, YK_RING_C);
            bool is_same = strcmp(name, field) == 0;
            yk_text_format(text, "    double %s;%s%s\n", field, is_same ? "" : " // ", is_same ? "" : name);
            count++;
        }
    size_t constants = yk_graph_constants(code->graph);
    if (constants > 0) yk_text_format(text, "    double constant[%z]; // by machine_constants\n", constants);
    if (constants + count == 0) yk_text_puts(text, "    double unused;\n");
    yk_text_puts(text, "} Machine;\n");
}

static void put_pose(Code *code, YkText *text)
{
    bool is_first = true;
    yk_text_puts(text, "\n// The pose.\nconst Machine machine_at_pose = {");
    for (size_t s = 0; s < code->symbol_count; s++) {
        char digits[YK_NUMBER_SIZE];
        double value = code->printing->values[s];
        if (!is_in_struct(code, s) || !(value - value == 0)) continue;
        yk_number_write(value, digits);
        yk_text_format(text, "%s.%s = %s", is_first ? "" : ",\n                               ",
                       yk_ring_name_in(code->page->ring, (int32_t)s, YK_RING_C), digits);
        is_first = false;
    }
    yk_text_puts(text, is_first ? "0};\n" : "};\n");
}

static void put_all(Code *code, YkText *text)
{
    const char *title = code->printing->title;
    if (title) put_comment(text, "", title);
    yk_text_puts(
        text, "// Set the fields, in SI and radians; then machine_constants, again after every change of a parameter; "
              "then the rest.\n// Needs libm.\n#include <math.h>\n\n");
    yk_text_clear(&code->words);
    yk_graph_put_constants(code->graph, &code->words); // before the struct: they read parameters
    put_struct(code, text);
    if (code->printing->values) put_pose(code, text);
    yk_text_format(text, "\nvoid machine_constants(Machine *m);\n%s", yk_text_get(&code->prototypes));
    yk_text_puts(text, "\n// What depends on parameters alone.\nvoid machine_constants(Machine *m)\n{\n");
    yk_text_format(text, "%s%s}\n", strstr(yk_text_get(&code->words), "m->") ? "" : "    (void)m;\n",
                   yk_text_get(&code->words));
    yk_text_puts(text, yk_text_get(&code->functions));
}

static bool start(Code *code)
{
    const YkPage *page = code->page;
    code->graph = yk_graph_new(page->ring);
    code->arena = yk_arena_new();
    if (!code->graph || !code->arena) return false;
    return !page->define || page->define(page->define_context, code->graph);
}

void yk_print_c(YkPrinting *printing, const YkPage *page)
{
    Code code = {.printing = printing, .page = page};
    code.symbol_count = yk_ring_symbol_count(page->ring);
    code.is_field = calloc(code.symbol_count + 1, sizeof *code.is_field);
    code.failed = !code.is_field || !start(&code);
    for (const YkLine *line = page->first; line && !code.failed;) line = put_section(&code, line);
    if (!code.failed) {
        put_all(&code, printing->text);
        code.failed =
            code.prototypes.failed || code.functions.failed || code.words.failed || yk_graph_failed(code.graph);
    }
    printing->failed |= code.failed;
    yk_text_free(&code.prototypes);
    yk_text_free(&code.functions);
    yk_text_free(&code.words);
    free(code.results);
    free(code.values);
    free(code.is_field);
    yk_graph_free(code.graph);
    yk_arena_free(code.arena);
}
