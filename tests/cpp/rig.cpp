// Three drops from C++17 by softanvil.hpp: in memory of its own and in static memory, with exceptions and without;
// saved and restored midway.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <stdexcept>
#include <utility>
#include <vector>

#include "rig.h"
#include "softanvil.hpp"

namespace {

using softanvil::Scenario;
using softanvil::Simulation;

alignas(64) std::array<std::byte, 1 << 18> memory;

void check(bool holds, const char *what)
{
    if (!holds) {
        throw std::runtime_error(what);
    }
}

Scenario scenario(double energy)
{
    auto scenario = Scenario::preset(SOFTANVIL_PRESET_STUDY).value();
    scenario.set(SOFTANVIL_PARAMETER_IMPACTOR_DROP_BY, SOFTANVIL_IMPACTOR_DROP_BY_ENERGY).value();
    scenario.set("impactor.drop_energy", energy).value();
    check(scenario.get("impactor.drop_energy").value() == energy, "what was set can be read");
    return scenario;
}

rig_result result_of(const Simulation &drop, double energy)
{
    return {
        energy,
        drop.output(SOFTANVIL_OUTPUT_RESULT_PEAK_FORCE).value(),
        drop.output(SOFTANVIL_OUTPUT_RESULT_MAX_DEFORMATION).value(),
        drop.output(SOFTANVIL_OUTPUT_RESULT_IMPACT_DURATION).value(),
        drop.output("result.impulse").value(),
        drop.output("energy.residual").value(),
        drop.trace_hash().value(),
    };
}

void rig(double energy)
{
    auto whole = Simulation::make(scenario(energy)).value();
    whole.run(RIG_DURATION).value();
    const rig_result result = result_of(whole, energy);
    rig_print(&result);
    check(result.residual < RIG_RESIDUAL * energy && -result.residual < RIG_RESIDUAL * energy, "residual is small");

    auto cut = Simulation::make(scenario(energy)).value();
    for (int i = 1; i <= 900; i++) {
        cut.run_until(i * (RIG_DURATION / 900)).value();
    }
    check(cut.trace_hash().value() == result.trace_hash, "times between steps change nothing");
    check(!cut.run_until(1e-3), "time does not go back");

    auto first = Simulation::make(scenario(energy)).value();
    first.run(5e-3).value();
    const std::vector<std::uint8_t> snapshot = first.save().value();
    auto second = Simulation::in(memory, scenario(energy)).value();
    second.restore(snapshot).value();
    const Simulation moved_from = std::exchange(first, std::move(second));
    first.run(RIG_DURATION - 5e-3).value();
    check(first.trace_hash().value() == result.trace_hash, "another simulation continues a snapshot with the same bits");
}

// The trace has every sample, and its largest force is the peak.
void traced()
{
    auto drop = Simulation::make(scenario(14.7)).value();
    int samples = 0;
    double peak = 0.0;
    drop.run_traced(RIG_DURATION, [&](const Simulation::Reader &now) {
            peak = std::fmax(peak, now.output(SOFTANVIL_OUTPUT_CONTACT_FORCE).value());
            samples++;
        }).value();
    check(samples == 300, "one call per sample");
    check(peak == drop.output(SOFTANVIL_OUTPUT_RESULT_PEAK_FORCE).value(), "the trace holds the peak");

    drop.reset().value();
    drop.run_traced(RIG_DURATION, [](const Simulation::Reader &now) { return now.time().value() < 1e-3; }).value();
    check(drop.time().value() == 1e-3, "a trace ends a run");
    bool thrown = false;
    try {
        drop.run_traced(1e-3, [](const Simulation::Reader &) { throw std::out_of_range("enough"); }).value();
    } catch (const std::out_of_range &) {
        thrown = true;
    }
    check(thrown && drop.time().value() == 1e-3 + 50e-6, "an exception passes through a run");
}

// Fields where they lie and copied, and what they say about each other.
void fields()
{
    auto drop = Simulation::make(scenario(14.7)).value();
    drop.run(4e-3).value();
    const auto now = drop.read();
    const auto y = now.view(SOFTANVIL_FIELD_NODE_DISPLACEMENT, 1).value();
    check(y.stored() && y.rows() > 2 && y.columns() > 2, "displacements lie in memory");
    check(std::fabs(y(0, 0)) < 1e-9, "the core holds the node under the face");
    const double top = y(y.rows() - 1, 0);
    const double depth = drop.output(SOFTANVIL_OUTPUT_IMPACTOR_DEFORMATION).value();
    check(depth > 3e-3 && std::fabs(top + depth) < 1e-9, "the top moves with the face");

    std::vector<double> both(2 * y.size());
    now.read(SOFTANVIL_FIELD_NODE_DISPLACEMENT, 0, both, 2).value();
    now.read(SOFTANVIL_FIELD_NODE_DISPLACEMENT, 1, softanvil::Span<double>(both.data() + 1, both.size() - 1), 2).value();
    check(both[2 * (y.size() - y.columns()) + 1] == top, "copied where they were wanted");
    const auto [rest, position] = std::pair(now.read(SOFTANVIL_FIELD_NODE_REFERENCE_POSITION, 1).value(),
                                            now.read(SOFTANVIL_FIELD_NODE_POSITION, 1).value());
    for (std::size_t i = 0; i < y.size(); i++) {
        check(position[i] == rest[i] + both[2 * i + 1], "position is rest and displacement");
    }

    double force = 0.0;
    for (const double normal : now.read(SOFTANVIL_FIELD_SURFACE_CONTACT_FORCE).value()) {
        force += normal;
    }
    const double step_force = drop.output(SOFTANVIL_OUTPUT_CONTACT_FORCE_STEP).value();
    check(step_force > 100.0 && 2.0 * force == step_force, "half the section carries half the force");
    const auto pressure = now.read(SOFTANVIL_FIELD_SURFACE_CONTACT_PRESSURE).value();
    check(pressure.front() > 1e4 && pressure.back() == 0.0, "the contact presses in the middle");

    const auto mises = now.read(SOFTANVIL_FIELD_ELEMENT_VON_MISES_STRESS).value();
    const auto mean = now.read(SOFTANVIL_FIELD_ELEMENT_PRESSURE).value();
    std::vector<std::vector<double>> principal;
    for (std::uint32_t component = 0; component < 3; component++) {
        principal.push_back(now.read(SOFTANVIL_FIELD_ELEMENT_PRINCIPAL_STRESS, component).value());
    }
    for (std::size_t i = 0; i < mises.size(); i++) {
        const double a = principal[0][i], b = principal[1][i], c = principal[2][i];
        const double expected = std::sqrt(0.5 * ((a - b) * (a - b) + (b - c) * (b - c) + (c - a) * (c - a)));
        const double scale = 1.0 + std::fabs(a) + std::fabs(b) + std::fabs(c);
        check(std::fabs(mises[i] - expected) < 1e-9 * scale, "von Mises of the principal stresses");
        check(std::fabs(mean[i] + (a + b + c) / 3.0) < 1e-9 * scale, "pressure of the principal stresses");
    }
    check(mean.at(mean.size() - 2 * (y.columns() - 1)) > 1e4, "the middle is under pressure");
}

// A block pressed slowly without friction: the stress under the face is the contact pressure, and none is across it.
void uniform_compression()
{
    auto block = Scenario::preset(SOFTANVIL_PRESET_STUDY).value();
    for (const auto &[parameter, value] : std::initializer_list<std::pair<const char *, double>>{
             {"geometry.shape", SOFTANVIL_GEOMETRY_SHAPE_BLOCK},
             {"geometry.block_width", 0.03},
             {"core.interface", SOFTANVIL_CORE_INTERFACE_FRICTIONAL},
             {"core.friction_coefficient", 0.0},
             {"face.friction_coefficient", 0.0},
             {"impactor.motion", SOFTANVIL_IMPACTOR_MOTION_DRIVEN},
             {"impactor.gap", 0.0},
             {"mesh.element_size", 3e-3},
         }) {
        block.set(parameter, value).value();
    }
    auto press = Simulation::make(block).value();
    auto input = press.input().value();
    for (int i = 1; i <= 4000; i++) {
        const double part = i < 2000 ? i / 2000.0 : 1.0;
        input.driven_position = -1.5e-3 * part * part * (3.0 - 2.0 * part);
        press.step(20, &input).value();
    }
    const auto pressure = press.read().read(SOFTANVIL_FIELD_SURFACE_CONTACT_PRESSURE).value();
    const auto across = press.read().read(SOFTANVIL_FIELD_ELEMENT_PRINCIPAL_STRESS, 0).value();
    const auto along = press.read().read(SOFTANVIL_FIELD_ELEMENT_PRINCIPAL_STRESS, 1).value();
    for (std::size_t i = 0; i < along.size(); i++) {
        // What is left of the waves is below 3 %.
        check(std::fabs(along[i] + pressure.front()) < 0.03 * pressure.front(), "stress along the pressure");
        check(std::fabs(across[i]) < 0.03 * pressure.front(), "no stress across it");
    }
}

// Failures without exceptions.
void refusals()
{
    auto wrong = scenario(14.7);
    const auto refused = wrong.set("impactor.mass", -1.0);
    check(!refused && refused.error().status() == SOFTANVIL_STATUS_ILLEGAL_VALUE, "an illegal value is refused");
    check(refused.error().details().parameter == SOFTANVIL_PARAMETER_IMPACTOR_MASS, "and named");
    check(!Scenario::preset(99), "an unknown preset is refused");
    std::array<std::byte, 64> tiny{};
    check(!Simulation::in(tiny, scenario(14.7)), "too little memory is refused");
    const auto drop = Simulation::make(scenario(14.7)).value();
    check(drop.output("force").error().status() == SOFTANVIL_STATUS_UNKNOWN_NAME, "an unknown output is refused");
    check(!drop.read().view(SOFTANVIL_FIELD_NODE_DISPLACEMENT, 2), "an unknown component is refused");
    check(!drop.read().view(SOFTANVIL_FIELD_ELEMENT_PRESSURE).value().stored(), "a computed field has a shape only");
}

} // namespace

int main()
{
    try {
        check(softanvil_version() == SOFTANVIL_VERSION, "header and library have the same version");
        for (const double energy : RIG_ENERGIES) {
            rig(energy);
        }
        traced();
        fields();
        uniform_compression();
        refusals();
    } catch (const std::exception &failure) {
        std::fprintf(stderr, "failed: %s\n", failure.what());
        return 1;
    }
    return 0;
}
