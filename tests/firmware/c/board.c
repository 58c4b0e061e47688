#include "board.h"

extern uint32_t flash_start[], flash_end[], data_start[], data_end[], bss_start[], bss_end[], stack_bottom[], stack_top[];

/* Operations of Arm semihosting. */
enum { WRITE0 = 0x04, EXIT = 0x18, EXIT_SUCCESS = 0x20026, EXIT_FAILURE = 0x20024 };

/* SysTick: 24 bits, counts down. */
#define SYST_CSR (*(volatile uint32_t *)0xE000E010u)
#define SYST_RVR (*(volatile uint32_t *)0xE000E014u)
#define SYST_CVR (*(volatile uint32_t *)0xE000E018u)
#define SYST_MASK 0x00FFFFFFu

static uint32_t last;

static void semihosting(uint32_t operation, uintptr_t argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register uintptr_t r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
}

void board_print(const char *text) { semihosting(WRITE0, (uintptr_t)text); }

static void print_digits(uint64_t number, uint32_t base, int least)
{
    char text[24];
    char *place = text + sizeof text;
    *--place = '\0';
    do {
        *--place = "0123456789abcdef"[number % base];
        number /= base;
    } while (--least > 0 || number > 0);
    board_print(place);
}

void board_print_number(uint64_t number) { print_digits(number, 10, 1); }
void board_print_hex(uint64_t number) { print_digits(number, 16, 16); }

void board_exit(const char *text, int success)
{
    board_print(text);
    semihosting(EXIT, success ? EXIT_SUCCESS : EXIT_FAILURE);
    for (;;) {
    }
}

void board_start_counter(void)
{
    SYST_RVR = SYST_MASK;
    SYST_CVR = 0;
    SYST_CSR = 5; /* processor clock, no interrupt */
    last = 0;
}

uint32_t board_ticks(void)
{
    uint32_t now = SYST_CVR;
    uint32_t ticks = (last - now) & SYST_MASK;
    last = now;
    return ticks;
}

static uint32_t bytes(const uint32_t *start, const uint32_t *end) { return (uint32_t)((uintptr_t)end - (uintptr_t)start); }

uint32_t board_flash(void) { return bytes(flash_start, flash_end) + bytes(data_start, data_end); }
uint32_t board_static_ram(void) { return bytes(data_start, data_end) + bytes(bss_start, bss_end); }

uint32_t board_stack_high_water(void)
{
    const volatile uint32_t *word = stack_bottom;
    while (word < stack_top && *word == STACK_PAINT) {
        word++;
    }
    return bytes((const uint32_t *)word, stack_top);
}
