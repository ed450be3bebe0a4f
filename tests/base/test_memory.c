// The arena: alignment, zeroed memory, large blocks, exhaustion.
#include "check.h"
#include <stdlib.h>
#include "base/memory.h"

static void alignment_is_16_below_64_bytes_and_64_from_there(void **state)
{
    (void)state;
    YkArena *arena = yk_arena_new();
    uint64_t seed = 1;
    for (int i = 0; i < 20000; i++) {
        size_t count = check_random(&seed) % 200, size = 1 + check_random(&seed) % 24;
        void *memory = yk_arena_alloc(arena, count, size);
        assert_non_null(memory);
        assert_int_equal((uintptr_t)memory % (count * size >= 64 ? 64 : 16), 0);
    }
    assert_false(yk_arena_failed(arena));
    yk_arena_free(arena);
}

static void memory_is_zeroed_and_never_shared(void **state)
{
    (void)state;
    enum { BLOCKS = 500 };
    unsigned char *blocks[BLOCKS];
    size_t sizes[BLOCKS];
    uint64_t seed = 2;
    YkArena *arena = yk_arena_new();
    for (size_t i = 0; i < BLOCKS; i++) {
        sizes[i] = check_random(&seed) % 5000;
        blocks[i] = yk_arena_alloc(arena, sizes[i], 1);
        for (size_t k = 0; k < sizes[i]; k++) assert_int_equal(blocks[i][k], 0);
        memset(blocks[i], (int)(i % 251 + 1), sizes[i]);
    }
    for (size_t i = 0; i < BLOCKS; i++)
        for (size_t k = 0; k < sizes[i]; k++) assert_int_equal(blocks[i][k], i % 251 + 1);
    yk_arena_free(arena);
}

static void blocks_larger_than_a_chunk_fit(void **state)
{
    (void)state;
    YkArena *arena = yk_arena_new();
    size_t size = (size_t)5 << 20;
    unsigned char *large = yk_arena_alloc(arena, size, 1), *small = yk_arena_alloc(arena, 8, 1);
    assert_non_null(large);
    assert_non_null(small);
    large[0] = large[size - 1] = small[0] = small[7] = 1;
    yk_arena_free(arena);
}

static void empty_blocks_are_not_null_and_differ(void **state)
{
    (void)state;
    YkArena *arena = yk_arena_new();
    void *a = yk_arena_alloc(arena, 0, 8), *b = yk_arena_alloc(arena, 8, 0);
    assert_non_null(a);
    assert_non_null(b);
    assert_ptr_not_equal(a, b);
    yk_arena_free(arena);
}

static void overflow_and_exhaustion_give_null_and_are_remembered(void **state)
{
    (void)state;
    const struct {
        size_t count, size;
    } requests[] = {{SIZE_MAX, 2},         {2, SIZE_MAX},    {SIZE_MAX, SIZE_MAX},
                    {SIZE_MAX / 8 + 1, 8}, {PTRDIFF_MAX, 1}, {1, SIZE_MAX}};
    for (size_t i = 0; i < sizeof requests / sizeof *requests; i++) {
        YkArena *arena = yk_arena_new();
        assert_null(yk_arena_alloc(arena, requests[i].count, requests[i].size));
        assert_true(yk_arena_failed(arena));
        assert_non_null(yk_arena_alloc(arena, 1, 1)); // small things still fit, but the failure stays
        assert_true(yk_arena_failed(arena));
        yk_arena_free(arena);
    }
}

static void an_arena_that_could_not_be_made_fails_everything(void **state)
{
    (void)state;
    assert_null(yk_arena_alloc(NULL, 1, 1));
    assert_null(yk_arena_copy(NULL, "a", 1));
    assert_true(yk_arena_failed(NULL));
    yk_arena_free(NULL);
}

static void a_copy_ends_in_nul_and_keeps_inner_ones(void **state)
{
    (void)state;
    YkArena *arena = yk_arena_new();
    assert_memory_equal(yk_arena_copy(arena, "ab\0cd", 5), "ab\0cd", 6);
    assert_string_equal(yk_arena_copy(arena, "crank", 3), "cra");
    assert_string_equal(yk_arena_copy(arena, NULL, 0), "");
    assert_null(yk_arena_copy(arena, "", SIZE_MAX));
    yk_arena_free(arena);
}

static void what_is_given_back_is_given_next(void **state)
{
    (void)state;
    YkArena *arena = yk_arena_new();
    for (size_t bytes = 1; bytes < 10000; bytes = 3 * bytes + 1) { // from several chunks
        char *taken = yk_arena_take(arena, bytes);
        memset(taken, 'a', bytes);
        yk_arena_give_back(arena, taken, 1);
        char *next = yk_arena_take(arena, 5);
        assert_true(next == taken + 16 || bytes + 16 > 4096); // at the end of a chunk, from another
        memset(next, 'b', 5);
        assert_int_equal(*taken, 'a');
        yk_arena_give_back(arena, next, 0);
        assert_ptr_equal(yk_arena_take(arena, 16), next);
    }
    yk_arena_free(arena);
}

static void a_growing_array_keeps_its_items_and_doubles(void **state)
{
    (void)state;
    int *items = NULL;
    size_t capacity = 0, moves = 0;
    for (size_t count = 0; count < 10000; count++) {
        size_t before = capacity;
        assert_true(YK_ROOM(items, count, capacity));
        assert_true(capacity > count);
        if (capacity != before) moves++;
        items[count] = (int)count;
    }
    for (size_t i = 0; i < 10000; i++) assert_int_equal(items[i], i);
    assert_true(moves <= 12);
    free(items);
}

static void an_array_that_cannot_grow_keeps_what_it_has(void **state)
{
    (void)state;
    char *items = malloc(8), *before = items;
    size_t capacity = SIZE_MAX / 2;
    assert_false(yk_grow((void **)&items, capacity, &capacity, 1));
    capacity = PTRDIFF_MAX / 16;
    assert_false(yk_grow((void **)&items, capacity, &capacity, 16));
    assert_ptr_equal(items, before);
    assert_true(capacity == PTRDIFF_MAX / 16);
    free(items);
}

static void a_cleared_arena_gives_zeroed_memory_again(void **state)
{
    (void)state;
    YkArena *arena = yk_arena_new();
    for (int round = 0; round < 5; round++) {
        for (int i = 0; i < 300; i++) {
            unsigned char *memory = yk_arena_alloc(arena, 100, 1);
            assert_non_null(memory);
            for (int k = 0; k < 100; k++) assert_int_equal(memory[k], 0);
            memset(memory, 0xa5, 100);
        }
        yk_arena_clear(arena);
    }
    assert_null(yk_arena_alloc(arena, SIZE_MAX / 2, 1));
    assert_true(yk_arena_failed(arena));
    yk_arena_clear(arena);
    assert_true(yk_arena_failed(arena)); // what is gone may have been looked for
    yk_arena_free(arena);
    arena = yk_arena_new();
    yk_arena_clear(arena); // before anything was asked for
    assert_non_null(yk_arena_alloc(arena, 8, 1));
    yk_arena_free(arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(alignment_is_16_below_64_bytes_and_64_from_there),
        cmocka_unit_test(memory_is_zeroed_and_never_shared),
        cmocka_unit_test(blocks_larger_than_a_chunk_fit),
        cmocka_unit_test(empty_blocks_are_not_null_and_differ),
        cmocka_unit_test(overflow_and_exhaustion_give_null_and_are_remembered),
        cmocka_unit_test(an_arena_that_could_not_be_made_fails_everything),
        cmocka_unit_test(a_copy_ends_in_nul_and_keeps_inner_ones),
        cmocka_unit_test(what_is_given_back_is_given_next),
        cmocka_unit_test(a_growing_array_keeps_its_items_and_doubles),
        cmocka_unit_test(an_array_that_cannot_grow_keeps_what_it_has),
        cmocka_unit_test(a_cleared_arena_gives_zeroed_memory_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
