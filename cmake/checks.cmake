# Checks of the house itself, as CTest tests: rooms, symbols, the list of codes, the installed package.
add_test(NAME house/rooms COMMAND sh ${CMAKE_SOURCE_DIR}/tools/check-rooms)
add_test(NAME house/rooms-sees-faults COMMAND sh ${CMAKE_SOURCE_DIR}/tests/house/test-check-rooms)
add_test(NAME house/codes COMMAND sh ${CMAKE_SOURCE_DIR}/tools/list-codes --check)
add_test(NAME house/links COMMAND sh ${CMAKE_SOURCE_DIR}/tools/check-links)
set_tests_properties(house/codes PROPERTIES ENVIRONMENT "CC=${CMAKE_C_COMPILER}")
# What users get carries no sanitizer, with symbols of its own.
if(NOT YOKE_SANITIZE)
  add_test(NAME house/symbols COMMAND sh ${CMAKE_SOURCE_DIR}/tools/check-symbols $<TARGET_FILE:yoke_shared>)
  add_test(NAME house/install COMMAND sh ${CMAKE_SOURCE_DIR}/tests/install/test-install ${CMAKE_BINARY_DIR})
  set_tests_properties(house/install PROPERTIES ENVIRONMENT "CC=${CMAKE_C_COMPILER}" TIMEOUT 120)
endif()
# What the documentation shows is what the command prints.
find_program(PYTHON3 NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(PYTHON3 NAMES python3)
if(PYTHON3)
  add_test(NAME house/docs COMMAND ${PYTHON3} ${CMAKE_SOURCE_DIR}/tools/check-docs $<TARGET_FILE:yoke>)
endif()
