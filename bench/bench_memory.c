// The memory that one right-hand side touches, in bytes per link: hanging chains (the way of open trees) and N
// parallelograms. Counted array by array, and measured by the machine's own pages (Linux): all marks "touched" are
// cleared, one right-hand side runs, the marks are summed. Pages hold more than what is read, so the measure is an
// upper bound.
#include <stdlib.h>
#include <string.h>
#include "dynamics/dynamics.h"
#include "machine.h"

enum { LINKS = 200000 };
static const double MOST = 256; // bytes a link

// --- measured
// -----------------------------------------------------------------------------------------------------------

// Bytes in pages touched since the marks were cleared; negative if the system does not say.
static double touched(void)
{
    FILE *file = fopen("/proc/self/smaps", "r");
    char line[512];
    double sum = 0, kilobytes;
    if (!file) return -1;
    while (fgets(line, sizeof line, file))
        if (sscanf(line, "Referenced: %lf kB", &kilobytes) == 1) sum += kilobytes * 1024;
    fclose(file);
    return sum;
}

static bool clear_marks(void)
{
    FILE *file = fopen("/proc/self/clear_refs", "w");
    bool done = file && fputs("1", file) >= 0;
    if (file) done = fclose(file) == 0 && done;
    return done;
}

// Inputs stand in the state, accelerations come out; the machine has been run before.
static double measure(Machine *machine, double *accelerations)
{
    machine_accelerate(machine, accelerations);
    machine_accelerate(machine, accelerations);
    if (!clear_marks()) return -1;
    double before = touched();
    machine_accelerate(machine, accelerations);
    double after = touched();
    double bytes = after - before;
    return before >= 0 && bytes > sizeof(double) * LINKS ? bytes : -1; // some systems keep no marks
}

// --- counted
// ------------------------------------------------------------------------------------------------------------

typedef struct Part {
    const char *name;
    size_t count, size;
} Part;

// The arrays that a right-hand side runs through, whole: what a link's entry holds beyond what is read counts too. Of
// the state's two spaces one is touched.
static double count_parts(const Machine *machine, double links)
{
    const YkMechanism *mech = machine->mech;
    const YkInfluence *f = machine->dynamics->influence;
    const Part parts[] = {
        {"steps of solution", mech->step_count, sizeof *mech->steps},
        {"blocks", mech->block_count, sizeof *mech->blocks},
        {"terms of sums", mech->term_count, sizeof *mech->terms},
        {"unit vectors with rates", mech->slot_count, 4 * sizeof(double)},
        {"where their lanes are", mech->slot_count, sizeof(YkTurn)},
        {"nodes", mech->node_count, 6 * sizeof(double) + sizeof(YkPlane)},
        {"bodies that turn about a fixed point", f->pivoted_count, sizeof *f->pivoted},
        {"bodies that these carry", f->carried_count, sizeof *f->carried},
        {"other bodies", f->other_count, sizeof *f->others},
    };
    double sum = 0;
    for (size_t k = 0; k < sizeof parts / sizeof *parts; k++) {
        double bytes = (double)parts[k].count * (double)parts[k].size / links;
        sum += bytes;
        if (bytes >= 0.1)
            printf("    %-40s %5.2f of %3zu bytes = %7.1f\n", parts[k].name, (double)parts[k].count / links,
                   parts[k].size, bytes);
    }
    return sum;
}

// --- both
// ---------------------------------------------------------------------------------------------------------------

static bool report(const char *name, char *text, double links)
{
    Machine machine;
    bool stands = machine_parse(&machine, text);
    double *accelerations = calloc((size_t)links + 1, sizeof *accelerations);
    free(text);
    if (!stands || !accelerations) exit(1);
    double bytes = measure(&machine, accelerations) / links;
    printf("%s, bytes a link\n", name);
    if (machine.dynamics->influence) printf("    %-40s %24.1f\n", "counted", count_parts(&machine, links));
    if (bytes < 0)
        printf("    measured: this system does not tell\n");
    else
        printf("    %-40s %24.1f   %s < %g\n", "measured by pages", bytes, bytes < MOST ? "keeps" : "MISSES", MOST);
    free(accelerations);
    machine_end(&machine);
    return bytes < MOST;
}

int main(void)
{
    bool keeps = report("chain", chain_text(LINKS), LINKS);
    keeps &= report("N-four-bar, two links a loop", n_four_bar_text(LINKS / 2), LINKS + 1);
    return keeps ? 0 : 2;
}
