# Fails unless `PROGRAM ARGUMENTS` succeeds and prints the text of the file EXPECTED.
execute_process(COMMAND ${PROGRAM} ${ARGUMENTS} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
file(READ ${EXPECTED} expected)
if(NOT printed STREQUAL expected)
  message(FATAL_ERROR "the output is not the one expected\nexpected:\n${expected}\nprinted:\n${printed}")
endif()
