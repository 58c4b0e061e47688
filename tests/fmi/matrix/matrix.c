/* The three drops of the study by one interface (c_abi.c, fmi2.c, fmi3.c): in communication steps of 50 us, 100 us, 1 ms and 30 us, which no kernel step divides,
 * saved in mid-impact and restored into another instance, and with eight instances in eight threads at once. Prints a line per
 * drop: energy in J, way, peak force in N, impulse in N s, trace hash; matrix.py makes the table.
 *
 *     matrix [LIBRARY TOKEN [brief]]      brief: only the drops in threads, eight of the fifteen, for a slow machine */
#include "matrix.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Time of a drop, and the samples in it; those before the state is saved, when the face is deep in the layer. */
static const double DURATION = 15e-3, SAMPLE = 50e-6;
enum { SAMPLES = 300, MIDDLE = 60, N_ENERGY = 3, N_THREAD = 8 };

void must(int holds, const char *what, const char *file, int line)
{
    if (holds) return;
    fprintf(stderr, "%s:%d: %s\n", file, line, what);
    exit(1);
}

static void print(double energy, const char *way, const Outcome *found)
{
    printf("%.1f,%s,%.17g,%.17g,%s\n", energy, way, found->peak_force, found->impulse, found->trace_hash);
}

static Outcome whole(double energy, double size)
{
    Drop *drop = begin(energy);
    advance(drop, 0, (int)(DURATION / size + 0.5), size);
    const Outcome found = outcome(drop);
    end(drop);
    return found;
}

/* The state goes from an instance that ends to another that is elsewhere. */
static Outcome restored(double energy)
{
    size_t size = 0;
    Drop *drop = begin(energy);
    advance(drop, 0, MIDDLE, SAMPLE);
    unsigned char *bytes = save(drop, &size);
    end(drop);
    drop = begin(energy);
    advance(drop, 0, 10, SAMPLE);
    restore(drop, bytes, size);
    free(bytes);
    advance(drop, MIDDLE, SAMPLES - MIDDLE, SAMPLE);
    const Outcome found = outcome(drop);
    end(drop);
    return found;
}

/* Length of a communication step, s; none for the drop that is restored. */
static const struct {
    const char *name;
    double size;
} WAY[] = {{"50 us", 50e-6}, {"100 us", 100e-6}, {"1 ms", 1e-3}, {"30 us", 30e-6}, {"restored", 0.0}};
enum { N_WAY = sizeof WAY / sizeof *WAY };

/* A drop in one of the ways. */
typedef struct {
    double energy;
    int way;
    Outcome found;
} Work;

static void *work(void *argument)
{
    Work *own = argument;
    own->found = WAY[own->way].size > 0.0 ? whole(own->energy, WAY[own->way].size) : restored(own->energy);
    return NULL;
}

/* Eight instances at once, one in each thread. */
static void in_threads(Work *all)
{
    pthread_t thread[N_THREAD];
    for (int i = 0; i < N_THREAD; i++) MUST(pthread_create(&thread[i], NULL, work, &all[i]) == 0);
    for (int i = 0; i < N_THREAD; i++) {
        MUST(pthread_join(thread[i], NULL) == 0);
        print(all[i].energy, "8 threads", &all[i].found);
    }
}

int main(int argc, char **argv)
{
    /* A brief run has every energy and every way. */
    Work all[N_ENERGY * N_WAY] = {
        {.energy = 14.7, .way = 0}, {.energy = 9.8, .way = 0}, {.energy = 4.9, .way = 0}, {.energy = 14.7, .way = 4},
        {.energy = 4.9, .way = 4},  {.energy = 14.7, .way = 1}, {.energy = 9.8, .way = 2}, {.energy = 4.9, .way = 3},
        {.energy = 9.8, .way = 4},  {.energy = 9.8, .way = 1},  {.energy = 4.9, .way = 1}, {.energy = 14.7, .way = 2},
        {.energy = 4.9, .way = 2},  {.energy = 14.7, .way = 3}, {.energy = 9.8, .way = 3},
    };
    const int brief = argc > 3 && strcmp(argv[3], "brief") == 0;
    const int n = brief ? N_THREAD : N_ENERGY * N_WAY;
    prepare(argc > 1 ? argv[1] : NULL, argc > 2 ? argv[2] : NULL);
    for (int i = 0; i < n && !brief; i++) work(&all[i]);
    Work at_once[N_THREAD];
    memcpy(at_once, all, sizeof at_once);
    in_threads(at_once);
    for (int i = 0; i < n; i++) {
        const Work *made = brief ? &at_once[i] : &all[i];
        print(made->energy, WAY[made->way].name, &made->found);
    }
    return 0;
}
