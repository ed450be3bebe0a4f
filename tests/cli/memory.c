// The command when memory fails: the whole program runs in a child, whose k-th allocation fails, once or from then on.
// It gives the right answer, byte for byte (exit code, standard output, standard error, files), or it says E0100, exits
// 2 and leaves no file. Nothing crashes, runs for ever or leaks.
//
// The gate tries one k for each place in the program (a chain of calls) that allocates and that no earlier command line
// has tried; YOKE_FULL=1 tries every k. By hand:
//   test_cli_memory solve        every k of the command lines that contain "solve"; YOKE_SAMPLE=1: a sample of them
//   YOKE_WHERE=1                 also prints, for each k that went wrong, where in the program the allocation was
#define _GNU_SOURCE // RTLD addresses for YOKE_WHERE
#include "../interposed.h"
#include <dirent.h>
#include <execinfo.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include "memory_runs.h"
// The arena of this program asks for each thing by itself.
#define YOKE_CHUNK_MIN 1
#define YOKE_CHUNK_MAX 1
#include "../../src/base/memory.c"

int yoke_main(int argc, char **argv); // apps/cli/main.c

// In place of apps/cli/watch.c: what is tried is that the library and the command know without it.
bool yk_memory_ran_out(void);
bool yk_memory_ran_out(void)
{
    return false;
}

enum { WORDS_MAX = 32, WORD_SIZE = 512, FILES_MAX = 16, CPU_SECONDS = 10, WHERE_MAX = 24 };
enum { PLACES_MAX = 1 << 22, KNOWN_MAX = 1 << 18, GOOD_EVERY = 20 };
#ifdef __OPTIMIZE__
enum { DEPTH = 5 }; // calls that tell one place from another, those of the allocator among them
#else
enum { DEPTH = 9 };
#endif

// What a child leaves for its parent.
typedef struct Shared {
    long requests, live;
    bool has_failed;
    void *where[WHERE_MAX];
    int where_count;
    uint64_t places[PLACES_MAX]; // of each allocation: a number of its calls; only where they are asked for
} Shared;
static Shared *shared;

typedef struct Bytes {
    char *data;
    size_t length;
} Bytes;
typedef struct File {
    char name[256];
    Bytes bytes;
} File;
// All that can be seen of a run from outside.
typedef struct Outcome {
    int status; // as wait() gives it
    Bytes out, err;
    File files[FILES_MAX];
    size_t file_count;
} Outcome;

typedef enum Verdict { RIGHT, REFUSED, WRONG, CRASHED, ENDLESS, LEAKED, VERDICTS } Verdict;
static const char *const verdict_names[] = {"right", "refused", "WRONG", "CRASHED", "ENDLESS", "LEAKED"};

static char folder[64]; // the children's own
static int out_descriptor, err_descriptor;

static Bytes read_descriptor(int descriptor)
{
    struct stat about;
    Bytes bytes = {0};
    assert_int_equal(fstat(descriptor, &about), 0);
    bytes.data = malloc((size_t)about.st_size + 1);
    bytes.length = (size_t)about.st_size;
    assert_int_equal(pread(descriptor, bytes.data, bytes.length, 0), about.st_size);
    bytes.data[bytes.length] = '\0';
    return bytes;
}

static void read_files(const char *path, const char *above, Outcome *outcome)
{
    DIR *open_folder = opendir(path);
    if (!open_folder) fail_msg("%s: %s", path, strerror(errno));
    for (struct dirent *entry; (entry = readdir(open_folder));) {
        char inside[512];
        struct stat about;
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0) continue;
        snprintf(inside, sizeof inside, "%s/%.200s", path, entry->d_name);
        assert_int_equal(lstat(inside, &about), 0);
        assert_true(outcome->file_count < FILES_MAX);
        File *file = &outcome->files[outcome->file_count++];
        snprintf(file->name, sizeof file->name, "%.40s%.200s", above, entry->d_name);
        if (S_ISDIR(about.st_mode)) {
            char below[300];
            snprintf(below, sizeof below, "%.200s/", entry->d_name);
            read_files(inside, below, outcome);
            rmdir(inside);
        } else {
            int descriptor = open(inside, O_RDONLY);
            file->bytes = read_descriptor(descriptor);
            close(descriptor);
            unlink(inside);
        }
    }
    closedir(open_folder);
}

static int by_name(const void *a, const void *b)
{
    return strcmp(((const File *)a)->name, ((const File *)b)->name);
}

static void forget(Outcome *outcome)
{
    free(outcome->out.data);
    free(outcome->err.data);
    for (size_t i = 0; i < outcome->file_count; i++) free(outcome->files[i].bytes.data);
}

static void note_where(void)
{
    if (shared->where_count == 0) shared->where_count = backtrace(shared->where, WHERE_MAX);
}

static void note_place(long number)
{
    void *calls[DEPTH];
    uint64_t place = 0;
    int count = backtrace(calls, DEPTH);
    for (int i = 0; i < count; i++) place = (place ^ (uintptr_t)calls[i]) * 0x9e3779b97f4a7c15U + (place >> 32);
    if (number < PLACES_MAX) shared->places[number] = place;
}

#ifdef YOKE_COVERAGE
void __gcov_dump(void); // what exit() would do, but _exit() does not
#endif

// The child: it never returns.
static void run_child(int argc, char **argv, long k, bool for_good)
{
    struct rlimit limit = {CPU_SECONDS, CPU_SECONDS}, no_core = {0, 0};
    const int signals[] = {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT}; // cmocka catches some of them
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) signal(signals[i], SIG_DFL);
    setrlimit(RLIMIT_CPU, &limit);
    setrlimit(RLIMIT_CORE, &no_core);
    if (chdir(folder) < 0) _exit(99);
    dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
    dup2(out_descriptor, STDOUT_FILENO);
    dup2(err_descriptor, STDERR_FILENO);
    long before = live;
    requests = 0;
    has_failed = false;
    fails_for_good = for_good;
    countdown = k;
    on_request = k < 0 ? note_place : NULL;
    int code = yoke_main(argc, argv);
    countdown = -1;
    on_request = NULL;
    shared->requests = requests;
    shared->live = live - before;
    shared->has_failed = has_failed;
#ifdef YOKE_COVERAGE
    __gcov_dump();
#endif
    _exit(code);
}

static Outcome run(int argc, char **argv, long k, bool for_good)
{
    Outcome outcome = {0};
    shared->requests = shared->live = shared->where_count = 0;
    shared->has_failed = false;
    for (int i = 0; i < 2; i++) {
        int descriptor = i == 0 ? out_descriptor : err_descriptor;
        assert_int_equal(ftruncate(descriptor, 0), 0);
        lseek(descriptor, 0, SEEK_SET);
    }
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) run_child(argc, argv, k, for_good);
    assert_int_equal(waitpid(child, &outcome.status, 0), child);
    outcome.out = read_descriptor(out_descriptor);
    outcome.err = read_descriptor(err_descriptor);
    read_files(folder, "", &outcome);
    qsort(outcome.files, outcome.file_count, sizeof outcome.files[0], by_name);
    return outcome;
}

static bool are_equal(Bytes a, Bytes b)
{
    return a.length == b.length && memcmp(a.data, b.data, a.length) == 0;
}

static bool are_files_equal(const Outcome *a, const Outcome *b)
{
    bool equal = a->file_count == b->file_count;
    for (size_t i = 0; equal && i < a->file_count; i++)
        equal = strcmp(a->files[i].name, b->files[i].name) == 0 && are_equal(a->files[i].bytes, b->files[i].bytes);
    return equal;
}

static bool is_beginning(Bytes part, Bytes whole)
{
    bool is_part = part.length <= whole.length && memcmp(part.data, whole.data, part.length) == 0;
    return is_part && (part.length == 0 || part.data[part.length - 1] == '\n');
}

// Of several files some may stand already, whole, and a study leaves what it goes on from.
static bool is_whole(const Outcome *right, const File *file)
{
    bool is = strstr(file->name, ".partial") != NULL;
    for (size_t i = 0; i < right->file_count && right->file_count > 1; i++)
        is = is || (strcmp(file->name, right->files[i].name) == 0 && are_equal(file->bytes, right->files[i].bytes));
    return is;
}

static bool is_refusal(const Run *given, const Outcome *right, const Outcome *outcome)
{
    if (!WIFEXITED(outcome->status) || WEXITSTATUS(outcome->status) != 2) return false;
    if (!strstr(outcome->err.data, "[E0100]")) return false;
    for (size_t i = 0; i < outcome->file_count; i++)
        if (!is_whole(right, &outcome->files[i])) return false;
    return outcome->out.length == 0 || (given->comes_in_lines && is_beginning(outcome->out, right->out));
}

static Verdict judge(const Run *given, const Outcome *right, long live_when_right, const Outcome *outcome)
{
    bool is_killed = WIFSIGNALED(outcome->status);
    if (is_killed && (WTERMSIG(outcome->status) == SIGXCPU || WTERMSIG(outcome->status) == SIGKILL)) return ENDLESS;
    if (is_killed) return CRASHED;
    bool is_right = outcome->status == right->status && are_equal(outcome->out, right->out) &&
                    are_equal(outcome->err, right->err) && are_files_equal(outcome, right);
    if (!is_right && !is_refusal(given, right, outcome)) return WRONG;
    if (shared->live > live_when_right) return LEAKED;
    return is_right ? RIGHT : REFUSED;
}

static int split(const char *words, char store[WORDS_MAX][WORD_SIZE], char **argv)
{
    int argc = 1;
    argv[0] = store[0];
    snprintf(store[0], WORD_SIZE, "yoke");
    for (const char *at = words; *at; at += strspn(at, " ")) {
        size_t length = strcspn(at, " ");
        const char *form = *at == '@'   ? YOKE_ROOT "/examples/%.*s.yaml"
                           : *at == '%' ? YOKE_ROOT "/tests/cli/memory/%.*s"
                                        : "%.*s";
        size_t mark = *at == '@' || *at == '%';
        snprintf(store[argc], WORD_SIZE, form, (int)(length - mark), at + mark);
        argv[argc] = store[argc];
        argc++;
        at += length;
    }
    argv[argc] = NULL;
    return argc;
}

static void print_failure(const Run *given, const Outcome *right, Verdict verdict, long k, bool for_good,
                          const Outcome *outcome)
{
    const char *exit_or_signal = WIFSIGNALED(outcome->status) ? "signal" : "exit";
    int number = WIFSIGNALED(outcome->status) ? WTERMSIG(outcome->status) : WEXITSTATUS(outcome->status);
    printf("%s: %s at k = %ld%s (%s %d, %ld blocks, other%s%s%s): %.160s\n", verdict_names[verdict], given->words, k,
           for_good ? " and on" : "", exit_or_signal, number, shared->live,
           are_equal(outcome->out, right->out) ? "" : " output", are_equal(outcome->err, right->err) ? "" : " messages",
           are_files_equal(outcome, right) ? "" : " files", outcome->err.data);
    if (!getenv("YOKE_WHERE")) return;
    FILE *file = fopen("/tmp/yoke-other-output", "w");
    fwrite(outcome->out.data, 1, outcome->out.length, file);
    fclose(file);
    printf("  where:");
    for (int i = 0; i < shared->where_count; i++) printf(" %p", shared->where[i]);
    printf("\n");
}

static uint64_t known[KNOWN_MAX]; // places that have been tried; 0: free
static long known_count;

static bool is_new(uint64_t place)
{
    size_t at = place % KNOWN_MAX;
    while (known[at] != 0 && known[at] != place) at = (at + 1) % KNOWN_MAX;
    if (known[at] == place) return false;
    assert_true(++known_count < KNOWN_MAX / 2);
    known[at] = place;
    return true;
}

// The allocations to try: all, or one of each new place, the first or a later one. Returns how many.
static long choose(long count, bool every, uint64_t seed, long *chosen)
{
    long some = 0;
    for (long k = 0; k < count; k++) {
        long at = k;
        if (!every && !is_new(shared->places[k])) continue;
        for (long later = k + 1; !every && later < count && later < k + 64; later++)
            if (shared->places[later] == shared->places[k] && check_uniform(&seed, 0, 1) < 0.5) at = later;
        chosen[some++] = at;
    }
    return some;
}

typedef struct Tally {
    long count[VERDICTS];
} Tally;

static long try_all(const Run *given, bool every, Tally *sum)
{
    static char store[WORDS_MAX][WORD_SIZE];
    char *argv[WORDS_MAX + 1];
    int argc = split(given->words, store, argv);
    Tally tally = {0};
    Outcome right = run(argc, argv, -1, false);
    long count = shared->requests, live_when_right = shared->live > 0 ? shared->live : 0, told = 0, bad = 0;
    if (!WIFEXITED(right.status) || WEXITSTATUS(right.status) == 99 || count == 0) {
        printf("DOES NOT RUN: %s\n", given->words);
        forget(&right);
        return 1;
    }
    uint64_t seed = 20261122;
    for (const char *c = given->words; *c; c++) seed = seed * 31 + (unsigned char)*c;
    assert_true(count <= PLACES_MAX);
    long *chosen = malloc((size_t)count * sizeof *chosen), tries = choose(count, every, seed, chosen);
    for (int for_good = 0; for_good < 2; for_good++) {
        for (long i = 0; i < tries; i++) {
            long k = chosen[i];
            if (for_good && !every && i % GOOD_EVERY != 0) continue;
            Outcome outcome = run(argc, argv, k, for_good);
            Verdict verdict = judge(given, &right, live_when_right, &outcome);
            tally.count[verdict]++;
            if (verdict > REFUSED) {
                bad++;
                if (told++ < 20 || getenv("YOKE_WHERE")) print_failure(given, &right, verdict, k, for_good, &outcome);
            }
            forget(&outcome);
        }
    }
    free(chosen);
    printf("%6ld of %ld allocations:", tries, count);
    for (int v = 0; v < VERDICTS; v++) {
        sum->count[v] += tally.count[v];
        if (v < WRONG || tally.count[v] > 0) printf(" %ld %s", tally.count[v], verdict_names[v]);
    }
    printf("; exit %d: %s\n", WEXITSTATUS(right.status), given->words);
    fflush(stdout);
    forget(&right);
    return bad;
}

static const char *wanted; // NULL: all, a sample

static void the_command_is_right_or_refuses(void **state)
{
    (void)state;
    skip_unless_interposed();
    Tally sum = {0};
    long bad = 0;
    const char *full = getenv("YOKE_FULL");
    bool every = (wanted && !getenv("YOKE_SAMPLE")) || (full && strcmp(full, "1") == 0);
    for (size_t i = 0; i < sizeof runs / sizeof runs[0]; i++)
        if (!wanted || strstr(runs[i].words, wanted)) bad += try_all(&runs[i], every, &sum);
    printf("in all:");
    for (int v = 0; v < VERDICTS; v++) printf(" %ld %s", sum.count[v], verdict_names[v]);
    printf("\n");
    assert_int_equal(bad, 0);
}

// --- A limit of the system's: ulimit -v

enum { STEP = 1 << 17 };

// Standard output and error of the installed command in so many bytes of addresses.
static Outcome run_within(rlim_t bytes, char **argv)
{
    Outcome outcome = {0};
    for (int i = 0; i < 2; i++) {
        int descriptor = i == 0 ? out_descriptor : err_descriptor;
        assert_int_equal(ftruncate(descriptor, 0), 0);
        lseek(descriptor, 0, SEEK_SET);
    }
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        const struct rlimit limit = {bytes, bytes}, seconds = {CPU_SECONDS, CPU_SECONDS};
        dup2(out_descriptor, STDOUT_FILENO);
        dup2(err_descriptor, STDERR_FILENO);
        if (chdir(folder) == 0 && setrlimit(RLIMIT_CPU, &seconds) == 0 && setrlimit(RLIMIT_AS, &limit) == 0)
            execv(YOKE_COMMAND, argv);
        _exit(99);
    }
    assert_int_equal(waitpid(child, &outcome.status, 0), child);
    outcome.out = read_descriptor(out_descriptor);
    outcome.err = read_descriptor(err_descriptor);
    read_files(folder, "", &outcome);
    return outcome;
}

// A row of parallelograms, `count` of them, each carried by the one before.
static void write_chain(const char *path, int count)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "name: A chain of parallelograms\nbodies:\n  ground: {points: {A0: [0, 0]");
    for (int i = 1; i <= count; i++) fprintf(file, ", A%d: [%d, 0]", i, i);
    fprintf(file, "}}\n");
    for (int i = 0; i <= count; i++) fprintf(file, "  link%d: {points: {A%d: [0, 0], B%d: [1, 0]}}\n", i, i, i);
    for (int i = 1; i <= count; i++) fprintf(file, "  rod%d: {points: {B%d: [0, 0], B%d: [1, 0]}}\n", i, i - 1, i);
    fprintf(file, "joints:\n");
    for (int i = 0; i <= count; i++) fprintf(file, "  A%d: {pin: [ground, link%d], angle: t%d}\n", i, i, i);
    for (int i = 1; i <= count; i++) {
        fprintf(file, "  B%d: {pin: [link%d, rod%d], at: B%d, angle: p%d}\n", i, i - 1, i, i - 1, i);
        fprintf(file, "  C%d: {pin: [rod%d, link%d], at: B%d}\n", i, i, i, i);
    }
    fprintf(file, "drives: {t0: 60 deg + 1 rad/s * t}\nstart: {t1: 60 deg");
    for (int i = 2; i <= count; i++) fprintf(file, ", t%d: 60 deg", i);
    for (int i = 1; i <= count; i++) fprintf(file, ", p%d: -60 deg", i);
    fprintf(file, "}\n");
    assert_int_equal(fclose(file), 0);
}

// From the least room in which the command begins to run, in steps, to where it has all that it needs.
static void try_limits(const char *words, long *refused, long *right_ones)
{
    static char store[WORDS_MAX][WORD_SIZE];
    char *argv[WORDS_MAX + 1];
    const Run given = {words, false};
    split(words, store, argv);
    Outcome right = run_within(RLIM_INFINITY, argv);
    assert_true(WIFEXITED(right.status) && WEXITSTATUS(right.status) == 0);
    bool started = false, done = false;
    for (rlim_t bytes = STEP; bytes < (rlim_t)1 << 28 && !done; bytes += STEP) {
        Outcome outcome = run_within(bytes, argv);
        started = started || (WIFEXITED(outcome.status) && WEXITSTATUS(outcome.status) != 127);
        shared->live = 0;
        Verdict verdict = started ? judge(&given, &right, 0, &outcome) : RIGHT;
        if (verdict > REFUSED)
            fail_msg("ulimit -v %lu; yoke %s: %s: %.200s", (unsigned long)(bytes >> 10), words, verdict_names[verdict],
                     outcome.err.data);
        *refused += started && verdict == REFUSED;
        *right_ones += started && verdict == RIGHT;
        done = started && verdict == RIGHT;
        forget(&outcome);
    }
    assert_true(done);
    forget(&right);
}

static void in_a_narrow_room_it_is_right_or_refuses(void **state)
{
    (void)state;
    char chain[128], words[256];
    static const char *const verbs[] = {"check", "solve", "draw", "code", "derive --what loops"};
    long refused = 0, right = 0;
    skip_unless_interposed();
    if (wanted) skip();
    snprintf(chain, sizeof chain, "%s.yaml", folder);
    write_chain(chain, 30);
    for (size_t i = 0; i < sizeof verbs / sizeof *verbs; i++) {
        snprintf(words, sizeof words, "%.32s %s", verbs[i], chain);
        try_limits(words, &refused, &right);
    }
    unlink(chain);
    printf("in narrow rooms: %ld refused, %ld right\n", refused, right);
    assert_true(refused > 10);
    assert_int_equal(right, sizeof verbs / sizeof *verbs);
}

int main(int argc, char **argv)
{
    void *first[1];
    wanted = argc > 1 ? argv[1] : NULL;
    backtrace(first, 1); // it allocates when it is called first
    if (getenv("YOKE_WHERE")) {
        on_failure = note_where;
        printf("yoke_main is at %p\n", (void *)(uintptr_t)yoke_main);
    }
    start_counting();
    snprintf(folder, sizeof folder, "/tmp/yoke-memory.XXXXXX");
    if (!mkdtemp(folder)) return 1;
    out_descriptor = fileno(tmpfile());
    err_descriptor = fileno(tmpfile());
    shared = mmap(NULL, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) return 1;
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_command_is_right_or_refuses),
                                       cmocka_unit_test(in_a_narrow_room_it_is_right_or_refuses)};
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    rmdir(folder);
    return failed;
}
