# For the scripts beside this file: the variables of SETTINGS, and these two.
include(${SETTINGS})

# Runs a command, shows it, and fails if it fails.
macro(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endmacro()

# Fails unless the program prints what the reference prints.
function(expect_same_output program)
  execute_process(COMMAND ${program} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${REFERENCE} OUTPUT_VARIABLE expected COMMAND_ERROR_IS_FATAL ANY)
  message(STATUS "printed  ${printed}")
  if(NOT printed STREQUAL expected)
    message(FATAL_ERROR "expected ${expected}")
  endif()
endfunction()
