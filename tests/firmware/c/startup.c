/* From reset to main on a Cortex-M7: vector table, FPU, memory. */

#include <stdint.h>

#include "board.h"

/* Placed by board.ld. */
extern uint32_t data_load[], data_start[], data_end[], bss_start[], bss_end[], stack_bottom[], stack_top[];

int main(void);

/* Coprocessor Access Control Register: full access to the FPU. */
#define CPACR (*(volatile uint32_t *)0xE000ED88u)

__attribute__((noreturn)) void reset(void);
__attribute__((noreturn)) static void fault(void) { board_exit("a fault of the processor\n", 0); }

/* Stack pointer and first exceptions; a board with interrupts has more. */
__attribute__((section(".vectors"), used)) static const struct {
    uint32_t *stack;
    void (*exceptions[15])(void);
} vectors = { stack_top, { reset, fault, fault, fault, fault, fault, 0, 0, 0, 0, fault, fault, 0, fault, fault } };

/* Written without calls and loops over memory that the compiler could turn into calls before the FPU is on. */
__attribute__((noreturn, optimize("no-tree-loop-distribute-patterns"))) void reset(void)
{
#if defined(__ARM_FP)
    CPACR |= 0xFu << 20;
    __asm__ volatile("dsb\n isb" ::: "memory");
#endif
    uint32_t *from = data_load;
    for (uint32_t *to = data_start; to < data_end; to++) {
        *to = *from++;
    }
    for (uint32_t *to = bss_start; to < bss_end; to++) {
        *to = 0;
    }
    /* What the stack has not reached keeps the paint; the loop needs a few words of it itself. */
    uint32_t *here;
    __asm__ volatile("mov %0, sp" : "=r"(here));
    for (uint32_t *to = stack_bottom; to < here; to++) {
        *to = STACK_PAINT;
    }
    board_exit("", main() == 0);
}
