# The kernels are loops over lanes: they want the vectoriser even where the rest of the library is built with less, and only
# that one (packing neighbouring statements of one lane costs more than it gains). Instruction sets are chosen at run time, see
# src/elementary/kernel.h; the numbers do not depend on any of this. Files that solve one pose and read its answers
# are compiled in the same way: numbers stored one by one and read back in pairs wait for each other.
file(GLOB YOKE_KERNELS CONFIGURE_DEPENDS src/solve/kernels/*.c src/equations/kernels_*.c src/study/kernels_*.c src/law/kernels_*.c src/graph/tape_run.c)
list(APPEND YOKE_KERNELS src/elementary/sine.c src/solve/single.c src/solve/run.c src/solve/state.c src/solve/answer.c)
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "wasm32") # scalar and small there, but for what solves one pose
  list(FILTER YOKE_KERNELS INCLUDE REGEX "(sine|single)\\.c$")
  set_source_files_properties(${YOKE_KERNELS} PROPERTIES COMPILE_OPTIONS "-O2")
  return()
endif()
set_source_files_properties(${YOKE_KERNELS} PROPERTIES COMPILE_OPTIONS "$<$<NOT:$<CONFIG:Debug>>:-O3;-fno-tree-slp-vectorize>")
