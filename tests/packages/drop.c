/* What a package must do: the study's drop, with the bits that the library says it computes. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <softanvil.h>

int main(int argc, char **argv) {
    SoftanvilScenario scenario;
    SoftanvilSimulation *anvil;
    size_t size, alignment;
    double peak;
    char digest[17];
    if (softanvil_scenario_default(SOFTANVIL_PRESET_STUDY, &scenario) != SOFTANVIL_STATUS_OK ||
        softanvil_memory_size(&scenario, &size, &alignment, NULL) != SOFTANVIL_STATUS_OK ||
        softanvil_init(malloc(size), size, &scenario, &anvil, NULL) != SOFTANVIL_STATUS_OK ||
        softanvil_run(anvil, 15e-3, NULL, NULL) != SOFTANVIL_STATUS_OK ||
        softanvil_output(anvil, SOFTANVIL_OUTPUT_RESULT_PEAK_FORCE, &peak) != SOFTANVIL_STATUS_OK)
        return 1;
    snprintf(digest, sizeof digest, "%016" PRIx64, softanvil_kernel_digest());
    printf("version %s, kernel digest %s, peak force %.0f N\n", softanvil_version_text(), digest, peak);
    free(anvil);
    /* The header and the package say the same as the library. */
    return softanvil_kernel_digest() != SOFTANVIL_KERNEL_DIGEST || (argc > 1 && strcmp(argv[1], digest) != 0);
}
