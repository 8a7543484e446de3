# Cortex-M4: single-precision floating-point unit.
set(CMAKE_SYSTEM_PROCESSOR cortex-m4)
set(target_flags "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16")
set(target_machine qemu-system-arm -M mps2-an386)
set(target_uart 0x40004000)
set(target_memory CODE=0 RAM=0x20000000 RAM_SIZE=0x400000)
set(target_mends board/double_sum.c) # libgcc's own double sums are not IEEE 754's
set(target_link_options LINKER:--wrap=__aeabi_dadd,--wrap=__aeabi_dsub)
set(target_unit_tests ON)
set(target_example ON)
set(target_ticks 6400) # of SysTick to a thousand instructions with -icount shift=8
include(${CMAKE_CURRENT_LIST_DIR}/arm.cmake)
