// What a structured form is made of. Inside of ring/.
#ifndef RING_PROOF_FORM_INSIDE_H
#define RING_PROOF_FORM_INSIDE_H
#include "ring/inside.h"
#include "ring/proof/form.h"

enum { YK_FORM_HEIGHT_MAX = 10000 }; // walking is recursive

struct YkForm {
    YkFormKind kind;
    size_t number;            // of all forms of the ring: parts have lower ones
    size_t least;             // the lowest number below and at this node
    size_t height;            // longest way down; 0 of an element
    const YkPoisson *element; // of YK_FORM_ELEMENT
    size_t count;
    const YkForm *parts[];
};

#endif
