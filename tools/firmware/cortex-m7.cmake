# Cortex-M7: double-precision floating-point unit.
set(CMAKE_SYSTEM_PROCESSOR cortex-m7)
set(target_flags "-mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-d16")
set(target_machine qemu-system-arm -M mps2-an500)
set(target_uart 0x40004000)
set(target_memory CODE=0 RAM=0x20000000 RAM_SIZE=0x400000)
set(target_ticks 6400) # of SysTick to a thousand instructions with -icount shift=8
include(${CMAKE_CURRENT_LIST_DIR}/arm.cmake)
