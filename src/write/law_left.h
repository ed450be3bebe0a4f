// Words for a law whose range a pose has left.
#ifndef WRITE_LAW_LEFT_H
#define WRITE_LAW_LEFT_H
#include <yoke/laws.h>
#include "base/text.h"
#include "base/units/units.h"

// Adds "the effort of `d5` leaves the range of law `cutting`, 0 mm to 120 mm: at 130 mm it keeps its end value, 500 N".
void yk_law_left_write(YkText *text, const YkModel *model, const YkLawLeft *left);
// Returns "drive", "effort", "force" or "spring".
const char *yk_law_user_word(YkLawUser user);

#endif
