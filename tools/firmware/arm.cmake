# What the Arm toolchain files share.
set(target_compiler arm-none-eabi)
set(target_small_library --specs=nano.specs)
set(target_sources board/start_arm.c ${target_mends})
include(${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake)
