# Cortex-M0+: soft float; the emulated core is an M0, of the same instruction set.
set(CMAKE_SYSTEM_PROCESSOR cortex-m0plus)
set(target_flags "-mcpu=cortex-m0plus -mthumb")
set(target_machine qemu-system-arm -M microbit)
set(target_memory CODE=0 RAM=0x20000000 RAM_SIZE=0x4000)
set(target_ticks 4096) # of SysTick to a thousand instructions with -icount shift=8
include(${CMAKE_CURRENT_LIST_DIR}/arm.cmake)
