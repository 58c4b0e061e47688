/* What the rigs in C and C++ share: the drops, the tolerance, and the line that each drop prints. */
#ifndef RIG_H
#define RIG_H

#include <stdint.h>
#include <stdio.h>

/* Energies of the drops, J. */
#define RIG_ENERGIES { 14.7, 9.8, 4.9 }
/* Time that a drop covers, s. */
#define RIG_DURATION 15e-3
/* Largest energy residual, as a part of the drop's energy. */
#define RIG_RESIDUAL 1e-3

/* The numbers of a drop. */
struct rig_result {
    double energy;
    double peak_force;
    double max_deformation;
    double impact_duration;
    double impulse;
    double residual;
    uint64_t trace_hash;
};

/* One line per drop; 17 digits tell every two doubles apart. */
static inline void rig_print(const struct rig_result *r)
{
    printf("%4.1f J  %.17g N  %.17g m  %.17g s  %.17g N.s  %.17g J  hash %016llx\n", r->energy, r->peak_force,
           r->max_deformation, r->impact_duration, r->impulse, r->residual, (unsigned long long)r->trace_hash);
}

#endif
