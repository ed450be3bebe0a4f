# The kernels are loops over lanes: they want the vectoriser even where the rest of the library is built with less, and only
# that one (packing neighbouring statements of one lane costs more than it gains). Instruction sets are chosen at run time, see
# src/solve/lanes.h; the numbers do not depend on any of this. What solves one pose and tells of it wants the same: numbers stored one by one
# and read back in pairs wait for each other.
file(GLOB YOKE_KERNELS CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/kernels_*.c ${CMAKE_CURRENT_LIST_DIR}/elementary.c ${CMAKE_CURRENT_LIST_DIR}/single.c
  ${CMAKE_CURRENT_LIST_DIR}/run.c ${CMAKE_CURRENT_LIST_DIR}/state.c ${CMAKE_CURRENT_LIST_DIR}/answer.c
  ${CMAKE_CURRENT_LIST_DIR}/../dynamics/kernels_*.c)
set_source_files_properties(${YOKE_KERNELS} PROPERTIES COMPILE_OPTIONS "$<$<NOT:$<CONFIG:Debug>>:-O3;-fno-tree-slp-vectorize>")
