// Writes JSON.
#include "write/json.h"
#include <math.h>
#include "base/number.h"

// Source of the escapes: RFC 8259, section 7. Everything above ASCII goes through as UTF-8.
static void add_quoted(YkText *text, const char *string)
{
    static const char hex[] = "0123456789abcdef";
    if (string == yk_text_lost) yk_text_fail(text);
    yk_text_add(text, "\"", 1);
    for (const char *c = string; *c; c++) {
        unsigned char byte = (unsigned char)*c;
        if (byte == '"' || byte == '\\') {
            yk_text_format(text, "\\%c", *c);
        } else if (byte < 0x20 || byte == 0x7f) {
            yk_text_format(text, "\\u00%c%c", hex[byte >> 4], hex[byte & 15]);
        } else {
            yk_text_add(text, c, 1);
        }
    }
    yk_text_add(text, "\"", 1);
}

static void add_break(YkJson *json)
{
    yk_text_add(json->text, "\n", 1);
    yk_text_repeat(json->text, ' ', (size_t)json->depth * 2);
}

// Writes what comes before a member: a comma if one is due, the indentation, the key.
static void add_member(YkJson *json, const char *key)
{
    if (json->depth > 0) {
        int level = json->depth - 1;
        if (json->has_members[level]) yk_text_puts(json->text, json->is_inline[level] ? ", " : ",");
        if (!json->is_inline[level]) add_break(json);
        json->has_members[level] = true;
    }
    if (key) {
        add_quoted(json->text, key);
        yk_text_puts(json->text, ": ");
    }
}

static void open_level(YkJson *json, const char *key, YkLayout layout, char opening, char closing)
{
    add_member(json, key);
    yk_text_add(json->text, &opening, 1);
    if (json->depth >= YK_JSON_DEPTH) { // an error of the caller; the text must not pass for complete
        json->text->failed = true;
        return;
    }
    int level = json->depth++;
    json->has_members[level] = false;
    json->is_inline[level] = layout == YK_JSON_INLINE || (level > 0 && json->is_inline[level - 1]);
    json->closing[level] = closing;
}

void yk_json_object(YkJson *json, const char *key, YkLayout layout)
{
    open_level(json, key, layout, '{', '}');
}

void yk_json_list(YkJson *json, const char *key, YkLayout layout)
{
    open_level(json, key, layout, '[', ']');
}

void yk_json_end(YkJson *json)
{
    if (json->depth == 0) return;
    int level = --json->depth;
    if (json->has_members[level] && !json->is_inline[level]) add_break(json);
    yk_text_add(json->text, &json->closing[level], 1);
    if (level == 0) yk_text_add(json->text, "\n", 1);
}

void yk_json_string(YkJson *json, const char *key, const char *value)
{
    if (!value) {
        yk_json_null(json, key);
        return;
    }
    add_member(json, key);
    add_quoted(json->text, value);
}

void yk_json_number(YkJson *json, const char *key, double value)
{
    if (!isfinite(value)) {
        yk_json_null(json, key);
        return;
    }
    char digits[YK_NUMBER_SIZE];
    add_member(json, key);
    yk_text_add(json->text, digits, yk_number_write(value, digits));
}

void yk_json_integer(YkJson *json, const char *key, long long value)
{
    char digits[24];
    size_t at = sizeof digits;
    unsigned long long rest = value < 0 ? 0ULL - (unsigned long long)value : (unsigned long long)value;
    do {
        digits[--at] = (char)('0' + rest % 10);
        rest /= 10;
    } while (rest);
    if (value < 0) digits[--at] = '-';
    add_member(json, key);
    yk_text_add(json->text, digits + at, sizeof digits - at);
}

void yk_json_bool(YkJson *json, const char *key, bool value)
{
    add_member(json, key);
    yk_text_puts(json->text, value ? "true" : "false");
}

void yk_json_null(YkJson *json, const char *key)
{
    add_member(json, key);
    yk_text_puts(json->text, "null");
}

void yk_json_numbers(YkJson *json, const char *key, const double *values, size_t count)
{
    yk_json_list(json, key, YK_JSON_INLINE);
    for (size_t k = 0; k < count; k++) yk_json_number(json, NULL, values[k]);
    yk_json_end(json);
}
