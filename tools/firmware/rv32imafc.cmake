# RV32IMAFC: single-precision floating-point unit.
set(CMAKE_SYSTEM_PROCESSOR rv32imafc)
set(target_flags "-march=rv32imafc -mabi=ilp32f --specs=picolibc.specs")
set(target_machine qemu-system-riscv32 -M virt -bios none)
set(target_uart 0x10000000)
set(target_memory CODE=0x80000000 RAM=0x80400000 RAM_SIZE=0x400000)
set(target_sources board/start_riscv.S)
set(target_compiler riscv64-unknown-elf)
include(${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake)
