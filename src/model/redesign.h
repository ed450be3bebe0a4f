// The same model with other values of some parameters, set repeatedly: a copy whose values follow them.
//
// Only values that depend on the parameters are evaluated anew, by formulas made once. Points, directions of slides,
// masses, gravity, springs, dampers, stops and friction follow. A parameter that enters wheels, cams, laws or a joint's
// constant angle `turned` is refused, since more than values would change there.
#ifndef MODEL_REDESIGN_H
#define MODEL_REDESIGN_H
#include "expr/formula.h"
#include "model/model.h"

typedef struct YkRedesign YkRedesign;

// dependents.c: returns whether an expression (may be NULL) depends on parameters that vary; marks the parameters that
// depend on some which do. varies[parameter].
bool yk_model_depends(const YkModel *model, const bool *varies, const YkExpr *expr);
void yk_model_mark_dependents(const YkModel *model, bool *varies);

// Makes a copy for names[count], parameters of the model, which must outlive the copy. Returns NULL with problems
// added: an unknown name, one that enters something that cannot follow, a name given twice, out of memory.
YkRedesign *yk_redesign_new(const YkModel *model, const char *const *names, size_t count, YkProblems *problems);
void yk_redesign_free(YkRedesign *redesign);
void yk_redesign_hint(YkProblems *problems);      // adds a hint to a problem that says what cannot follow
YkModel *yk_redesign_model(YkRedesign *redesign); // the copy; valid until freed
// Sets values[count], SI, in the copy. Returns YK_OK; YK_BAD_MODEL if the machine makes no sense with them: a value is
// not finite or beyond 1e100, a mass is not positive, an inertia or a spring's free length negative, a rod without
// length, a stop's range empty, a restitution or friction out of range, a rack's line on the other side of its pinion.
// Cost: that of the formulas; allocates nothing.
YkStatus yk_redesign_set(YkRedesign *redesign, const double *values);
double yk_redesign_value(const YkRedesign *redesign, size_t index); // the value of names[index], as last set

bool yk_redesign_varies(const YkRedesign *redesign, int32_t parameter); // of the model: chosen, or derived from such
double yk_redesign_now(const YkRedesign *redesign, int32_t parameter);  // its value, as last set
size_t yk_redesign_count(const YkRedesign *redesign);                   // of names[]
const double *yk_redesign_values(const YkRedesign *redesign);           // [parameter]: all of them

// The numbers that vary, for callers that keep others derived from the model.
bool yk_redesign_point_varies(const YkRedesign *redesign, int32_t point); // YK_NONE: an origin, which does not vary
bool yk_redesign_along_varies(const YkRedesign *redesign, int32_t joint);
// Returns the formula for a value of the copy, over the parameters by their index in the model; NULL if it is constant.
const YkFormula *yk_redesign_formula(const YkRedesign *redesign, const double *value);
// Returns the formula of a parameter that depends on varying ones, in the order in which they must be evaluated.
// Returns its index; YK_NONE past the last.
int32_t yk_redesign_derived(const YkRedesign *redesign, size_t k, const YkFormula **formula);
// Compiles an expression of parameters alone into such a formula; NULL if it needs more, or when out of memory.
const YkFormula *yk_redesign_compile(YkRedesign *redesign, const YkExpr *expr);
bool yk_redesign_ran_out(const YkRedesign *redesign);                               // of memory, at any time
bool yk_redesign_expression_varies(const YkRedesign *redesign, const YkExpr *expr); // false for NULL
int32_t yk_redesign_parameter(const YkRedesign *redesign, size_t k); // the index of names[k] in the model

#endif
