/* start_riscv.S - from reset to main on RV32: registers, floating-point unit, memory. */
  .option arch, +zicsr
  .section .vectors, "ax"
  .globl reset
reset:
  .option push
  .option norelax
  la gp, __global_pointer$
  .option pop
  la sp, stack_top
  la t0, fault
  csrw mtvec, t0
  li t0, 0x2000            /* mstatus.FS: the floating-point unit is on */
  csrs mstatus, t0
  csrw fcsr, zero
  la a0, data_start
  la a1, data_load
  la a2, data_end
  sub a2, a2, a0
  call memcpy
  la a0, bss_start
  li a1, 0
  la a2, bss_end
  sub a2, a2, a0
  call memset
  call main
  call semihosting_exit

  .balign 4
fault:
  li a0, 99
  call semihosting_exit
