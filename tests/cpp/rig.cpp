// Three drops from C++17, in memory from the heap that is freed by itself, in one call each; saved and restored midway.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "rig.h"
#include "softanvil.h"

namespace {

SoftanvilError error;

void must(SoftanvilStatus status)
{
    if (status != SOFTANVIL_STATUS_OK) {
        throw std::runtime_error(std::string(softanvil_status_text(status)) + " (" + error.text + ")");
    }
}

void check(bool holds, const char *what)
{
    if (!holds) {
        throw std::runtime_error(what);
    }
}

// A simulation and its memory.
class Drop {
public:
    explicit Drop(double energy)
    {
        SoftanvilScenario scenario;
        must(softanvil_scenario_default(SOFTANVIL_PRESET_STUDY, &scenario));
        scenario.value[SOFTANVIL_PARAMETER_IMPACTOR_DROP_BY] = SOFTANVIL_IMPACTOR_DROP_BY_ENERGY;
        scenario.value[SOFTANVIL_PARAMETER_IMPACTOR_DROP_ENERGY] = energy;
        std::size_t size = 0;
        std::size_t alignment = 0;
        must(softanvil_memory_size(&scenario, &size, &alignment, &error));
        check(alignof(std::max_align_t) % alignment == 0, "any allocator aligns enough");
        memory.reset(std::malloc(size));
        check(memory != nullptr, "there is memory");
        must(softanvil_init(memory.get(), size, &scenario, &simulation, &error));
    }

    void run(double duration) { must(softanvil_run(simulation, duration, nullptr, &error)); }

    double output(std::uint32_t id) const
    {
        double value = 0.0;
        must(softanvil_output(simulation, id, &value));
        return value;
    }

    std::uint64_t hash() const
    {
        std::uint64_t value = 0;
        must(softanvil_trace_hash(simulation, &value));
        return value;
    }

    std::vector<std::uint8_t> save()
    {
        std::size_t size = 0;
        must(softanvil_snapshot_size(simulation, &size));
        std::vector<std::uint8_t> bytes(size);
        must(softanvil_snapshot_save(simulation, bytes.data(), bytes.size(), &error));
        return bytes;
    }

    void restore(const std::vector<std::uint8_t> &bytes)
    {
        must(softanvil_snapshot_restore(simulation, bytes.data(), bytes.size(), &error));
    }

private:
    struct Free {
        void operator()(void *pointer) const { std::free(pointer); }
    };
    std::unique_ptr<void, Free> memory;
    SoftanvilSimulation *simulation = nullptr;
};

rig_result result_of(const Drop &drop, double energy)
{
    return {
        energy,
        drop.output(SOFTANVIL_OUTPUT_RESULT_PEAK_FORCE),
        drop.output(SOFTANVIL_OUTPUT_RESULT_MAX_DEFORMATION),
        drop.output(SOFTANVIL_OUTPUT_RESULT_IMPACT_DURATION),
        drop.output(SOFTANVIL_OUTPUT_RESULT_IMPULSE),
        drop.output(SOFTANVIL_OUTPUT_ENERGY_RESIDUAL),
        drop.hash(),
    };
}

void rig(double energy)
{
    Drop whole(energy);
    whole.run(RIG_DURATION);
    const rig_result result = result_of(whole, energy);
    rig_print(&result);
    check(result.residual < RIG_RESIDUAL * energy && -result.residual < RIG_RESIDUAL * energy, "residual is small");

    Drop first(energy);
    first.run(5e-3);
    const std::vector<std::uint8_t> snapshot = first.save();
    Drop second(energy);
    second.restore(snapshot);
    second.run(RIG_DURATION - 5e-3);
    check(second.hash() == result.trace_hash, "another simulation continues a snapshot with the same bits");
}

} // namespace

int main()
{
    try {
        check(softanvil_version() == SOFTANVIL_VERSION, "header and library have the same version");
        for (const double energy : RIG_ENERGIES) {
            rig(energy);
        }
    } catch (const std::exception &failure) {
        std::fprintf(stderr, "failed: %s\n", failure.what());
        return 1;
    }
    return 0;
}
