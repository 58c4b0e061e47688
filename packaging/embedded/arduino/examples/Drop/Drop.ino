// The study's drop: its peak force, which is 5444 N on every machine. A step needs up to 32768 bytes of stack: where the core gives
// loop() less, run the simulation in a task of its own.
#include <Arduino.h>
#include <softanvil.h>

alignas(64) static unsigned char memory[72 << 10];

void setup() {
    SoftanvilScenario scenario;
    SoftanvilSimulation *anvil;
    SoftanvilError error;
    size_t size, alignment;
    double peak = 0.0;

    Serial.begin(115200);
    softanvil_scenario_default(SOFTANVIL_PRESET_STUDY, &scenario);
    softanvil_memory_size(&scenario, &size, &alignment, &error);
    if (softanvil_init(memory, sizeof memory, &scenario, &anvil, &error) != SOFTANVIL_STATUS_OK ||
        softanvil_run(anvil, 15e-3, NULL, &error) != SOFTANVIL_STATUS_OK) {
        Serial.println(error.text);
        return;
    }
    softanvil_output(anvil, SOFTANVIL_OUTPUT_RESULT_PEAK_FORCE, &peak);
    Serial.print("peak force in N: ");
    Serial.println((long)(peak + 0.5));
}

void loop() {}
