// From values to statements of C.
#ifndef CODE_PRINT_H
#define CODE_PRINT_H
#include "base/names.h"
#include "base/text.h"
#include "code/program.h"

// The small functions at the head of the file; each is printed if it is used.
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
    // Of the current function:
    bool *marked;
    int32_t *count;     // uses
    const char **local; // its variable, once it has one
    bool *call_done;
    size_t room;      // values there was room for
    bool in_machine;  // prints the machine's own values
    const YkRef *cut; // values that stand for array elements: `known[k]`, sorted; or NULL
    size_t cut_count;
    const char *unknowns; // of the current group: the array that its function takes; or NULL
    YkNames taken;        // names of variables
    int32_t section;
    bool failed;
} YkPrinter;

bool yk_printer_start(YkPrinter *printer, YkProgram *program, const char *prefix, bool single, YkText *out);
void yk_printer_end(YkPrinter *printer);
// Marks what the roots need, for a function that begins here (print.c).
void yk_printer_begin(YkPrinter *printer, const YkRef *roots, size_t count);
// Notes what the values of a pose need of the machine.
void yk_printer_need(YkPrinter *printer, const YkRef *roots, size_t count);
// Prints statements for all that the roots need; then yk_printer_value writes them. Does not use names in `reserved`.
void yk_printer_body(YkPrinter *printer, const YkRef *roots, size_t count);
// print_value.c: writes a value by its variable if it has one; or the value of that variable.
void yk_printer_value(YkPrinter *printer, YkRef value);
void yk_printer_written(YkPrinter *printer, YkRef value);
// Returns whether it needs no statement: a number, a leaf, a value of the machine, an element of `known`.
bool yk_printer_is_given(const YkPrinter *printer, YkRef value);
// Prints the machine's own values: `m.name = ...;`.
void yk_printer_machine(YkPrinter *printer);
void yk_printer_number(YkPrinter *printer, double number);
// Breaks the text from there on into lines of the usual length.
void yk_printer_wrap(YkPrinter *printer, size_t from);
// print_group.c: prints the functions of Newton's method, one for each group that the roots need.
void yk_printer_group(YkPrinter *printer, size_t block);
enum { YK_PRINTER_KNOWN_MAX = 512 };
// Finds the arguments of a group's function, in the order of its array: at most `capacity` to known. Returns their
// count.
size_t yk_printer_group_known(YkPrinter *printer, size_t block, YkRef *known, size_t capacity);

#endif
