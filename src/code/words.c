// Words that a name of the model must not be: those of C, C++ and their headers, and the printed file's own.
#include <string.h>
#include "base/letters.h"
#include "code/file.h"

// Lists of words, separated by blanks.

// Keywords of C11, C23 and C++23, with the words that GNU C adds.
static const char keywords[] =
    "alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t char32_t char8_t class "
    "co_await "
    "co_return co_yield compl concept const const_cast consteval constexpr constinit continue contract_assert decltype "
    "default delete do double dynamic_cast else enum explicit export extern false float for friend goto if inline int "
    "long "
    "mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public register "
    "reinterpret_cast requires restrict return short signed sizeof static static_assert static_cast struct switch "
    "template "
    "this thread_local throw true try typedef typeid typename typeof typeof_unqual union unsigned using virtual void "
    "volatile wchar_t while xor xor_eq";

// Macros of <stddef.h>, <math.h>, <stdint.h>, <string.h>, <stdio.h> and the headers that they include, on any system;
// names that compilers define themselves. Those that begin with an underscore have a rule of their own.
static const char macros[] =
    "BIG_ENDIAN BUFSIZ BYTE_ORDER DOMAIN EOF EXIT_FAILURE EXIT_SUCCESS HUGE INFINITY LITTLE_ENDIAN L_ctermid L_cuserid "
    "L_tmpnam MATH_ERREXCEPT MATH_ERRNO MAXFLOAT NAN NFDBITS NULL OVERFLOW PDP_ENDIAN PLOSS P_tmpdir SING TLOSS "
    "UNDERFLOW "
    "WCONTINUED WEXITED WNOHANG WNOWAIT WSTOPPED WUNTRACED X_TLOSS alloca assert complex errno hpux i386 imaginary "
    "linux "
    "m68k math_errhandling mips noreturn offsetof signgam sparc stderr stdin stdout sun unix vax";
// Families of macros by their beginnings: M_PI_2f128, FP_NAN; limits of types by their ends too: UINT_LEAST8_MAX.
static const char macro_beginnings[] =
    "DBL_ FD_ FLT_ FP_ HUGE_VAL LDBL_ M_1_PI M_2_PI M_2_SQRT M_E M_LN M_LOG M_PI M_SQRT RENAME_ SEEK_ SNAN";
static const char limit_beginnings[] = "BOOL_ CHAR_ FILENAME_ FOPEN_ INT LLONG_ LONG_ MB_CUR_ PTRDIFF_ RAND_ SCHAR_ "
                                       "SHRT_ SIG_ATOMIC_ SIZE_ TMP_ UCHAR_ UINT "
                                       "ULLONG_ ULONG_ USHRT_ WCHAR_ WINT_";
static const char limit_endings[] = "_MAX _MIN _WIDTH";

// Names of the printed file's own things, after its prefix; macros are in upper case.
static const char own_words[] =
    "accelerations angle before configuration defaults differ drives efforts equations inputs largest least machine "
    "motion "
    "nearest nonzero parameters per_root piece points prepare prepared reactions residuals root sign sincos start "
    "status";
static const char own_beginnings[] = "find_ law_ loops_ solve_ test_";
static const char own_endings[] = "_arrays _beside _of";

typedef enum Part { WHOLE, BEGINNING, ENDING } Part; // the part of the name that a word is compared with

static bool is_among(const char *name, Part part, const char *words)
{
    size_t length = strlen(name);
    for (const char *word = words; *word; word += strspn(word, " ")) {
        size_t own = strcspn(word, " ");
        const char *place = part == ENDING && own <= length ? name + length - own : name;
        if (own <= length && (part != WHOLE || own == length) && strncmp(word, place, own) == 0) return true;
        word += own;
    }
    return false;
}

static bool is_upper_case(const char *name)
{
    for (const char *c = name; *c; c++)
        if (*c >= 'a' && *c <= 'z') return false;
    return true;
}

// C reserves a leading underscore, C++ two of them anywhere; an ending after a final one would make two.
static bool has_odd_underscores(const char *name)
{
    size_t length = strlen(name);
    return length == 0 || name[0] == '_' || name[length - 1] == '_' || strstr(name, "__");
}

static bool is_macro(const char *name)
{
    return is_among(name, WHOLE, macros) || is_among(name, BEGINNING, macro_beginnings) ||
           (is_among(name, BEGINNING, limit_beginnings) && is_among(name, ENDING, limit_endings));
}

// Returns whether it is a macro, a type or a function of the printed file's own.
static bool is_own(const YkProgram *p, const char *name)
{
    size_t length = strlen(p->prefix);
    if (strncmp(name, p->prefix, length) != 0 || name[length] != '_') return false;
    const char *rest = name + length + 1;
    return is_upper_case(rest) || is_among(rest, WHOLE, own_words) || is_among(rest, BEGINNING, own_beginnings) ||
           is_among(rest, ENDING, own_endings);
}

bool yk_file_is_reserved(const YkProgram *p, const char *name)
{
    return has_odd_underscores(name) || is_among(name, WHOLE, keywords) || is_macro(name) || is_own(p, name);
}

// Writes one underscore for each run of characters that are not letters or digits, none at the ends.
static void tidy(char *name)
{
    char *to = name;
    for (const char *c = name; *c; c++) {
        if (yk_is_letter(*c) || yk_is_digit(*c))
            *to++ = *c;
        else if (to > name && to[-1] != '_')
            *to++ = '_';
    }
    while (to > name && to[-1] == '_') to--;
    *to = 0;
}

const char *yk_file_name(YkProgram *p, const char *name)
{
    char *copy = yk_graph_text(&p->graph, "%s", name);
    for (char *c = copy; *c; c++)
        if (!yk_is_letter(*c) && !yk_is_digit(*c)) *c = '_';
    if (!yk_is_digit(copy[0]) && !yk_file_is_reserved(p, copy)) return copy;
    tidy(copy);
    return yk_graph_text(&p->graph, "name_%s", *copy ? copy : "0");
}
