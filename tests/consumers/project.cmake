# Configures, builds and runs the stranger's project in the folder PROJECT.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} -C ${SETTINGS} -S ${CMAKE_CURRENT_LIST_DIR}/${PROJECT} -B ${WORK})
run(${CMAKE_COMMAND} --build ${WORK})
expect_same_output(${WORK}/stranger)
