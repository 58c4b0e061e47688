/* What an interface has to offer for a row of the table (matrix.c): a drop that goes on in communication steps. */
#ifndef MATRIX_H
#define MATRIX_H

#include <stddef.h>

/* What is compared. */
typedef struct {
    double peak_force, impulse;
    char trace_hash[17];
} Outcome;

/* A drop in progress. */
typedef struct Drop Drop;

/* Loads what is tested; `library` and `token` are for an FMU. */
void prepare(const char *library, const char *token);

/* A drop with `energy`, J, ready for its first step; ends the program if there is none. */
Drop *begin(double energy);

/* Makes `count` communication steps of `size` s, where `made` have been made. */
void advance(Drop *drop, int made, int count, double size);

/* The whole state as bytes of malloc. */
unsigned char *save(Drop *drop, size_t *size);

void restore(Drop *drop, const unsigned char *bytes, size_t size);

Outcome outcome(Drop *drop);

void end(Drop *drop);

/* Ends the program with a message if `condition` is false. */
#define MUST(condition) must((condition) != 0, #condition, __FILE__, __LINE__)
void must(int holds, const char *what, const char *file, int line);

#endif
