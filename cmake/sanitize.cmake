# The address and undefined-behaviour sanitizers. The tests start thousands of programs, so what each start, end and link costs counts.
# The address sanitizer finds a null pointer and a place outside an object as soon as they are used: to check them a second time
# would cost a tenth of the stage. The checks of addresses that wrap around or are not aligned cost 40 % of the compiler's time, and
# are left to `sh tools/test full` and to the preset `fuzz`.
option(YOKE_SANITIZE_EVERY "Check the arithmetic and the alignment of addresses, too" ${YOKE_FUZZ})
set(unchecked null,object-size)
if(NOT YOKE_SANITIZE_EVERY)
  string(APPEND unchecked ,pointer-overflow,alignment)
endif()
add_compile_options(-fsanitize=address,undefined -fno-sanitize=${unchecked} -fno-omit-frame-pointer -fno-sanitize-recover=all)
add_link_options(-fsanitize=address,undefined)
# Without the vectoriser, the kernels' copies for each instruction set are the same code: one is enough (src/elementary/kernel.h).
add_compile_definitions(YK_PLAIN_LANES)
if(YOKE_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
  return() # libFuzzer comes with a runtime of its own
endif()

# clang links its runtime into every program unless told otherwise. As a shared library it is linked once, and its tables, 10 MB
# that the leak checker would read at the end of every program, stand apart from the program's own data (cmake/sanitizer.c).
if(CMAKE_C_COMPILER_ID MATCHES "Clang")
  execute_process(COMMAND ${CMAKE_C_COMPILER} -print-file-name=libclang_rt.asan-${CMAKE_SYSTEM_PROCESSOR}.so
    OUTPUT_VARIABLE runtime OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(EXISTS ${runtime})
    get_filename_component(folder ${runtime} DIRECTORY)
    add_link_options(-shared-libasan LINKER:-rpath,${folder})
  endif()
endif()
add_library(yoke_sanitizer_options OBJECT cmake/sanitizer.c)
link_libraries($<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:$<TARGET_OBJECTS:yoke_sanitizer_options>>)

# At a fixed address, 165,000 pointers of the sanitizers' tables need not be set at each start.
link_libraries($<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:-no-pie>)

# lld links such programs in half the time of ld.
check_linker_flag(C -fuse-ld=lld YOKE_HAS_LLD)
if(YOKE_HAS_LLD)
  add_link_options(-fuse-ld=lld)
endif()
