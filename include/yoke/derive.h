// Derivations: the machine's equations in symbols, as an engineer would write them by hand, printed for people and
// programs; and proofs that say whether an equation is true for this machine.
#ifndef YOKE_DERIVE_H
#define YOKE_DERIVE_H

#include <yoke/dynamics.h>
#include <yoke/progress.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkDerivation YkDerivation;

// Starts a derivation, with symbols for everything in the model. The model and the mechanism must outlive it. Returns
// NULL with a problem added when out of memory, or if the file's numbers are too large to be exact. Use it in one
// thread at a time. Cost: linear in the number of bodies, some microseconds each; everything else is derived when it is
// first needed.
YK_API YkDerivation *yk_derivation_new(const YkModel *model, const YkMechanism *mech, YkProblems *problems);
YK_API void yk_derivation_free(YkDerivation *derivation);
// Lets `progress` watch the pages and checks that follow (<yoke/progress.h>). After one of them was stopped, the
// derivation cannot be used again: pages return YK_STOPPED, and checks say that the equation could not be read.
YK_API void yk_derivation_set_progress(YkDerivation *derivation, YkProgress progress);

// The sections of a page, in their order: "loops", "jacobian", ...; and the heading of each.
YK_API size_t yk_derivation_section_count(void);
YK_API const char *yk_derivation_section_name(size_t section);
YK_API const char *yk_derivation_section_title(size_t section);
YK_API size_t yk_derivation_section_find(const char *name); // YK_NOT_FOUND if there is none
// Returns whether "all" has the section: a machine without gears has no section on gears, and polygons, which show the
// steps of a construction by hand for what other sections solve, are written on request only.
YK_API bool yk_derivation_has_section(const YkDerivation *derivation, size_t section);

typedef enum YkPageFormat {
    YK_PAGE_TEXT,   // for people, one formula on each line
    YK_PAGE_LATEX,  // a whole document
    YK_PAGE_MATHML, // a whole HTML document
    YK_PAGE_JSON,
    YK_PAGE_C, // one function for each section
    YK_PAGE_FORMATS
} YkPageFormat;
YK_API YkPageFormat yk_page_format_find(const char *name); // "text", "latex", ...; YK_PAGE_FORMATS if there is none

typedef struct YkPageOptions {
    YkPageFormat format;
    const bool *sections; // [yk_derivation_section_count()]: which are wanted; NULL: all that the machine has
    const YkState *state; // puts values at this pose beside the symbols; NULL: symbols alone
    YkDynamics *dynamics; // solved at that pose: values of forces; may be NULL
    // Receives the page while it grows, in pieces of whole lines, so that a large page needs little memory; returns
    // false to end it. With values, and for C, it receives the page only when all of it is there. NULL: the page is
    // kept for yk_derivation_text.
    bool (*write)(void *context, const char *text, size_t length);
    void *context;
} YkPageOptions;
YK_API YkPageOptions yk_default_page_options(void); // text, all sections, no values
// Derives and prints a page. options may be NULL. Returns YK_OK; YK_BAD_MODEL if a section cannot be derived exactly
// (products too long, numbers too large: the problem names it); YK_STOPPED if `write` or the progress ended it;
// YK_NO_MEMORY; YK_BAD_ARGUMENT.
YK_API YkStatus yk_derivation_page(YkDerivation *derivation, const YkPageOptions *options, YkProblems *problems);
YK_API const char *yk_derivation_text(const YkDerivation *derivation); // of the last page; lives until the next

// The kinds of verdict. A verdict rests on several tests: as an identity; by numbers at random poses; exactly, at
// random points of the machine's motion over a prime field; and by numbers on machines with other dimensions.
typedef enum YkCheckKind {
    YK_CHECK_TRUE,        // for all dimensions
    YK_CHECK_TRUE_HERE,   // with this file's numbers; the verdict says what is known about others
    YK_CHECK_TRUE_DRIVEN, // as the drives move the machine; not when inputs move in any other way
    YK_CHECK_FALSE,
    YK_CHECK_UNDECIDED, // no pose could be found, or the numbers are inconclusive
    YK_CHECK_UNREADABLE // a problem says why
} YkCheckKind;
// "true", "true-here", "true-driven", "false", "undecided", "unreadable"
YK_API const char *yk_check_kind_name(YkCheckKind kind);

// Both sides at a pose where they differ.
typedef struct YkCheckShown {
    double left, right;
    int order;          // of the highest derivative of a coordinate in the equation
    const char *forces; // "F12x = 3.25, M03 = -0.5", its unknown forces there, SI; or NULL
    double time;
    bool has_time;             // the equation contains the time
    const char *machine;       // "a = 0.053, b = 0.21", SI: parameters that differ from the file's; NULL: none
    const YkMotion *positions; // [coordinates of the mechanism]; NULL: none
} YkCheckShown;

// Texts live as long as the derivation.
typedef struct YkCheckVerdict {
    YkCheckKind kind;
    bool is_identity;     // true: even if the loops were open
    bool is_in_segment;   // the poses are in the segment of a motion program that the equation is about
    size_t poses;         // number of poses at which both sides were compared
    size_t machines;      // true here: number of machines with other dimensions at which it was compared too
    size_t machine_poses; // number of their poses in all
    const char *varied;   // their parameters that differ from the file's: "a, b"; NULL: none were tried
    const char *kept;     // parameters that could not vary; NULL: none
    bool is_too_large;    // true here: neither a proof nor other machines were tried
    bool is_false_there;  // only true here: `shown` is a machine with other dimensions
    bool is_refuted;      // only true here: by exact arithmetic it does not hold in general for other numbers
    YkCheckShown shown;   // false, or false elsewhere
    const char *slip;     // false: "with the other sign before `d3*cos(theta2)` it would be true"; or NULL
} YkCheckVerdict;

// Decides about "LEFT = RIGHT" in the file's names: theta1' or theta1.rate, lever.angle, tan and quotients are allowed;
// numbers are in SI and radians or have a unit. The state must be assembled; its inputs and pose change, and a false
// equation leaves it at the pose that shows it. dynamics, for equations with forces, may be NULL.
YK_API YkCheckVerdict yk_derivation_check(YkDerivation *derivation, YkState *state, YkDynamics *dynamics,
                                          const char *equation, YkProblems *problems);

#ifdef __cplusplus
}
#endif

#endif
