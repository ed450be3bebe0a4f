// Passes on each piece of output as it is written, so that a long table needs little memory.
#include "verbs/study/study.h"

// After a piece that did not fit, which is reported, the rest is dropped.
void yk_study_flush(YkStudyAnswer *a, size_t most)
{
    YkText *out = &a->session->out;
    if (!a->blocks || out->failed || out->length < most) return;
    if (a->stream.is_open && !yk_stream_write(&a->stream, yk_text_get(out), out->length, a->session->problems))
        yk_stream_drop(&a->stream);
    yk_text_clear(out);
}
