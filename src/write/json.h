// Writes JSON: nested objects and lists, written as they come; no tree, no NaN, the same bytes every time.
#ifndef WRITE_JSON_H
#define WRITE_JSON_H
#include "base/text.h"

enum { YK_JSON_DEPTH = 32 };

// The layout of an object or a list: one member per line, or all on one line (including everything inside).
typedef enum YkLayout { YK_JSON_LINES, YK_JSON_INLINE } YkLayout;

// A zeroed writer with `text` set is ready.
typedef struct YkJson {
    YkText *text;
    int depth;                       // open objects and lists
    bool has_members[YK_JSON_DEPTH]; // per open level: a comma is due
    bool is_inline[YK_JSON_DEPTH];
    char closing[YK_JSON_DEPTH]; // '}' or ']'
} YkJson;

// Every call takes the member's key, or NULL inside a list and at the top.
void yk_json_object(YkJson *json, const char *key, YkLayout layout);
void yk_json_list(YkJson *json, const char *key, YkLayout layout);
void yk_json_end(YkJson *json); // closes the innermost object or list; after the outermost one, a final newline
void yk_json_string(YkJson *json, const char *key, const char *value); // NULL is written as null
void yk_json_number(YkJson *json, const char *key, double value);      // shortest that reads back; null unless finite
void yk_json_integer(YkJson *json, const char *key, long long value);
void yk_json_bool(YkJson *json, const char *key, bool value);
void yk_json_null(YkJson *json, const char *key);
void yk_json_numbers(YkJson *json, const char *key, const double *values, size_t count); // a list on one line

#endif
