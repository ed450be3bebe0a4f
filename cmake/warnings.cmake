# All warnings, as errors, for Yoke's own code.
function(yoke_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes
    -Wmissing-prototypes -Wpointer-arith -Wwrite-strings -Wundef -Werror)
  if(CMAKE_SYSTEM_PROCESSOR STREQUAL "wasm32")
    target_compile_options(${target} PRIVATE -Wno-gnu-statement-expression) # macros of wasi-libc
  endif()
endfunction()
