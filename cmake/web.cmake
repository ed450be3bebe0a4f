# The report's style, and its script, which Node bundles. Without Node and npm, or if npm cannot get its packages, the
# script is empty: reports do not move, and say so.
option(YOKE_WEB "Bundle the report's script if Node is installed" ON)
set(YOKE_PLAIN_SCRIPT "" CACHE STRING "What takes the place of the script without Node; pages hold its data unless it is empty")
option(YOKE_REQUIRE_WEB "Fail if the report's script cannot be bundled" OFF)
set(YOKE_WEB_SOURCE ${CMAKE_SOURCE_DIR}/web/report)
set(YOKE_WEB_DIR ${CMAKE_BINARY_DIR}/web)
find_program(YOKE_NODE node)
find_program(YOKE_NPM npm)

function(yoke_embed input name)
  set(output ${YOKE_WEB_DIR}/${name}.c)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -D INPUT=${input} -D OUTPUT=${output} -D NAME=${name} -P ${CMAKE_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${input} ${CMAKE_SOURCE_DIR}/cmake/embed.cmake COMMENT "Embedding ${name}" VERBATIM)
  target_sources(yoke_core PRIVATE ${output})
endfunction()

file(GLOB YOKE_WEB_FILES CONFIGURE_DEPENDS ${YOKE_WEB_SOURCE}/*.json ${YOKE_WEB_SOURCE}/src/*)
if(YOKE_WEB AND YOKE_NODE AND YOKE_NPM)
  add_custom_command(OUTPUT ${YOKE_WEB_DIR}/report.js
    COMMAND sh ${CMAKE_SOURCE_DIR}/tools/bundle-web ${YOKE_WEB_SOURCE} ${YOKE_WEB_DIR} ${YOKE_NPM} $<IF:$<BOOL:${YOKE_REQUIRE_WEB}>,require,try>
      report.js
    DEPENDS ${YOKE_WEB_FILES} ${CMAKE_SOURCE_DIR}/tools/bundle-web COMMENT "Bundling the report's script" VERBATIM)
elseif(YOKE_REQUIRE_WEB)
  message(FATAL_ERROR "node and npm are needed to bundle the report's script")
else()
  message(STATUS "No node and npm: reports will have no script, their diagrams come from gnuplot")
  file(WRITE ${YOKE_WEB_DIR}/report.js "${YOKE_PLAIN_SCRIPT}")
endif()
yoke_embed(${CMAKE_SOURCE_DIR}/src/report/style.css yk_report_style)
if(CMAKE_SYSTEM_NAME STREQUAL "WASI")
  add_custom_target(report_script ALL DEPENDS ${YOKE_WEB_DIR}/report.js) # a file of its own: web/core/small/report_script.c
else()
  yoke_embed(${YOKE_WEB_DIR}/report.js yk_report_script)
endif()
