# What all toolchain files share: a compiler without an operating system, and the emulator that runs what it makes.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_C_COMPILER ${target_compiler}-gcc)
set(CMAKE_C_FLAGS_INIT "${target_flags}")
set(CMAKE_ASM_FLAGS_INIT "${target_flags}")
set(CMAKE_C_FLAGS_RELEASE "-O2" CACHE STRING "")
set(CMAKE_C_FLAGS_MINSIZEREL "-Os" CACHE STRING "")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(CMAKE_CROSSCOMPILING_EMULATOR ${target_machine} -display none -monitor none
  -semihosting-config enable=on,target=native -kernel)
