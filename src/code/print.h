// From values to statements of C.
#ifndef CODE_PRINT_H
#define CODE_PRINT_H
#include "base/names.h"
#include "base/text.h"
#include "code/program.h"

// Which of the small functions at the head of the file are used.
typedef enum YkHelper {
    YK_HELPER_ROOT,
    YK_HELPER_PER_ROOT,
    YK_HELPER_NONZERO,
    YK_HELPER_LEAST,
    YK_HELPER_LARGEST,
    YK_HELPER_SINCOS,
    YK_HELPER_ANGLE,
    YK_HELPER_NEAREST,
    YK_HELPER_SIGN,
    YK_HELPER_SOLVE,
    YK_HELPER_LAW,
    YK_HELPER_COUNT
} YkHelper;

typedef struct YkPrinter {
    YkProgram *program;
    const char *prefix;
    bool single;
    YkText *out;
    bool uses[YK_HELPER_COUNT];
    const char **field; // per value of parameters that a pose needs: its name in the machine, or NULL
    YkRef *fields;      // in order
    size_t field_count, field_capacity;
    // of the function in work
    bool *marked;
    int32_t *count;     // uses
    const char **local; // its variable, once it has one
    bool *call_done;
    size_t room;      // values there was room for
    bool in_machine;  // prints the machine's own values
    const YkRef *cut; // values that stand for array elements: `known[k]`, sorted; or NULL
    size_t cut_count;
    const char *unknowns; // of the group in work: the array that its function takes; or NULL
    YkNames taken;        // names of variables
    int32_t section;
    bool failed;
} YkPrinter;

bool yk_printer_start(YkPrinter *printer, YkProgram *program, const char *prefix, bool single, YkText *out);
void yk_printer_end(YkPrinter *printer);
// print.c: marks what the roots need, for a function that begins here.
void yk_printer_begin(YkPrinter *printer, const YkRef *roots, size_t count);
// Takes note of what a pose's values need of the machine.
void yk_printer_need(YkPrinter *printer, const YkRef *roots, size_t count);
// Statements for all that the roots need; afterwards yk_printer_value writes them. Names in `reserved` are not used.
void yk_printer_body(YkPrinter *printer, const YkRef *roots, size_t count);
// print_value.c: by its variable, if it has one; or what that variable is set to.
void yk_printer_value(YkPrinter *printer, YkRef value);
void yk_printer_written(YkPrinter *printer, YkRef value);
// Does it stand for itself: a number, a leaf, a value of the machine, an element of `known`?
bool yk_printer_is_given(const YkPrinter *printer, YkRef value);
// The machine's own values: `m.name = ...;`
void yk_printer_machine(YkPrinter *printer);
void yk_printer_number(YkPrinter *printer, double number);
// Breaks what has been written from there on into lines of the usual length.
void yk_printer_wrap(YkPrinter *printer, size_t from);
// group.c: the functions of Newton's method, one a group that the roots need.
void yk_printer_group(YkPrinter *printer, size_t block);
enum { YK_PRINTER_KNOWN_MAX = 512 };
// What a group's function takes from outside, in the order of its array: at most `capacity` to known; returns how many.
size_t yk_printer_group_known(YkPrinter *printer, size_t block, YkRef *known, size_t capacity);

#endif
