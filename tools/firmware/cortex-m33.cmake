# Cortex-M33: single-precision floating-point unit.
set(CMAKE_SYSTEM_PROCESSOR cortex-m33)
set(target_flags "-mcpu=cortex-m33 -mthumb -mfloat-abi=hard -mfpu=fpv5-sp-d16")
set(target_machine qemu-system-arm -M mps2-an505)
set(target_uart 0x50200000)
set(target_memory CODE=0x10000000 RAM=0x38000000 RAM_SIZE=0x400000)
set(target_mends board/double_sum.c) # libgcc's own double sums are not IEEE 754's
set(target_link_options LINKER:--wrap=__aeabi_dadd,--wrap=__aeabi_dsub)
set(target_ticks 5120) # of SysTick to a thousand instructions with -icount shift=8
include(${CMAKE_CURRENT_LIST_DIR}/arm.cmake)
