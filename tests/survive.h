// A call whose allocations fail one after the other: it succeeds or says that it did not, and loses nothing.
#ifndef TESTS_SURVIVE_H
#define TESTS_SURVIVE_H
#include "interposed.h"
#ifndef IS_SANITIZED // the arena asks for each thing by itself
#define YOKE_CHUNK_MIN 1
#define YOKE_CHUNK_MAX 1
#include "../src/base/memory.c"
#endif

// Makes `call` again and again while its k-th allocation fails, every one at first and then some, until it needs no
// more than k. The call returns whether it succeeded, checks its own answer, and has freed everything that it made. It
// must succeed where no allocation failed, and fail where one did: no answer is given that lacks something.
static inline void survive(bool (*call)(void *context), void *context, const char *name)
{
    assert_true(call(context)); // what is made once, by the first call of all, does not count
    for (long k = 0, is_done = false; !is_done; k += 1 + k / 24) {
        long before = live;
        has_failed = false;
        countdown = k;
        bool succeeds = call(context);
        countdown = -1;
        is_done = !has_failed;
        if (succeeds == has_failed)
            fail_msg("%s: allocation %ld %s", name, k, succeeds ? "failed unnoticed" : "seemed to fail");
        if (live != before) fail_msg("%s: allocation %ld: %ld blocks lost", name, k, live - before);
        assert_true(k < 10000000);
    }
}
#endif
