// The printed file: its types, its functions, its self-test.
#ifndef CODE_FILE_H
#define CODE_FILE_H
#include <yoke/code.h>
#include "program/forces.h"
#include "graph/print.h"
#include "solve/state.h"

// A result of a function, as a member of its struct.
typedef struct YkResult {
    const char *name, *comment; // comment: unit and meaning
    YkRef value;
    YkChannel channel; // its channel in the engine
} YkResult;

typedef enum YkRoutineKind { YK_ROUTINE_MOTION, YK_ROUTINE_INVERSE, YK_ROUTINE_FORWARD } YkRoutineKind;

// A function of a pose: `PREFIX_find_NAME` fills a struct `PREFIX_NAME`.
typedef struct YkRoutine {
    const char *name, *about;
    YkResult *results;
    size_t count;
    YkRef witness;       // 0 if the inputs that it depends on are finite, except those of loads
    YkRef regular;       // above 0 if its equations have a solution; -1: they always have
    YkRef settled;       // 1 if dry friction agrees with the reactions; -1: there is none
    YkRef moves;         // above 0 if no joint with dry friction is at rest; -1: none has any
    bool checks_results; // results may be infinite at a regular pose
    bool has_designs;    // a batch over parameters too
    YkRoutineKind kind;
} YkRoutine;

enum { YK_ROUTINES_MAX = 5 };

// Up to so many unknowns, the determinant shows how far a system is from singular, as in solve/group.c.
enum { YK_FILE_SMALL_SYSTEM = 4 };

typedef struct YkLeafNote { // of the inputs or the configuration
    const char *name, *comment;
    double value;
    size_t count; // of an array
    bool is_effort;
} YkLeafNote;

typedef struct YkFile {
    YkProgram program;
    YkPrinterFile naming;
    YkPrinter printer;
    YkForces forces;
    bool has_forces, single, is_of_file; // is_of_file: see compile/variant.h
    const char *prefix;
    YkState *state; // assembled at the start
    YkPace *pace;   // of the call
    YkRoutine routines[YK_ROUTINES_MAX];
    size_t routine_count;
    YkLeafNote *inputs, *configuration;
    size_t input_count, configuration_count;
    YkResult *drives; // the values of drives: members of the inputs
    size_t drive_count;
    YkRef *residuals; // loops and relations, then their Jacobian
    size_t residual_count, row_count, coordinate_count;
    YkRef rack_side; // of the parameters: above 0 if every rack is on its side of the pinion; -1: none can leave it
    YkText text;
} YkFile;

// Counts work for the long call that prints the file. Returns false once its caller has stopped it.
static inline bool yk_file_goes_on(YkFile *file, size_t work)
{
    return yk_pace_spend(file->program.graph.pace, work);
}

// struct_members.c: the members of the inputs and the configuration.
bool yk_file_members(YkFile *file);
// routines.c: the routines, drives and residuals as values.
bool yk_file_routines(YkFile *file);
// Returns the roots of a routine's body: its results and the values for its status; NULL when out of memory.
const YkRef *yk_file_roots(YkFile *file, const YkRoutine *routine, size_t *count);
// names.c: chooses program->names for the prefix. Returns false when out of memory.
bool yk_file_choose_names(YkProgram *program);
// words.c: returns whether the name is a word of C or C++, a macro of their headers, a name that they reserve, or one
// of the file's own.
bool yk_file_is_reserved(const YkProgram *program, const char *name);
// Makes a C name that is not reserved: letters, digits and underscores, with `name_` before it if it has to change.
const char *yk_file_name(YkProgram *program, const char *name);
// names.c: gives names to the values of parameters that the poses need.
void yk_program_name_fields(YkProgram *program, YkPrinter *printer);
// Returns the type of printed numbers.
static inline const char *yk_file_real(const YkFile *file)
{
    return file->single ? "float" : "double";
}
// file_types.c: parameters in the struct, which follow from no others.
bool yk_file_is_own(const YkFile *file, size_t parameter);
size_t yk_file_own_parameters(const YkFile *file);
void yk_file_prototype(YkFile *file, const YkRoutine *routine, const char *ending);
void yk_file_prototype_many(YkFile *file, const YkRoutine *routine, bool designs, const char *ending);
// file_coincidence.c: whether a dyad may close with any angle at some pose; the inputs a hair before; the end of
// a kernel, with the bits of such poses in its status; the function that settles them.
bool yk_file_may_coincide(const YkFile *file);
void yk_file_write_before(YkFile *file);
void yk_file_mark_open(YkFile *file);
void yk_file_write_beside(YkFile *file, const YkRoutine *routine);
// Writes the text before, a value, the text after.
void yk_file_line(YkFile *file, const char *before, YkRef value, const char *after);
// file_*.c and their neighbours: the parts of the file, in order.
void yk_file_write_head(YkFile *file);
void yk_file_write_types(YkFile *file);
void yk_file_write_helpers(YkFile *file, const char *body); // those that the body uses
void yk_file_write_laws(YkFile *file);
void yk_file_write_machine(YkFile *file);
void yk_file_write_group(YkFile *file, size_t block); // print_group.c: Newton's method for it
void yk_file_write_routine(YkFile *file, const YkRoutine *routine);
void yk_file_write_drives(YkFile *file);
// print_calls.c, print_group.c: calls in functions (YkPrinterFile).
const char *yk_call_print(YkPrinter *printer, const YkCall *call);
size_t yk_call_known(YkPrinter *printer, const YkCall *call, YkRef *known, size_t capacity);
// residuals.c: as values; their prototype; their function.
bool yk_file_residuals(YkFile *file);
void yk_file_declare_residuals(YkFile *file);
void yk_file_write_residuals(YkFile *file);
void yk_file_write_test(YkFile *file);
// Writes a text with `@` for the prefix, `$` for the type of numbers, `~` for the ending of its functions.
void yk_file_template(YkFile *file, const char *text);

#endif
