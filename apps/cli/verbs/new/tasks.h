// The task files that `yoke new --task` writes.
#ifndef CLI_NEW_TASKS_H
#define CLI_NEW_TASKS_H
#include <stddef.h>

typedef struct YkTaskExample {
    const char *kind, *text;
} YkTaskExample;
extern const YkTaskExample yk_task_examples[];
extern const size_t yk_task_example_count;

#endif
