/* For rigs whose calls all have to succeed. */
#ifndef MUST_H
#define MUST_H

#include <stdio.h>
#include <stdlib.h>

#include "softanvil.h"

/* Details of the call that failed. */
static SoftanvilError error;

static void must(SoftanvilStatus status, const char *call)
{
    if (status != SOFTANVIL_STATUS_OK) {
        fprintf(stderr, "%s: %s (%s)\n", call, softanvil_status_text(status), error.text);
        exit(1);
    }
}

/* Ends the program with the reason if a call has failed. */
#define MUST(call) must((call), #call)

#endif
