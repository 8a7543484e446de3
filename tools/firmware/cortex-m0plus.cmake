# Cortex-M0+: soft float. The emulated core is an M3, which has all instructions of an M0+: the emulated M0 board has too
# little memory for all functions in both precisions.
set(CMAKE_SYSTEM_PROCESSOR cortex-m0plus)
set(target_flags "-mcpu=cortex-m0plus -mthumb")
set(target_machine qemu-system-arm -M mps2-an385)
set(target_uart 0x40004000)
set(target_memory CODE=0 RAM=0x20000000 RAM_SIZE=0x400000)
set(target_ticks 6400) # of SysTick to a thousand instructions with -icount shift=8
include(${CMAKE_CURRENT_LIST_DIR}/arm.cmake)
