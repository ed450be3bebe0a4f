# Studio's page, a static site in the folder `studio` of the build: the bundle of web/studio, the core's modules, the gallery. Without Node
# and npm, or if npm cannot get its packages, the build skips the page and prints a message.
if(NOT (YOKE_WEB AND YOKE_NODE AND YOKE_NPM))
  message(STATUS "No node and npm: the page of Studio is not built")
  return()
endif()
set(YOKE_STUDIO_WORK ${CMAKE_BINARY_DIR}/page/studio)
set(YOKE_STUDIO ${CMAKE_BINARY_DIR}/studio)
file(GLOB_RECURSE YOKE_STUDIO_FILES CONFIGURE_DEPENDS web/studio/src/* web/core/*.ts)
file(GLOB YOKE_STUDIO_EXAMPLES CONFIGURE_DEPENDS examples/*.yaml)
list(APPEND YOKE_STUDIO_FILES web/studio/index.html web/studio/sw.js web/studio/build.mjs web/studio/gallery.mjs web/studio/package.json
  web/studio/package-lock.json web/studio/tsconfig.json)
add_custom_command(OUTPUT ${YOKE_STUDIO_WORK}/dist/studio.js
  COMMAND sh ${CMAKE_SOURCE_DIR}/tools/bundle-web ${CMAKE_SOURCE_DIR}/web/studio ${YOKE_STUDIO_WORK} ${YOKE_NPM}
    $<IF:$<BOOL:${YOKE_REQUIRE_WEB}>,require,try> dist/studio.js ${CMAKE_SOURCE_DIR}/web/core
  DEPENDS ${YOKE_STUDIO_FILES} ${CMAKE_SOURCE_DIR}/tools/bundle-web WORKING_DIRECTORY ${CMAKE_SOURCE_DIR} COMMENT "Bundling Studio" VERBATIM)
add_custom_command(OUTPUT ${YOKE_STUDIO}/index.html
  COMMAND sh ${CMAKE_SOURCE_DIR}/tools/assemble-studio ${YOKE_STUDIO_WORK} ${YOKE_STUDIO} $<TARGET_FILE:core> $<TARGET_FILE:panels> $<TARGET_FILE:yoke>
    ${YOKE_WEB_DIR}/report.js ${YOKE_NODE} ${CMAKE_SOURCE_DIR}/examples
  DEPENDS ${YOKE_STUDIO_WORK}/dist/studio.js core panels yoke ${YOKE_WEB_DIR}/report.js ${YOKE_STUDIO_EXAMPLES} ${CMAKE_SOURCE_DIR}/tools/assemble-studio
  COMMENT "Putting Studio together" VERBATIM)
add_custom_target(studio ALL DEPENDS ${YOKE_STUDIO}/index.html)
# The page as one file for a release: unpacked, it is a static site for any host.
set(archive yoke-studio-${PROJECT_VERSION})
add_custom_target(studio_archive COMMAND ${CMAKE_COMMAND} -E rm -rf ${archive} COMMAND ${CMAKE_COMMAND} -E copy_directory ${YOKE_STUDIO} ${archive}
  COMMAND ${CMAKE_COMMAND} -E tar czf ${archive}.tar.gz ${archive} COMMAND ${CMAKE_COMMAND} -E rm -rf ${archive}
  DEPENDS ${YOKE_STUDIO}/index.html WORKING_DIRECTORY ${CMAKE_BINARY_DIR} COMMENT "Packing Studio into ${archive}.tar.gz" VERBATIM)

if(BUILD_TESTING)
  set(page_tests ${CMAKE_SOURCE_DIR}/tests/web/studio)
  add_test(NAME studio/document COMMAND ${YOKE_NODE} ${page_tests}/test_document.mjs ${YOKE_STUDIO_WORK} ${CMAKE_SOURCE_DIR}/examples)
  add_test(NAME studio/house COMMAND ${YOKE_NODE} ${page_tests}/test_house.mjs ${CMAKE_SOURCE_DIR}/web/studio ${YOKE_STUDIO})
  add_test(NAME studio/types COMMAND ${YOKE_NODE} node_modules/typescript/bin/tsc --noEmit WORKING_DIRECTORY ${YOKE_STUDIO_WORK})
  set_tests_properties(studio/document studio/house PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 600)
  set_tests_properties(studio/types PROPERTIES SKIP_REGULAR_EXPRESSION "Cannot find module.*typescript")
  find_program(CHROMIUM chromium)
  if(CHROMIUM)
    foreach(part page harm design show)
      add_test(NAME studio/${part} COMMAND ${YOKE_NODE} ${page_tests}/test_${part}.mjs ${YOKE_STUDIO_WORK} ${YOKE_STUDIO})
    endforeach()
    set_tests_properties(studio/page studio/harm studio/design studio/show PROPERTIES COST 80 TIMEOUT 900 SKIP_RETURN_CODE 77 ENVIRONMENT "CHROMIUM=${CHROMIUM}")
  endif()
endif()
