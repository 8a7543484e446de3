# Copies include/ and src/ as one does into a vendor's project, and compiles all of it in one plain command with no more
# flags than OPTIONS: no help from CMake, no generated file.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
separate_arguments(options UNIX_COMMAND "${OPTIONS}")
file(REMOVE_RECURSE ${WORK})
file(COPY ${CHASLES_SOURCE_DIR}/include ${CHASLES_SOURCE_DIR}/src ${CMAKE_CURRENT_LIST_DIR}/main.c DESTINATION ${WORK})
execute_process(COMMAND ${CMAKE_C_COMPILER} ${options} -fsyntax-only ${WORK}/src/status.c -I${WORK}/include
  RESULT_VARIABLE unknown_options ERROR_QUIET)
if(options AND unknown_options)
  message(STATUS "skipped: the compiler does not take ${OPTIONS}")
  return()
endif()
file(GLOB sources RELATIVE ${WORK} ${WORK}/src/*.c)
run(${CMAKE_C_COMPILER} ${options} -Iinclude ${sources} main.c -lm -o stranger WORKING_DIRECTORY ${WORK})
expect_same_output(${WORK}/stranger)
