# Runs PROGRAM.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
expect_same_output(${PROGRAM})
