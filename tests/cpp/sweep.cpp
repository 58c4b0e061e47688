// A parameter sweep over threads: the slider's yield stress against peak force and rebound, every drop in a simulation
// of its own. The table is that of one thread to the last bit, whatever the number of threads.
//
//     sweep [THREADS] [DURATION_S]      (4 threads and 15 ms unless told)

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <thread>
#include <vector>

#include "softanvil.hpp"

namespace {

constexpr double yield_stresses[] = {0.0, 25e3, 50e3, 75e3, 100e3, 125e3, 150e3, 200e3};
constexpr std::size_t cases = sizeof yield_stresses / sizeof yield_stresses[0];

struct Row {
    double peak_force = 0.0;
    double rebound_speed = 0.0;
    std::uint64_t trace_hash = 0;
};

// One drop, on a coarse mesh; threads share nothing but the code.
Row drop(double yield_stress, double duration)
{
    auto scenario = softanvil::Scenario::preset(SOFTANVIL_PRESET_STUDY).value();
    scenario.set("mesh.element_size", 4e-3).value();
    // The preset has no slider.
    scenario.set("layers[0].slider_stiffness", 10e6).value();
    scenario.set("layers[0].slider_yield_stress", yield_stress).value();
    auto simulation = softanvil::Simulation::make(scenario).value();
    simulation.run(duration).value();
    return {simulation.output(SOFTANVIL_OUTPUT_RESULT_PEAK_FORCE).value(),
            simulation.output(SOFTANVIL_OUTPUT_RESULT_REBOUND_SPEED).value(), simulation.trace_hash().value()};
}

// The table; each thread takes the next case until none is left.
std::vector<Row> sweep(unsigned threads, double duration)
{
    std::vector<Row> rows(cases);
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < cases; i = next++) {
            rows[i] = drop(yield_stresses[i], duration);
        }
    };
    std::vector<std::thread> pool;
    for (unsigned i = 0; i < threads; i++) {
        pool.emplace_back(work);
    }
    for (auto &thread : pool) {
        thread.join();
    }
    return rows;
}

} // namespace

int main(int argc, char **argv)
{
    const unsigned threads = argc > 1 ? static_cast<unsigned>(std::strtoul(argv[1], nullptr, 10)) : 4;
    const double duration = argc > 2 ? std::strtod(argv[2], nullptr) : 15e-3;
    int failed = 0;
    try {
        // One thread first: the rows that the others must repeat. It also asks once which instructions the processor has;
        // the answer is kept in a relaxed atomic, which helgrind would take for a race between threads.
        std::vector<Row> alone;
        for (const double yield_stress : yield_stresses) {
            alone.push_back(drop(yield_stress, duration));
        }
        const auto rows = sweep(threads, duration);
        std::printf("yield stress    peak force    rebound speed\n");
        for (std::size_t i = 0; i < cases; i++) {
            std::printf("%8.0f Pa    %8.1f N    %9.3f m/s\n", yield_stresses[i], rows[i].peak_force,
                        rows[i].rebound_speed);
            const bool same = alone[i].trace_hash == rows[i].trace_hash;
            const bool distinct = i == 0 || duration < 5e-3 || rows[i].trace_hash != rows[i - 1].trace_hash;
            failed += !(same && distinct);
        }
    } catch (const std::exception &failure) {
        std::fprintf(stderr, "failed: %s\n", failure.what());
        return 1;
    }
    if (failed > 0) {
        std::fprintf(stderr, "failed: %d drops are not those of one thread\n", failed);
    }
    return failed == 0 ? 0 : 1;
}
