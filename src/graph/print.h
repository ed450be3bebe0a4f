// From values to statements of C.
#ifndef GRAPH_PRINT_H
#define GRAPH_PRINT_H
#include "base/names.h"
#include "base/text.h"
#include "graph/graph.h"

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
    YK_HELPER_FRICTION,
    YK_HELPER_MOTION,
    YK_HELPER_SINE,
    YK_HELPER_COUNT
} YkHelper;

typedef struct YkPrinter YkPrinter;
enum { YK_PRINTER_KNOWN_MAX = 512 };

// The file around the printed functions: its names, its calls.
typedef struct YkPrinterFile {
    void *context;
    const char *parameter, *own_parameter; // before a parameter's name: in a pose; where the machine is computed
    const char *machine;                   // before the name of one of the machine's values there
    // Returns a name like the wish that the file may have for a variable. NULL: all names are free.
    const char *(*name)(void *context, const char *wish);
    // For graphs with calls. Prints the statements of one; returns the array with its results.
    const char *(*call)(YkPrinter *printer, const YkCall *call);
    // Writes what a call takes besides its arguments, at most `capacity`, to known. Returns how many; fails if
    // there are more.
    size_t (*call_known)(YkPrinter *printer, const YkCall *call, YkRef *known, size_t capacity);
} YkPrinterFile;

struct YkPrinter {
    YkGraph *graph;
    const YkPrinterFile *file;
    const char *prefix; // of the helpers
    bool single;
    YkText *out;
    bool uses[YK_HELPER_COUNT];
    const char **field; // per value of parameters that a pose needs: its name in the machine, or NULL
    YkRef *fields;      // in order
    size_t field_count, field_capacity;
    // The current function's:
    bool *marked;
    int32_t *count;     // uses
    const char **local; // its variable, once it has one
    bool *call_done;
    size_t room;      // values there was room for
    bool in_machine;  // prints the machine's own values
    const YkRef *cut; // values that stand for array elements: `known[k]`; or NULL
    size_t cut_count;
    const YkRef *written; // leaves that the current function sets in the end: it reads them first
    size_t written_count;
    const char *unknowns; // of the current group: the array that its function takes; or NULL
    YkNames taken;        // names of variables
    int32_t section;
    bool failed;
};

static inline const YkValue *yk_printer_at(const YkPrinter *printer, YkRef value)
{
    return &printer->graph->values[value];
}
static inline const char *yk_printer_real(const YkPrinter *printer)
{
    return printer->single ? "float" : "double";
}

// The graph must be complete. Returns false when out of memory; the printer must be ended then, too.
bool yk_printer_start(YkPrinter *printer, YkGraph *graph, const YkPrinterFile *file, const char *prefix, bool single,
                      YkText *out);
void yk_printer_end(YkPrinter *printer);
// Marks what the roots need, for a function that begins here (print.c).
void yk_printer_begin(YkPrinter *printer, const YkRef *roots, size_t count);
// Notes what the values of a pose need of the machine.
void yk_printer_need(YkPrinter *printer, const YkRef *roots, size_t count);
// Prints statements for all that the roots need; then yk_printer_value writes them.
void yk_printer_body(YkPrinter *printer, const YkRef *roots, size_t count);
// Returns a name for a variable that nothing else in the function has.
const char *yk_printer_unique(YkPrinter *printer, const char *wish);
// Declares an array with these values at its start.
void yk_printer_array(YkPrinter *printer, const char *name, const YkRef *values, size_t count, size_t size);
// print_value.c: writes a value by its variable if it has one; or the value of that variable.
void yk_printer_value(YkPrinter *printer, YkRef value);
void yk_printer_written(YkPrinter *printer, YkRef value);
// Returns whether it needs no statement: a number, a leaf, a value of the machine, an element of `known`.
bool yk_printer_is_given(const YkPrinter *printer, YkRef value);
// print_statements.c: prints the machine's own values, `machine.name = ...;`, those that were needed and have names by
// now.
void yk_printer_machine(YkPrinter *printer);
void yk_printer_number(YkPrinter *printer, double number);
// Breaks the text from there on into lines of the usual length.
void yk_printer_wrap(YkPrinter *printer, size_t from);
#endif
