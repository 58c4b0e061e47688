/* What the sketch takes of an Arduino core, over the board of tests/firmware. */
#ifndef ARDUINO_H
#define ARDUINO_H
#include <stddef.h>
#include <stdint.h>
extern "C" {
#include "board.h"
}
struct Port {
    void begin(long) {}
    void print(const char *text) { board_print(text); }
    void println(const char *text) { board_print(text); board_print("\n"); }
    void println(long number) { board_print_number((uint64_t)number); board_print("\n"); }
};
extern Port Serial;
#endif
