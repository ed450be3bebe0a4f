// The same model with other values of some parameters, again and again: a copy whose values follow them.
//
// Only what depends on the parameters is evaluated anew, by formulas made once. Points, directions of slides, masses,
// gravity, springs, dampers, stops and friction follow; what enters wheels, cams, laws or a joint's constant angle
// `turned` is refused, since there more than values would change.
#ifndef MODEL_REDESIGN_H
#define MODEL_REDESIGN_H
#include "expr/formula.h"
#include "model/model.h"

typedef struct YkRedesign YkRedesign;

// names[count]: parameters of the model, which must outlive this. NULL with problems added: an unknown name, one that
// enters what cannot follow, a name twice, out of memory.
YkRedesign *yk_redesign_new(const YkModel *model, const char *const *names, size_t count, YkProblems *problems);
void yk_redesign_free(YkRedesign *redesign);
void yk_redesign_hint(YkProblems *problems);      // of a problem that says what cannot follow
YkModel *yk_redesign_model(YkRedesign *redesign); // the copy; valid until freed
// values[count], SI, into the copy. YK_OK; YK_BAD_MODEL where the machine makes no sense with them: a value is not
// finite or beyond 1e100, a mass is not positive, an inertia negative, a rod without length, a restitution or friction
// out of range. Cost: of the formulas; allocates nothing.
YkStatus yk_redesign_set(YkRedesign *redesign, const double *values);
double yk_redesign_value(const YkRedesign *redesign, size_t index); // of names[index], as set last

// What follows, for whoever keeps numbers derived from the model.
bool yk_redesign_point_varies(const YkRedesign *redesign, int32_t point); // YK_NONE: an origin, which does not
bool yk_redesign_along_varies(const YkRedesign *redesign, int32_t joint);
// The formula that gives a value of the copy, over the parameters by their index in the model; NULL where it is
// constant.
const YkFormula *yk_redesign_formula(const YkRedesign *redesign, const double *value);
// The same of a parameter that depends on those that vary; in the order in which they must be evaluated. Returns its
// index; YK_NONE past the last.
int32_t yk_redesign_derived(const YkRedesign *redesign, size_t k, const YkFormula **formula);
// An expression of parameters alone as such a formula; NULL where it needs more, or when out of memory.
const YkFormula *yk_redesign_compile(YkRedesign *redesign, const YkExpr *expr);
bool yk_redesign_expression_varies(const YkRedesign *redesign, const YkExpr *expr); // NULL: no
int32_t yk_redesign_parameter(const YkRedesign *redesign, size_t k);                // index in the model of names[k]

#endif
