# Tests of the core for browsers, in Node. They need nothing of another build: what they compare with is recorded, or is the command itself.
set(tests ${CMAKE_SOURCE_DIR}/tests/wasm)
set(node ${scripts}/node.mjs)
set(small $<TARGET_FILE:core>)
set(panels $<TARGET_FILE:panels>)
set(whole $<TARGET_FILE:yoke>)
set(examples ${CMAKE_SOURCE_DIR}/examples)
find_program(PYTHON3 NAMES python3)

# The command as a program, for tests that run it once for each answer.
file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/yoke CONTENT "#!/bin/sh
exec ${YOKE_NODE} ${tests}/yoke.mjs ${node} ${whole} \"$@\"
" FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

add_test(NAME wasm/sizes COMMAND ${YOKE_NODE} ${tests}/test_sizes.mjs ${small} ${panels} ${whole})
add_test(NAME wasm/door COMMAND ${YOKE_NODE} ${tests}/test_door.mjs ${node} ${small} ${panels} ${examples})
add_test(NAME wasm/followers COMMAND ${YOKE_NODE} ${tests}/test_followers.mjs ${node} ${small} ${examples})
add_test(NAME wasm/answers COMMAND ${YOKE_NODE} ${tests}/test_answers.mjs ${node} ${panels} ${whole} ${examples})
add_test(NAME wasm/recorded COMMAND ${YOKE_NODE} ${tests}/test_recorded.mjs ${node} ${whole})
add_test(NAME wasm/problems COMMAND ${YOKE_NODE} ${tests}/test_problems.mjs ${node} ${small} ${whole} ${CMAKE_SOURCE_DIR}/tests/bad)
add_test(NAME wasm/client COMMAND ${YOKE_NODE} ${tests}/test_client.mjs ${node} ${scripts}/worker.js ${small} ${panels} ${whole} ${examples})
add_test(NAME wasm/types COMMAND ${YOKE_NODE} ${YOKE_WEB_DIR}/node_modules/typescript/bin/tsc -p ${CMAKE_SOURCE_DIR}/web/core)
# Every verb on every example, one process a run: a sample, all of them with YOKE_FULL.
add_test(NAME wasm/bits COMMAND ${PYTHON3} ${CMAKE_SOURCE_DIR}/tests/bits/golden.py ${CMAKE_BINARY_DIR}/yoke --sample 48)
set_tests_properties(wasm/bits PROPERTIES COST 40 ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)
set_tests_properties(wasm/sizes wasm/door wasm/followers wasm/answers wasm/recorded wasm/problems wasm/client wasm/types wasm/bits PROPERTIES TIMEOUT 36000)
set_tests_properties(wasm/door wasm/followers wasm/answers wasm/recorded wasm/problems wasm/client PROPERTIES SKIP_RETURN_CODE 77)
set_tests_properties(wasm/types PROPERTIES SKIP_REGULAR_EXPRESSION "Cannot find module.*typescript")
