# Installs this build tree for the strangers, into a folder that is emptied first.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
file(REMOVE_RECURSE ${CMAKE_PREFIX_PATH})
run(${CMAKE_COMMAND} --install ${CHASLES_BINARY_DIR} --config ${CMAKE_BUILD_TYPE} --prefix ${CMAKE_PREFIX_PATH})
