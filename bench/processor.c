// Preloaded, hides the wide vectors of an x86-64 processor from a program, which then runs as on one without them:
// SOFTANVIL_WIDEST=Baseline|Avx2 LD_PRELOAD=processor.so PROGRAM.
//
// Linux can have the instruction CPUID trap where the processor offers that; the answer is given here without the bits of
// AVX-512 and AVX2. Not a byte of the program that is measured differs.
#define _GNU_SOURCE
#include <cpuid.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

enum { ARCH_SET_CPUID = 0x1012, FEATURES = 7, BIT_OF_AVX2 = 1 << 5, BIT_OF_AVX512F = 1 << 16, LENGTH_OF_CPUID = 2 };

static unsigned hidden;

static long cpuid_allowed(long allowed) { return syscall(SYS_arch_prctl, ARCH_SET_CPUID, allowed); }

static void answer(int number, siginfo_t *info, void *context) {
    (void)info;
    greg_t *registers = ((ucontext_t *)context)->uc_mcontext.gregs;
    const unsigned char *instruction = (const unsigned char *)registers[REG_RIP];
    if (instruction[0] != 0x0f || instruction[1] != 0xa2) {
        signal(number, SIG_DFL);  // A fault like any other, which comes again.
        return;
    }
    unsigned leaf = (unsigned)registers[REG_RAX], part = (unsigned)registers[REG_RCX], a, b, c, d;
    cpuid_allowed(1);
    __cpuid_count(leaf, part, a, b, c, d);
    cpuid_allowed(0);
    if (leaf == FEATURES && part == 0) b &= ~hidden;
    registers[REG_RAX] = a, registers[REG_RBX] = b, registers[REG_RCX] = c, registers[REG_RDX] = d;
    registers[REG_RIP] += LENGTH_OF_CPUID;
}

__attribute__((constructor)) static void hide(void) {
    const char *widest = getenv("SOFTANVIL_WIDEST");
    if (!widest) return;
    hidden = strcmp(widest, "Avx2") == 0 ? BIT_OF_AVX512F : BIT_OF_AVX512F | BIT_OF_AVX2;
    struct sigaction action = {.sa_sigaction = answer, .sa_flags = SA_SIGINFO | SA_NODEFER};
    if (sigaction(SIGSEGV, &action, NULL) != 0 || cpuid_allowed(0) != 0) {
        fputs("this processor, or its Linux, does not let CPUID trap\n", stderr);
        exit(77);
    }
}
