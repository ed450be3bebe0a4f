// Writes the small functions at the head of the printed file, and its laws.
#include <string.h>
#include "code/file.h"
#include "law/inside.h"

void yk_file_template(YkFile *file, const char *text)
{
    for (const char *c = text; *c; c++) {
        if (*c == '@')
            yk_text_puts(&file->text, file->prefix);
        else if (*c == '$')
            yk_text_puts(&file->text, yk_file_real(file));
        else if (*c == '~')
            yk_text_puts(&file->text, file->single ? "f" : "");
        else
            yk_text_add(&file->text, c, 1);
    }
}

static const char double_sincos[] =
    "/* sin and cos without branches, so that loops over poses vectorise; errors below 2e-16 for |x| <= 1e5 rad, NaN "
    "beyond.\n"
    "   Reduction after Cody and Waite 1980 in two parts of pi/2; the published minimax coefficients of fdlibm. */\n"
    "@_INLINE void @_sincos(double x, double *sine, double *cosine)\n"
    "{\n"
    "    const double to_integer = 6755399441055744.0; /* 1.5 * 2^52: adding it rounds to an integer */\n"
    "    const double shifted = x * 0.63661977236758134308 + to_integer, k = shifted - to_integer;\n"
    "    const double beyond = 0 * (x * 1.7976931348623157e303); /* NaN where the product has no finite value */\n"
    "    const double y = (x - k * 0x1.921fb5444p+0) - k * 0x1.68c234c4c6629p-39 + beyond, y2 = y * y, y4 = y2 * y2;\n"
    "    const double a = (8.33333333332248946124e-03 + y2 * -1.98412698298579493134e-04) +\n"
    "        y4 * ((2.75573137070700676789e-06 + y2 * -2.50507602534068634195e-08) + y4 * "
    "1.58969099521155010221e-10);\n"
    "    const double b = (4.16666666666666019037e-02 + y2 * -1.38888888888741095749e-03) +\n"
    "        y4 * ((2.48015872894767294178e-05 + y2 * -2.75573143513906633035e-07) +\n"
    "              y4 * (2.08757232129817482790e-09 + y2 * -1.13596475577881948265e-11));\n"
    "    const double s = y - y2 * y * (1.66666666666666324348e-01 - y2 * a), c = (1 - 0.5 * y2) + y4 * b;\n"
    "    uint64_t quarter;\n"
    "    memcpy(&quarter, &shifted, sizeof quarter);\n"
    "    const double first = (quarter & 1) != 0 ? c : s, second = (quarter & 1) != 0 ? s : c;\n"
    "    *sine = (quarter & 2) != 0 ? -first : first;\n"
    "    *cosine = ((quarter + 1) & 2) != 0 ? -second : second;\n"
    "}\n\n";

static const char double_angle[] =
    "/* The angle of the unit vector (x, y), in [-pi, pi], without branches: the arc sine of the smaller component, or "
    "after\n"
    "   a turn by 45 degrees, unfolded by octants. */\n"
    "@_INLINE double @_angle(double y, double x)\n"
    "{\n"
    "    const double ax = fabs(x), ay = fabs(y), large = ay < ax ? ax : ay, small = ax < ay ? ax : ay;\n"
    "    const int is_steep = ay > ax, is_turned = small > 0.38268343236508977;\n"
    "    const double s = is_turned ? (small - large) * 0.70710678118654752 : small;\n"
    "    const double t = s * s, t2 = t * t, t4 = t2 * t2;\n"
    "    const double low = (%a + t * %b) +\n        t2 * (%c + t * %d);\n"
    "    const double high = (%e + t * %f) +\n        t2 * (%g + t * %h) +\n"
    "        t4 * (%i + t * %j);\n"
    "    const double arc = s + s * t * (low + t4 * high) + (is_turned ? 0.78539816339744831 : 0.0);\n"
    "    const double up = is_steep ? 1.57079632679489662 - arc : arc;\n"
    "    return copysign(x < 0 ? 3.14159265358979324 - up : up, y);\n"
    "}\n\n";

// The fit of tools/fit_arc_sine.py, as in elementary/arc.h.
static const double arc_sine[] = {
    0x1.5555555555551p-3, 0x1.3333333336355p-4, 0x1.6db6db686fa77p-5, 0x1.f1c720069f276p-6, 0x1.6e8b0584c52f7p-6,
    0x1.1c5e3631be7bap-6, 0x1.c7c4cfc8b4203p-7, 0x1.8b8504ee7d538p-7, 0x1.c5cefdf0254adp-8, 0x1.0dd281af8550ep-6};

static void write_double_angle(YkFile *file)
{
    YkText filled = {0};
    for (const char *c = double_angle; *c; c++) {
        if (*c == '%') {
            yk_text_format(&filled, "%g", arc_sine[*++c - 'a']);
        } else {
            yk_text_add(&filled, c, 1);
        }
    }
    yk_file_template(file, yk_text_get(&filled));
    yk_text_free(&filled);
}

static const char equations[] =
    "/* Linear equations: a[n][n + m], m right sides behind the matrix, are solved in their places, by elimination "
    "with row\n"
    "   pivots; returns the determinant over the lengths of the columns, 0 where there is no solution. */\n"
    "static $ @_equations(int n, int m, $ *a)\n"
    "{\n"
    "    const int w = n + m;\n"
    "    $ determinant = 1;\n"
    "    for (int k = 0; k < n; k++) {\n"
    "        $ length = 0;\n"
    "        for (int i = 0; i < n; i++) length += a[i * w + k] * a[i * w + k];\n"
    "        determinant /= sqrt~(length);\n"
    "    }\n"
    "    for (int k = 0; k < n; k++) {\n"
    "        int best = k;\n"
    "        for (int i = k + 1; i < n; i++)\n"
    "            if (fabs~(a[i * w + k]) > fabs~(a[best * w + k])) best = i;\n"
    "        if (a[best * w + k] == 0) return 0;\n"
    "        for (int j = 0; best != k && j < w; j++) {\n"
    "            const $ other = a[k * w + j];\n"
    "            a[k * w + j] = a[best * w + j];\n"
    "            a[best * w + j] = other;\n"
    "        }\n"
    "        if (best != k) determinant = -determinant;\n"
    "        determinant *= a[k * w + k];\n"
    "        for (int i = k + 1; i < n; i++) {\n"
    "            const $ factor = a[i * w + k] / a[k * w + k];\n"
    "            if (factor == 0) continue;\n"
    "            for (int j = k + 1; j < w; j++) a[i * w + j] -= factor * a[k * w + j];\n"
    "        }\n"
    "    }\n"
    "    for (int k = n - 1; k >= 0; k--)\n"
    "        for (int j = n; j < w; j++) {\n"
    "            for (int i = k + 1; i < n; i++) a[k * w + j] -= a[k * w + i] * a[i * w + j];\n"
    "            a[k * w + j] /= a[k * w + k];\n"
    "        }\n"
    "    return determinant;\n"
    "}\n\n";

static const char sine[] =
    "/* In larger systems a determinant, a product of sines, is small even if none of them is. Returns in its place "
    "the\n"
    "   least sine of the angle between a column and all others, with its sign: 1 over the lengths of a column and of "
    "its\n"
    "   row of the inverse. From what @_equations leaves in a[n][w]; b[n] to work with. */\n"
    "static $ @_sine(int n, int w, const $ *a, $ *b, $ determinant)\n"
    "{\n"
    "    $ most = 0;\n"
    "    if (!(determinant != 0 && fabs~(determinant) < 0.01~)) return determinant;\n"
    "    for (int j = 0; j < n; j++) {\n"
    "        $ row = 0, column = 0;\n"
    "        for (int i = 0; i < n; i++) {\n"
    "            $ sum = 0, entry = i <= j ? a[i * w + j] : 0;\n"
    "            for (int k = 0; k < i; k++) sum += a[k * w + i] * b[k];\n"
    "            for (int k = 0; k < i && k <= j; k++) entry += a[i * w + k] / a[k * w + k] * a[k * w + j];\n"
    "            b[i] = ((i == j ? 1 : 0) - sum) / a[i * w + i];\n"
    "            column += entry * entry;\n"
    "        }\n"
    "        for (int i = n - 1; i >= 0; i--) {\n"
    "            for (int k = i + 1; k < n; k++) b[i] -= a[k * w + i] / a[i * w + i] * b[k];\n"
    "            row += b[i] * b[i];\n"
    "        }\n"
    "        if (!(row * column <= most)) most = row * column;\n"
    "    }\n"
    "    const $ least = 1 / sqrt~(most);\n"
    "    if (!(least > fabs~(determinant))) return determinant;\n"
    "    return determinant < 0 ? -least : least;\n"
    "}\n\n";

static const char motion[] =
    "/* Solves symmetric equations of motion, a[n][n + 1] with the right side in the last column, in place by L D "
    "L^T.\n"
    "   Returns the least ratio of a pivot to the terms of the energy that it is the sum of, or 0 if a pivot is not\n"
    "   positive. Behind the equations, a has n + 1 more places to work with. */\n"
    "static $ @_motion(int n, $ *a)\n"
    "{\n"
    "    const int w = n + 1;\n"
    "    $ *whole = a + n * w + 1, least = 1;\n"
    "    for (int k = 0; k < n; k++) {\n"
    "        $ pivot = a[k * w + k], terms = pivot;\n"
    "        whole[k] = pivot;\n"
    "        for (int i = 0; i < k; i++) { /* above the diagonal L D, below it L */\n"
    "            $ rest = a[k * w + i];\n"
    "            for (int j = 0; j < i; j++) rest -= a[i * w + j] * a[j * w + k];\n"
    "            a[i * w + k] = rest;\n"
    "            a[k * w + i] = rest / a[i * w + i];\n"
    "            pivot -= rest * a[k * w + i];\n"
    "            a[k * w + n] -= a[k * w + i] * a[i * w + n];\n"
    "        }\n"
    "        for (int i = k - 1; i >= 0; i--) { /* how coordinate i answers a unit of k */\n"
    "            $ answer = -a[k * w + i];\n"
    "            for (int j = i + 1; j < k; j++) answer -= a[j * w + i] * a[j * w + k];\n"
    "            a[i * w + k] = answer;\n"
    "            terms += answer * answer * whole[i];\n"
    "        }\n"
    "        if (!(pivot > 0)) return 0;\n"
    "        a[k * w + k] = pivot;\n"
    "        if (pivot < least * terms) least = pivot / terms;\n"
    "    }\n"
    "    for (int k = n - 1; k >= 0; k--) {\n"
    "        a[k * w + n] /= a[k * w + k];\n"
    "        for (int i = k + 1; i < n; i++) a[k * w + n] -= a[i * w + k] * a[i * w + n];\n"
    "    }\n"
    "    return least;\n"
    "}\n\n";

static const char friction[] =
    "/* Dry friction: x_k = a_k |V_k + W_k x|, from n rows a_k, V_k, W_k of plane vectors; the first m are forces of "
    "teeth, "
    "which\n"
    "   follow from the others. Found by repetition, in half steps after a while. Returns 1 once they agree, 0 where "
    "they\n"
    "   never do: the joints jam. x has n places more to work with. */\n"
    "static $ @_friction(int n, int m, const $ *rows, $ *x)\n"
    "{\n"
    "    const int w = 3 + 2 * n;\n"
    "    $ whole = 0;\n"
    "    for (int k = 0; k < n * w; k++) whole += 0 * rows[k];\n"
    "    for (int k = 0; k < n; k++) x[k] = whole; /* 0, or NaN where a load is not finite */\n"
    "    for (int round = 0; round < 400 && whole == 0; round++) {\n"
    "        const $ share = round < 100 ? 1 : 0.5~, tolerance = round < 100 ? %t;\n"
    "        int agree = 1;\n"
    "        for (int k = 0; k < n; k++) {\n"
    "            const $ *r = rows + k * w;\n"
    "            $ along = r[1], across = r[2];\n"
    "            for (int i = 0; i < n; i++) {\n"
    "                along += r[3 + 2 * i] * x[i];\n"
    "                across += r[4 + 2 * i] * x[i];\n"
    "            }\n"
    "            x[n + k] = r[0] * sqrt~(along * along + across * across);\n"
    "            if (k < m) x[k] = x[n + k];\n"
    "        }\n"
    "        for (int k = m; k < n; k++) {\n"
    "            const $ step = x[n + k] - x[k], sum = fabs~(x[n + k]) + fabs~(x[k]);\n"
    "            agree = agree && sum < INFINITY && fabs~(step) <= tolerance * sum; /* an infinite one jams, too */\n"
    "            x[k] += share * step;\n"
    "        }\n"
    "        if (agree) return 1;\n"
    "    }\n"
    "    return whole == 0 ? 0 : 1;\n"
    "}\n\n";

static void write_friction(YkFile *file)
{
    const char *rest = strstr(friction, "%t");
    YkText filled = {0};
    yk_text_add(&filled, friction, (size_t)(rest - friction));
    yk_text_puts(&filled, file->single ? "1e-6f : 1e-5f" : "1e-13 : 1e-10");
    yk_text_puts(&filled, rest + 2);
    yk_file_template(file, yk_text_get(&filled));
    file->text.failed |= filled.failed;
    yk_text_free(&filled);
}

static const char piece[] =
    "/* A piece of a law: sum c_k T_k(u) + sum amplitude cos(frequency u + phase), u = (x - middle) scale; its value "
    "and two\n"
    "   derivatives by x. */\n"
    "static void @_piece(const $ *c, int terms, int waves, $ u, $ scale, $ *d)\n"
    "{\n"
    "    $ b[3] = {0}, b2[3] = {0};\n"
    "    for (int k = terms - 1; k > 0; k--) { /* Clenshaw's recurrence and its derivatives */\n"
    "        const $ next[3] = {c[k] + 2 * u * b[0] - b2[0], 2 * b[0] + 2 * u * b[1] - b2[1], 4 * b[1] + 2 * u * b[2] "
    "- b2[2]};\n"
    "        for (int i = 0; i < 3; i++) {\n"
    "            b2[i] = b[i];\n"
    "            b[i] = next[i];\n"
    "        }\n"
    "    }\n"
    "    d[0] = u * b[0] - b2[0] + (terms > 0 ? c[0] : 0);\n"
    "    d[1] = b[0] + u * b[1] - b2[1];\n"
    "    d[2] = 2 * b[1] + u * b[2] - b2[2];\n"
    "    for (int k = 0; k < waves; k++) {\n"
    "        const $ *wave = c + terms + 3 * k, angle = wave[1] * u + wave[2];\n"
    "        d[0] += wave[0] * cos~(angle);\n"
    "        d[1] -= wave[0] * wave[1] * sin~(angle);\n"
    "        d[2] -= wave[0] * wave[1] * wave[1] * cos~(angle);\n"
    "    }\n"
    "    d[1] *= scale;\n"
    "    d[2] *= scale * scale;\n"
    "}\n\n";

void yk_file_write_helpers(YkFile *file, const char *body)
{
    const bool *uses = file->printer.uses;
    (void)body;
    if (uses[YK_HELPER_ROOT]) yk_file_template(file, "@_INLINE $ @_root($ a) { return sqrt~(a > 0 ? a : 0); }\n\n");
    if (uses[YK_HELPER_PER_ROOT])
        yk_file_template(
            file,
            file->single
                ? "@_INLINE $ @_per_root($ a) { return 1 / sqrtf(a > 1e-30f ? a : 1e-30f); }\n\n"
                : "/* 1 / sqrt(a): an estimate in single precision, and Newton's method twice. In loops it takes half\n"
                  "   the time of a root and a division. Where a is beyond 1e38, NaN. */\n"
                  "@_INLINE double @_per_root(double a)\n{\n"
                  "    const double b = a < 1e-36 ? 1e-36 : a, h = 0.5 * b;\n"
                  "    const double x = (double)(1.0f / sqrtf((float)b)), y = x * (1.5 - h * x * x);\n"
                  "    return y * (1.5 - h * y * y) + 0 * (b * 1.7976931348623157e270);\n}\n\n");
    if (uses[YK_HELPER_NONZERO])
        yk_file_template(file, file->single ? "@_INLINE $ @_nonzero($ a) { return fabs~(a) + 1e-30f; }\n\n"
                                            : "@_INLINE $ @_nonzero($ a) { return fabs~(a) + 1e-200; }\n\n");
    if (uses[YK_HELPER_LEAST]) yk_file_template(file, "@_INLINE $ @_least($ a, $ b) { return a < b ? a : b; }\n\n");
    if (uses[YK_HELPER_LARGEST]) yk_file_template(file, "@_INLINE $ @_largest($ a, $ b) { return b < a ? a : b; }\n\n");
    if (uses[YK_HELPER_SIGN]) yk_file_template(file, "@_INLINE $ @_sign($ a) { return ($)(a > 0) - ($)(a < 0); }\n\n");
    if (uses[YK_HELPER_SINCOS]) {
        if (file->single)
            yk_file_template(file, "@_INLINE void @_sincos($ x, $ *sine, $ *cosine)\n{\n    *sine = sinf(x);\n"
                                   "    *cosine = cosf(x);\n}\n\n");
        else
            yk_file_template(file, double_sincos);
    }
    if (uses[YK_HELPER_ANGLE]) {
        if (file->single)
            yk_file_template(file, "@_INLINE $ @_angle($ y, $ x) { return atan2f(y, x); }\n\n");
        else
            write_double_angle(file);
    }
    if (uses[YK_HELPER_NEAREST])
        yk_file_template(
            file,
            file->single
                ? "/* The angle, less the turns that bring it nearest to another. */\n"
                  "@_INLINE $ @_nearest($ a, $ to) { return a - 6.28318531f * rintf((a - to) * 0.159154943f); }\n\n"
                : "/* The angle, less the turns that bring it nearest to another. */\n"
                  "@_INLINE $ @_nearest($ a, $ to)\n{\n"
                  "    const double to_integer = 6755399441055744.0;\n"
                  "    const double turns = ((a - to) * 0.15915494309189535 + to_integer) - to_integer;\n"
                  "    return a - turns * 6.283185307179586;\n}\n\n");
    if (uses[YK_HELPER_SOLVE]) yk_file_template(file, equations);
    if (uses[YK_HELPER_SINE]) yk_file_template(file, sine);
    if (uses[YK_HELPER_MOTION]) yk_file_template(file, motion);
    if (uses[YK_HELPER_FRICTION]) write_friction(file);
    if (uses[YK_HELPER_LAW]) {
        yk_file_template(file, piece);
        yk_file_write_laws(file);
    }
}

// --- laws

static void write_numbers(YkFile *file, const double *numbers, size_t count)
{
    YkText *out = &file->text;
    for (size_t k = 0; k < count; k++) {
        yk_text_puts(out, k == 0 ? "" : k % 5 == 0 ? ",\n        " : ", ");
        yk_printer_number(&file->printer, numbers[k]);
    }
}

static void write_law(YkFile *file, const char *name, const YkLaw *law)
{
    YkText *out = &file->text;
    YkPrinter *pr = &file->printer;
    const char *real = yk_file_real(file);
    yk_text_format(out, "/* The law %s: value and two derivatives. */\nstatic void %s_law_%s(%s x, %s *d)\n{\n", name,
                   file->prefix, name, real, real);
    size_t numbers = 0;
    for (size_t k = 0; k < law->piece_count; k++) {
        size_t end = law->pieces[k].first + law->pieces[k].terms + 3u * law->pieces[k].waves;
        if (end > numbers) numbers = end;
    }
    yk_text_format(out,
                   "    static const struct {\n        %s from, middle, scale;\n        int first, terms, waves;\n    "
                   "} pieces[] = {\n",
                   real);
    for (size_t k = 0; k < law->piece_count; k++) {
        const YkPiece *q = &law->pieces[k];
        yk_text_puts(out, "        {");
        write_numbers(file, (double[]){q->from, q->middle, q->scale}, 3);
        yk_text_format(out, ", %d, %d, %d},\n", (int)q->first, (int)q->terms, (int)q->waves);
    }
    yk_text_format(out, "    };\n    static const %s numbers[] = {\n        ", real);
    if (numbers == 0)
        yk_text_puts(out, "0");
    else
        write_numbers(file, law->numbers, numbers);
    yk_text_puts(out, "};\n");
    if (law->period > 0) {
        yk_text_format(out, "    x = fmod%s(x - ", file->single ? "f" : "");
        yk_printer_number(pr, law->from);
        yk_text_puts(out, ", ");
        yk_printer_number(pr, law->period);
        yk_text_puts(out, ");\n    x = (x < 0 ? x + ");
        yk_printer_number(pr, law->period);
        yk_text_puts(out, " : x) + ");
        yk_printer_number(pr, law->from);
        yk_text_puts(out, ";\n");
    } else {
        const double ends[2][2] = {{law->from, law->start}, {law->to, law->end}};
        for (int k = 0; k < 2; k++) {
            yk_text_format(out, "    if (x %s ", k == 0 ? "<" : ">=");
            yk_printer_number(pr, ends[k][0]);
            yk_text_puts(out, ") {\n        d[0] = ");
            yk_printer_number(pr, ends[k][1]);
            yk_text_puts(out, ";\n        d[1] = d[2] = 0;\n        return;\n    }\n");
        }
    }
    yk_text_format(out,
                   "    int k = 0;\n"
                   "    while (k + 1 < %d && pieces[k + 1].from <= x) k++;\n"
                   "    %s_piece(numbers + pieces[k].first, pieces[k].terms, pieces[k].waves,\n"
                   "        (x - pieces[k].middle) * pieces[k].scale, pieces[k].scale, d);\n}\n\n",
                   (int)law->piece_count, file->prefix);
}

void yk_file_write_laws(YkFile *file)
{
    const YkModel *m = file->program.model;
    for (size_t k = 0; k < m->law_count; k++) {
        bool is_used = false;
        for (size_t i = 0; i < file->program.graph.call_count; i++) {
            const YkCall *call = &file->program.graph.calls[i];
            if (call->kind == YK_CALL_LAW && call->index == (int32_t)k) is_used = true;
        }
        if (is_used) write_law(file, file->program.names.law[k], m->laws[k].law);
    }
}
