/*
 * Sets the material of material.h in a scenario and prints every value of its material, by name, as the library gives it
 * back; check.py compares them with material.toml. Exits with the status of the first refusal.
 */
#include <stdio.h>

#include "material.h"

int main(void)
{
    SoftanvilScenario scenario;
    SoftanvilError error;
    SoftanvilStatus status = softanvil_scenario_default(SOFTANVIL_PRESET_STUDY, &scenario);
    uint32_t i;
    if (status == SOFTANVIL_STATUS_OK) status = softanvil_material_silicone(&scenario, &error);
    for (i = 0; status == SOFTANVIL_STATUS_OK && i < softanvil_parameter_count(); i++) {
        SoftanvilParameterInfo info;
        uint32_t parameter;
        double value;
        status = softanvil_parameter_at(i, &parameter);
        if (status == SOFTANVIL_STATUS_OK) status = softanvil_parameter_info(parameter, &info);
        if (status != SOFTANVIL_STATUS_OK || info.layer != 0) continue;
        status = softanvil_scenario_get(&scenario, parameter, &value);
        printf("%s %.17g\n", info.name, value);
    }
    return (int)status;
}
