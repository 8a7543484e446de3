# Copies include/ and src/ as one does into a vendor's project, compiles all of it and the device's program in one plain
# command, without the options that the library's own build has, and compares every function with this machine.
file(REMOVE_RECURSE ${WORK})
file(COPY ${SOURCE_DIR}/include ${SOURCE_DIR}/src DESTINATION ${WORK})
file(GLOB sources ${WORK}/src/*.c)
set(firmware ${SOURCE_DIR}/tools/firmware)
set(host ${SOURCE_DIR}/tools/chasles)
separate_arguments(flags UNIX_COMMAND "${FLAGS}")
separate_arguments(board UNIX_COMMAND "${BOARD}")
execute_process(
  COMMAND ${COMPILER} ${flags} -O2 -I${WORK}/include -I${host} -I${firmware}/device -I${firmware}/board ${sources}
    ${firmware}/device/device.c ${firmware}/device/port_semihosting.c ${host}/evaluate.c ${host}/frame.c
    ${host}/functions.c ${board} -lm -o ${WORK}/stranger.elf
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(
  COMMAND ${CHASLES} compare --quiet --device "exec:${EMULATE} ${WORK}/stranger.elf" ${SOURCE_DIR}/tests/vectors
  COMMAND_ERROR_IS_FATAL ANY)
