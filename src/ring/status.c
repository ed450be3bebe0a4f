// The status of a ring - what went wrong in it - and the limits of its work.
#include "ring/inside.h"

const YkPoisson *yk_ring_fail(YkRing *ring, YkRingStatus status)
{
    bool is_for_good = status >= YK_RING_STOPPED && ring->status < status;
    if (ring->status == YK_RING_OK || is_for_good) ring->status = status;
    return NULL;
}

YkRingStatus yk_ring_status(const YkRing *ring)
{
    bool ran_out = ring->arena->failed || ring->sheet->failed;
    return ran_out ? YK_RING_MEMORY : ring->status;
}

void yk_ring_clear(YkRing *ring)
{
    if (ring->status < YK_RING_STOPPED) ring->status = YK_RING_OK;
}

void yk_ring_set_pace(YkRing *ring, YkPace *pace)
{
    ring->pace = pace;
}

YkPace *yk_ring_pace(const YkRing *ring)
{
    return ring->pace;
}

bool yk_ring_spend(YkRing *ring, size_t work)
{
    return yk_pace_spend(ring->pace, work) || yk_ring_fail(ring, YK_RING_STOPPED) != NULL;
}

void yk_ring_set_limit(YkRing *ring, size_t terms)
{
    ring->limit = terms < 1 ? 1 : terms < UINT32_MAX / 4 ? terms : UINT32_MAX / 4;
}

const char *yk_ring_status_text(YkRingStatus status)
{
    switch (status) {
    case YK_RING_OK:
        return "all is well";
    case YK_RING_OVERFLOW:
        return "a coefficient is too large for exact arithmetic";
    case YK_RING_SIZE:
        return "the expression has too many terms to be expanded";
    case YK_RING_POWER:
        return "a power is too large or is not defined";
    case YK_RING_DIVISOR:
        return "only a single term other than zero can divide";
    case YK_RING_DERIVATIVE:
        return "a higher derivative of a function is needed than is known";
    case YK_RING_NAME:
        return "a symbol's name is malformed or taken";
    case YK_RING_NOT_REAL:
        return "a real expression is needed";
    case YK_RING_STOPPED:
        return "stopped before it was done, as the caller asked";
    case YK_RING_MEMORY:
        return "out of memory";
    }
    return "unknown";
}
