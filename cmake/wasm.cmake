# The core for browsers (preset `wasm`, cmake/wasi.toolchain.cmake): core.wasm for the page's drawing and moving, without imports;
# panels.wasm for its panels; and yoke.wasm, the whole command. See web/core/README.md.
set(CMAKE_POSITION_INDEPENDENT_CODE OFF)
include(cmake/together.cmake)
set(YOKE_WASI ${CMAKE_SOURCE_DIR}/web/core/wasi)
set(YOKE_LIBYAML ${CMAKE_BINARY_DIR}/third-party CACHE PATH "Folder with libyaml's sources, or where tools/get-libyaml shall put them")
execute_process(COMMAND sh ${CMAKE_SOURCE_DIR}/tools/get-libyaml ${YOKE_LIBYAML} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "The sources of libyaml could not be fetched; see tools/get-libyaml")
endif()
set(yaml ${YOKE_LIBYAML}/libyaml)
file(STRINGS ${yaml}/configure.ac line REGEX "^m4_define\\(\\[YAML_(MAJOR|MINOR|PATCH)\\]")
string(REGEX REPLACE "[^0-9;]" "" version "${line}")
list(GET version 0 major)
list(GET version 1 minor)
list(GET version 2 patch)
add_library(yaml STATIC ${yaml}/src/api.c ${yaml}/src/parser.c ${yaml}/src/reader.c ${yaml}/src/scanner.c)
target_include_directories(yaml PUBLIC ${yaml}/include)
target_compile_definitions(yaml PRIVATE YAML_VERSION_MAJOR=${major} YAML_VERSION_MINOR=${minor} YAML_VERSION_PATCH=${patch}
  YAML_VERSION_STRING="${major}.${minor}.${patch}")
target_compile_options(yaml PRIVATE -w)

file(GLOB YOKE_SOURCES CONFIGURE_DEPENDS src/*/*.c src/*/*/*.c)
list(REMOVE_ITEM YOKE_SOURCES ${CMAKE_SOURCE_DIR}/src/write/process.c ${CMAKE_SOURCE_DIR}/src/report/script.c)
list(FILTER YOKE_SOURCES EXCLUDE REGEX "/synthesis/(nine_points/alt_.*|paths/path_exact)[.]c$|/report/findings[.]c$") # small/no_exact_path.c, small/findings.c
add_library(yoke_core STATIC ${YOKE_SOURCES} ${YOKE_WASI}/process.c ${YOKE_WASI}/posix.c ${YOKE_WASI}/print.c web/core/small/no_exact_path.c
  web/core/small/report_script.c)
target_include_directories(yoke_core PUBLIC ${YOKE_WASI} include src)
target_compile_definitions(yoke_core PUBLIC _POSIX_C_SOURCE=200809L _WASI_EMULATED_GETPID _WASI_EMULATED_SIGNAL)
target_link_libraries(yoke_core PUBLIC yaml)
yoke_warnings(yoke_core)
include(cmake/kernels.cmake)
include(cmake/web.cmake)
file(GLOB with_posix src/write/*.c src/doc/file.c apps/cli/stop.c apps/cli/verbs/simulate/verb.c)
set_property(SOURCE ${with_posix} APPEND PROPERTY COMPILE_OPTIONS -include posix.h)
yoke_together(yoke_core ${YOKE_SOURCES})

# Binaryen takes some more bytes off, where it is installed. It changes no arithmetic. Memory begins with zeros, and C has
# no addresses below 1024: no module is given a memory, and the stack's end lies there.
find_program(YOKE_WASM_OPT wasm-opt)
function(yoke_shrink target)
  if(YOKE_WASM_OPT)
    add_custom_command(TARGET ${target} POST_BUILD COMMAND ${YOKE_WASM_OPT} --zero-filled-memory --low-memory-unused
      --inlining --flatten --rereloop --simplify-locals-nonesting -Oz -Oz $<TARGET_FILE:${target}> -o $<TARGET_FILE:${target}> VERBATIM)
  endif()
endfunction()

# Links the whole library, room by room: in this order the modules are smallest after gzip. The linker then drops every
# function that is not called.
set(whole -Wl,--whole-archive $<TARGET_FILE:yoke_core> -Wl,--no-whole-archive)

# The whole command. The files of verbs that panels.wasm leaves to it, and those with names of POSIX, are compiled alone.
set(left "/(new|explain|rest|study|report|code|synthesize|map|cognates|balance)/verb[.]c|/studio/in_browser[.]c|/gallery[.]c|/certify[.]c|/rolls?[.]c")
set(YOKE_APART "${left}|/stop[.]c|/simulate/verb[.]c")
add_subdirectory(apps/cli)
set_property(SOURCE ${with_posix} DIRECTORY apps/cli APPEND PROPERTY COMPILE_OPTIONS -include posix.h)
target_link_libraries(yoke PRIVATE wasi-emulated-getpid wasi-emulated-signal)
set_target_properties(yoke PROPERTIES SUFFIX .wasm RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})

# What the page's panels need: the same flat functions as core.wasm, those of curves and simulations, and the verbs by which
# panels are filled. The verbs that take their time or write files are in yoke.wasm alone.
file(GLOB door CONFIGURE_DEPENDS web/core/*.c)
target_sources(yoke PRIVATE ${door} ${YOKE_WASI}/start.c src/report/findings.c) # a page in one file has no panels.wasm
target_include_directories(yoke PRIVATE web/core)
target_link_options(yoke PRIVATE -mexec-model=reactor -Wl,--max-memory=1073741824 ${whole})
add_executable(panels ${door} ${YOKE_WASI}/start.c apps/cli/main.c apps/cli/watch.c web/core/small/verbs.c web/core/small/certify.c
  web/core/small/findings.c web/core/small/roll.c $<FILTER:$<TARGET_OBJECTS:yoke_command>,EXCLUDE,${left}>)
target_include_directories(panels PRIVATE web/core apps/cli)
target_link_libraries(panels PRIVATE yoke_core wasi-emulated-getpid wasi-emulated-signal)
target_compile_definitions(panels PRIVATE $<TARGET_PROPERTY:yoke,COMPILE_DEFINITIONS>)
target_link_options(panels PRIVATE $<TARGET_PROPERTY:yoke,LINK_OPTIONS>)
set_target_properties(panels PROPERTIES SUFFIX .wasm)
yoke_warnings(panels)
yoke_shrink(panels)

# The module with which a page draws and moves: flat functions and no imports. Its memory is limited, so that running out is reported.
set(core ${door} web/core/small/still.c)
list(FILTER core EXCLUDE REGEX "/(curves|forces|simulate)[.]c$")
add_executable(core ${core})
target_include_directories(core PRIVATE web/core)
target_link_libraries(core PRIVATE yoke_core)
target_link_options(core PRIVATE -mexec-model=reactor -Wl,--max-memory=1073741824 ${whole})
set_target_properties(core PROPERTIES SUFFIX .wasm)
yoke_warnings(core)
yoke_shrink(core)

# What tests in Node use of the page's side, bundled by the esbuild that bundled the report's script.
if(YOKE_WEB AND YOKE_NODE AND YOKE_NPM)
  set(scripts ${CMAKE_BINARY_DIR}/js)
  file(GLOB typescript CONFIGURE_DEPENDS web/core/*.ts)
  set(esbuild ${YOKE_WEB_DIR}/node_modules/.bin/esbuild)
  add_custom_command(OUTPUT ${scripts}/node.mjs ${scripts}/worker.js
    COMMAND sh -c "test ! -x $0 || { $0 $1/node.ts --bundle --format=esm --platform=neutral --target=es2022 --log-level=warning --outfile=$2/node.mjs && $0 $1/worker.ts --bundle --minify --format=iife --target=es2022 --log-level=warning --outfile=$2/worker.js; }"
      ${esbuild} ${CMAKE_SOURCE_DIR}/web/core ${scripts}
    COMMAND ${CMAKE_COMMAND} -E touch ${scripts}/node.mjs ${scripts}/worker.js
    DEPENDS ${typescript} ${YOKE_WEB_DIR}/report.js COMMENT "Bundling the page's side" VERBATIM)
  add_custom_target(core_scripts ALL DEPENDS ${scripts}/node.mjs ${scripts}/worker.js)
  if(BUILD_TESTING)
    include(tests/wasm/tests.cmake)
  endif()
endif()
include(cmake/studio.cmake)
