// Writes NumPy's format, version 1.0 (numpy.lib.format): a head that is a Python dictionary, then the rows as
// little-endian doubles, each with a name. The status is its number in yoke/status.h.
#include <string.h>
#include "verbs/study/study.h"

static void add_field(YkText *head, const char *name)
{
    yk_text_format(head, "('%s', '<f8'), ", name);
}

static void add_head(const YkStudyAnswer *a, YkText *head)
{
    YkText name = {0};
    size_t first = yk_study_first(a);
    yk_text_puts(head, "{'descr': [");
    for (size_t k = 0; k < a->axis_count; k++) add_field(head, a->axes[k].name);
    add_field(head, "status");
    add_field(head, "poses");
    for (size_t k = first; k < a->width; k++) {
        yk_study_name(a, k - first, &name);
        add_field(head, yk_text_get(&name));
    }
    yk_text_format(head, "], 'fortran_order': False, 'shape': (%z,), }", a->done);
    while ((head->length + 11) % 64 != 0) yk_text_puts(head, " ");
    yk_text_puts(head, "\n");
    yk_text_free(&name);
}

static void add_row(const double *row, size_t width, YkText *out)
{
    for (size_t k = 0; k < width; k++) {
        uint64_t bits;
        char bytes[8];
        memcpy(&bits, &row[k], sizeof bits);
        for (int b = 0; b < 8; b++) bytes[b] = (char)(bits >> (8 * b) & 255);
        yk_text_add(out, bytes, sizeof bytes);
    }
}

void yk_study_npy(YkStudyAnswer *a)
{
    YkText head = {0}, *out = &a->session->out;
    add_head(a, &head);
    char magic[10] = {(char)0x93, 'N', 'U', 'M', 'P', 'Y', 1, 0, (char)(head.length & 255), (char)(head.length >> 8)};
    yk_text_add(out, magic, sizeof magic);
    yk_text_add(out, yk_text_get(&head), head.length);
    for (size_t d = 0; d < a->done; d++) {
        add_row(yk_study_row(a, d), a->width, out);
        yk_study_flush(a, YK_STUDY_PIECE);
    }
    out->failed |= head.failed || head.length > 65535;
    yk_text_free(&head);
}
