// Prints pages as JSON: {"model", "sections": [{"name", "title", "items": [...]}]}; man/yoke-derive.1.scd gives the
// shape.
#include "page/print.h"
#include "write/json.h"

static void put_entry(YkPrinting *printing, YkJson *json, const YkRingView *entry)
{
    YkText text = {0};
    yk_print_view(printing, entry, YK_RING_TEXT, YK_RING_TEXTBOOK, &text);
    yk_json_string(json, NULL, yk_text_get(&text));
    yk_text_free(&text);
}

static void put_cuts(YkJson *json, const char *key, const bool *cuts, size_t count)
{
    yk_json_list(json, key, YK_JSON_INLINE);
    for (size_t k = 0; k + 1 < count; k++)
        if (cuts[k]) yk_json_integer(json, NULL, (long long)k + 1);
    yk_json_end(json);
}

static void put_matrix(YkPrinting *printing, YkJson *json, const YkShownMatrix *matrix)
{
    yk_json_object(json, NULL, YK_JSON_LINES);
    yk_json_list(json, "entries", YK_JSON_LINES);
    for (size_t i = 0; i < matrix->rows; i++) {
        yk_json_list(json, NULL, YK_JSON_INLINE);
        for (size_t k = 0; k < matrix->columns; k++) {
            const YkRingView entry = yk_shown_entry(matrix, i * matrix->columns + k);
            put_entry(printing, json, &entry);
        }
        yk_json_end(json);
    }
    yk_json_end(json);
    if (matrix->columns > 0 && matrix->column_symbols[0] >= 0) {
        yk_json_list(json, "columns", YK_JSON_INLINE);
        for (size_t k = 0; k < matrix->columns; k++)
            yk_json_string(json, NULL, yk_ring_symbol_name(printing->ring, matrix->column_symbols[k]));
        yk_json_end(json);
        yk_json_list(json, "rows", YK_JSON_INLINE);
        for (size_t i = 0; i < matrix->rows; i++) yk_json_string(json, NULL, matrix->row_labels[i]);
        yk_json_end(json);
        put_cuts(json, "row_cuts", matrix->row_cut, matrix->rows);
        put_cuts(json, "column_cuts", matrix->column_cut, matrix->columns);
    }
    if (printing->values) {
        yk_json_list(json, "values", YK_JSON_LINES);
        for (size_t i = 0; i < matrix->rows; i++) {
            yk_json_list(json, NULL, YK_JSON_INLINE);
            for (size_t k = 0; k < matrix->columns; k++) {
                const YkRingView entry = yk_shown_entry(matrix, i * matrix->columns + k);
                yk_json_number(json, NULL, yk_print_entry(printing, &entry));
            }
            yk_json_end(json);
        }
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void put_matrices(YkPrinting *printing, YkJson *json, const YkLine *line)
{
    bool any = false;
    for (const YkPagePiece *piece = line->first; piece; piece = piece->next) {
        if (piece->kind != YK_PIECE_MATRIX) continue;
        if (!any) yk_json_list(json, "matrices", YK_JSON_LINES);
        any = true;
        put_matrix(printing, json, piece->matrix);
    }
    if (any) yk_json_end(json);
}

static void put_formula(YkPrinting *printing, YkJson *json, const YkLine *line)
{
    YkText text = {0};
    YkVec value;
    if (line->text) yk_json_string(json, "remark", line->text);
    yk_print_formula_text(printing, line, &text);
    yk_json_string(json, "text", yk_text_get(&text));
    yk_text_clear(&text);
    yk_print_formula_latex(printing, line, &text);
    yk_json_string(json, "latex", yk_text_get(&text));
    yk_text_free(&text);
    put_matrices(printing, json, line);
    if (!yk_print_value(printing, line, &value)) return;
    if (!line->is_vector) {
        yk_json_number(json, "value", value.x);
        return;
    }
    yk_json_numbers(json, "value", (double[]){value.x, value.y}, 2);
}

static void put_item(YkPrinting *printing, YkJson *json, const YkLine *line)
{
    static const char *const kinds[] = {"heading", "words", "formula"};
    yk_json_object(json, NULL, YK_JSON_LINES);
    yk_json_string(json, "kind", kinds[line->kind]);
    if (line->kind == YK_LINE_FORMULA)
        put_formula(printing, json, line);
    else
        yk_json_string(json, "text", line->text);
    yk_json_end(json);
}

static void end_section(YkPrinting *printing)
{
    for (int k = 0; k < 2 && printing->in_section; k++) yk_json_end(&printing->json);
    printing->in_section = false;
}

void yk_print_json_head(YkPrinting *printing)
{
    printing->json = (YkJson){.text = printing->text};
    yk_json_object(&printing->json, NULL, YK_JSON_LINES);
    yk_json_string(&printing->json, "model", printing->title);
    yk_json_list(&printing->json, "sections", YK_JSON_LINES);
}

void yk_print_json_part(YkPrinting *printing, const YkPage *part)
{
    YkJson *json = &printing->json;
    for (const YkLine *line = part->first; line && !printing->failed; line = line->next) {
        if (line->kind == YK_LINE_HEADING && line->level == 1) {
            end_section(printing);
            printing->in_section = true;
            yk_json_object(json, NULL, YK_JSON_LINES);
            yk_json_string(json, "name", line->section);
            yk_json_string(json, "title", line->text);
            yk_json_list(json, "items", YK_JSON_LINES);
        } else if (printing->in_section) {
            put_item(printing, json, line);
        }
    }
}

void yk_print_json_end(YkPrinting *printing)
{
    end_section(printing);
    yk_json_end(&printing->json);
    yk_json_end(&printing->json);
}
