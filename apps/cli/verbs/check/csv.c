// Writes the check as a list of facts, each with a number: what, value.
#include "verbs/check/check.h"
#include "write/csv.h"

static void add_fact(const YkCheckAnswer *answer, const char *what, double value)
{
    YkCsv csv = {.text = &answer->session->out};
    yk_csv_name(&csv, what);
    yk_csv_number(&csv, value);
    yk_csv_row(&csv);
}

void yk_check_csv(const YkCheckAnswer *answer)
{
    const YkMechanism *mech = answer->session->mech;
    YkFreedom freedom = yk_mechanism_freedom(mech);
    yk_text_puts(&answer->session->out, "what,value\n");
    add_fact(answer, "bodies", (double)yk_model_body_count(answer->session->model));
    add_fact(answer, "joints", (double)yk_model_joint_count(answer->session->model));
    add_fact(answer, "loops", (double)yk_loop_count(mech));
    add_fact(answer, "freedom.gruebler", freedom.gruebler);
    add_fact(answer, "freedom.rank", freedom.by_rank);
    add_fact(answer, "freedom.redundant", (double)freedom.redundant);
    add_fact(answer, "freedom.driven", (double)freedom.driven);
    add_fact(answer, "blocks", (double)yk_block_count(mech));
    if (!answer->has_loads) return;
    YkEquationCount e = answer->equations;
    add_fact(answer, "loads.masses", (double)answer->loads.masses);
    add_fact(answer, "loads.mass", answer->loads.mass);
    add_fact(answer, "equations.count", (double)(e.force + e.moment + e.acceleration));
    add_fact(answer, "equations.unknowns", (double)(e.unknown_reactions + e.unknown_accelerations + e.unknown_efforts));
}
