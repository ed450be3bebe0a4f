// The inside of a structured form. For use inside ring/ only.
#ifndef RING_PROOF_FORM_INSIDE_H
#define RING_PROOF_FORM_INSIDE_H
#include "ring/inside.h"
#include "ring/proof/form.h"

enum { YK_FORM_HEIGHT_MAX = 10000 }; // walking is recursive

struct YkForm {
    YkFormKind kind;
    size_t number;            // unique in the ring: parts have lower numbers
    size_t least;             // the lowest number below and at this node
    size_t height;            // length of the longest way down; 0 for an element
    const YkPoisson *element; // for YK_FORM_ELEMENT
    size_t count;
    const YkForm *parts[];
};

#endif
