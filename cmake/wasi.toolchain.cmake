# Compiles for WebAssembly with Debian's clang 14 and wasi-libc; clang 19's linker makes invalid modules with this wasi-libc.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_C_COMPILER clang-14)
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
set(CMAKE_AR llvm-ar-14)
set(CMAKE_RANLIB llvm-ranlib-14)
# Scalar: with -msimd128, clang 14's vectoriser of neighbouring statements makes wrong code (mirror() in src/law/rise.c).
set(CMAKE_C_FLAGS_INIT "-ffunction-sections -fdata-sections")
# -O0 on the line of the linker: otherwise clang runs whichever wasm-opt is on the path, which need not be there.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-O0 -Wl,--gc-sections,--strip-all,--stack-first -Wl,-z,stack-size=1048576")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_C_FLAGS_MINSIZEREL "-Oz -DNDEBUG" CACHE STRING "Flags of MinSizeRel")
