/*
 * What is the board's, apart from the simulation: console, end of the program, counter of instructions, use of memory.
 * For QEMU or a debugger (semihosting): replace it by what your board has.
 */
#ifndef BOARD_H
#define BOARD_H

#include <stdint.h>

#define STACK_PAINT 0xCCCCCCCCu

/* Instructions per tick under QEMU with -icount shift=0: 1 ns each, and a processor clock of 25 MHz. On a board a tick is
 * a cycle of the processor. */
#define INSTRUCTIONS_PER_TICK 40u

void board_print(const char *text);
/* Without printf, which needs a heap for floating-point numbers in most C libraries. */
void board_print_number(uint64_t number);
void board_print_hex(uint64_t number);

/* Ends the program and QEMU. */
__attribute__((noreturn)) void board_exit(const char *text, int success);

/* Starts the counter of ticks. */
void board_start_counter(void);
/* Ticks since the last call, which is less than 2^24 ticks ago. */
uint32_t board_ticks(void);

/* Bytes of flash: code, constants, initial values. */
uint32_t board_flash(void);
/* Bytes of RAM that are taken before the program starts. */
uint32_t board_static_ram(void);
/* Most bytes of stack that the program has used so far. */
uint32_t board_stack_high_water(void);

#endif
