// Threads where there is one: starting another fails, and callers go on alone with the same bits.
#ifndef WASI_PTHREAD_H
#define WASI_PTHREAD_H
#include <errno.h>
#include <stddef.h>
#include <time.h>

typedef int pthread_t;
typedef int pthread_mutex_t;
typedef int pthread_cond_t;

static inline int pthread_create(pthread_t *thread, const void *attributes, void *(*start)(void *), void *context)
{
    (void)thread, (void)attributes, (void)start, (void)context;
    return EAGAIN;
}
static inline int pthread_join(pthread_t thread, void **result)
{
    (void)thread, (void)result;
    return 0;
}
static inline int pthread_mutex_init(pthread_mutex_t *lock, const void *attributes)
{
    (void)lock, (void)attributes;
    return 0;
}
static inline int pthread_mutex_destroy(pthread_mutex_t *lock)
{
    (void)lock;
    return 0;
}
static inline int pthread_mutex_lock(pthread_mutex_t *lock)
{
    (void)lock;
    return 0;
}
static inline int pthread_mutex_unlock(pthread_mutex_t *lock)
{
    (void)lock;
    return 0;
}
static inline int pthread_cond_init(pthread_cond_t *sign, const void *attributes)
{
    (void)sign, (void)attributes;
    return 0;
}
static inline int pthread_cond_destroy(pthread_cond_t *sign)
{
    (void)sign;
    return 0;
}
static inline int pthread_cond_signal(pthread_cond_t *sign)
{
    (void)sign;
    return 0;
}
static inline int pthread_cond_wait(pthread_cond_t *sign, pthread_mutex_t *lock)
{
    (void)sign, (void)lock;
    return 0;
}
static inline int pthread_cond_timedwait(pthread_cond_t *sign, pthread_mutex_t *lock, const struct timespec *until)
{
    (void)sign, (void)lock, (void)until;
    return 0;
}

#endif
