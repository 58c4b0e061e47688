/*
 * Softanvil for C++17: softanvil.h with lifetimes, types and results. It adds nothing that C cannot do.
 *
 * A drop:
 *
 *     auto scenario = softanvil::Scenario::preset(SOFTANVIL_PRESET_STUDY).value();
 *     scenario.set(SOFTANVIL_PARAMETER_IMPACTOR_DROP_BY, SOFTANVIL_IMPACTOR_DROP_BY_ENERGY).value();
 *     scenario.set("impactor.drop_energy", 14.7).value();
 *     auto simulation = softanvil::Simulation::make(scenario).value();
 *     simulation.run(15e-3).value();
 *     double peak = simulation.output(SOFTANVIL_OUTPUT_RESULT_PEAK_FORCE).value();
 *
 * Conventions, besides those of softanvil.h:
 *
 * - Failures. Every function that can fail returns a `Result`. Whoever likes exceptions calls `value()`, which throws
 *   an `Error`; whoever does not asks `if (result)` and reads `*result` or `result.error()`. Nothing else throws, but
 *   for std::bad_alloc where a std::vector is returned, and what the caller's own functions throw. Compiled without
 *   exceptions, `value()` of a failure aborts.
 * - Memory. `Simulation::in` uses memory of the caller, who keeps it longer than the simulation; `Simulation::make`
 *   takes it from the heap and gives it back. A `Simulation` can be moved, not copied: a copy is a snapshot restored.
 * - Threads. As in C: one thread at a time per object, `const` functions at the same time.
 */

#ifndef SOFTANVIL_HPP
#define SOFTANVIL_HPP

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "softanvil.h"

namespace softanvil {

/** Why a call was refused. */
class Error : public std::exception {
public:
    explicit Error(const SoftanvilError &details) noexcept : details_(details) {}

    /** A failure of a function that gives no details. */
    explicit Error(SoftanvilStatus status) noexcept : details_{}
    {
        details_.status = static_cast<std::int32_t>(status);
        details_.parameter = details_.element = SOFTANVIL_NONE;
        const char *text = softanvil_status_text(details_.status);
        for (std::size_t i = 0; text[i] != 0 && i + 1 < sizeof details_.text; i++) {
            details_.text[i] = text[i];
        }
    }

    /** One line with the value, its unit and what is legal. */
    const char *what() const noexcept override { return details_.text; }
    SoftanvilStatus status() const noexcept { return static_cast<SoftanvilStatus>(details_.status); }
    /** Everything that C learns. The numbers are 0 if the function gives no details. */
    const SoftanvilError &details() const noexcept { return details_; }

private:
    SoftanvilError details_;
};

namespace detail {

[[noreturn]] inline void raise(const Error &error)
{
#ifdef __cpp_exceptions
    throw error;
#else
    static_cast<void>(error);
    std::abort();
#endif
}

} // namespace detail

/** A value, or why there is none. */
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : value_(std::move(value)) {}
    Result(const Error &error) : error_(error) {}

    explicit operator bool() const noexcept { return value_.has_value(); }
    /** Why there is no value; only if there is none. */
    const Error &error() const { return assert(error_.has_value()), *error_; }
    /** The value; only if there is one. */
    T &operator*() & { return assert(value_.has_value()), *value_; }
    const T &operator*() const & { return assert(value_.has_value()), *value_; }
    T *operator->() { return &**this; }
    const T *operator->() const { return &**this; }

    /** The value; throws the error if there is none. */
    T &value() & { return check(), *value_; }
    const T &value() const & { return check(), *value_; }
    T value() && { return check(), std::move(*value_); }

private:
    void check() const
    {
        if (error_) {
            detail::raise(*error_);
        }
    }

    std::optional<T> value_;
    std::optional<Error> error_;
};

/** Done, or why not. */
template <>
class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(const Error &error) : error_(error) {}

    explicit operator bool() const noexcept { return !error_.has_value(); }
    /** Why it was not done; only if it was not. */
    const Error &error() const { return assert(error_.has_value()), *error_; }
    /** Throws the error if there is one. */
    void value() const
    {
        if (error_) {
            detail::raise(*error_);
        }
    }

private:
    std::optional<Error> error_;
};

/** Items side by side that somebody else owns: a part of what C++20 calls std::span. */
template <class T>
class Span {
public:
    constexpr Span() noexcept = default;
    constexpr Span(T *data, std::size_t size) noexcept : data_(data), size_(size) {}
    template <std::size_t N>
    constexpr Span(T (&array)[N]) noexcept : data_(array), size_(N) {}
    /** Anything with data() and size(), such as std::vector, std::array or std::span. */
    template <class C, class = std::enable_if_t<std::is_convertible_v<decltype(std::declval<C &>().data()), T *>>>
    constexpr Span(C &&container) noexcept : data_(container.data()), size_(container.size())
    {
    }

    constexpr T *data() const noexcept { return data_; }
    constexpr std::size_t size() const noexcept { return size_; }
    constexpr bool empty() const noexcept { return size_ == 0; }
    constexpr T *begin() const noexcept { return data_; }
    constexpr T *end() const noexcept { return data_ + size_; }
    constexpr T &operator[](std::size_t i) const { return assert(i < size_), data_[i]; }

private:
    T *data_ = nullptr;
    std::size_t size_ = 0;
};

/** One component of a field, inside the simulation's memory, for as long as that is neither moved nor given back. */
class View {
public:
    explicit View(const SoftanvilView &view) noexcept : view_(view) {}

    std::size_t rows() const noexcept { return view_.rows; }
    std::size_t columns() const noexcept { return view_.columns; }
    std::size_t size() const noexcept { return view_.rows * view_.columns; }
    /** Whether the numbers lie in memory; those of other fields are computed by `Simulation::read`. */
    bool stored() const noexcept { return view_.data != nullptr; }
    /** The number at a place; only if the field is stored. */
    double operator()(std::size_t row, std::size_t column) const
    {
        assert(stored() && row < rows() && column < columns());
        return view_.data[row * view_.row_stride + column * view_.column_stride];
    }
    /** The view as C has it. */
    const SoftanvilView &get() const noexcept { return view_; }

private:
    SoftanvilView view_;
};

namespace detail {

/** Calls a function that gives no details. */
template <class F>
Result<void> status(F call)
{
    const SoftanvilStatus status = call();
    return status == SOFTANVIL_STATUS_OK ? Result<void>() : Result<void>(Error(status));
}

/** Calls a function that takes a `SoftanvilError`. */
template <class F>
Result<void> explained(F call)
{
    SoftanvilError error;
    return call(&error) == SOFTANVIL_STATUS_OK ? Result<void>() : Result<void>(Error(error));
}

/** Calls a function that writes a T. */
template <class T, class F>
Result<T> read(F call)
{
    T value{};
    const SoftanvilStatus status = call(&value);
    return status == SOFTANVIL_STATUS_OK ? Result<T>(value) : Result<T>(Error(status));
}

} // namespace detail

/** Description of a drop test. */
class Scenario {
public:
    /** A ready-made scenario, a `SoftanvilPreset`. */
    static Result<Scenario> preset(std::uint32_t preset)
    {
        Scenario scenario;
        const SoftanvilStatus status = softanvil_scenario_default(preset, &scenario.scenario_);
        return status == SOFTANVIL_STATUS_OK ? Result<Scenario>(scenario) : Result<Scenario>(Error(status));
    }

    /** Sets a `SoftanvilParameter`, in its SI unit; a refused value changes nothing. */
    Result<void> set(std::uint32_t parameter, double value)
    {
        return detail::explained(
            [&](SoftanvilError *error) { return softanvil_scenario_set(&scenario_, parameter, value, error); });
    }

    /** Sets a parameter by name, such as "impactor.mass". */
    Result<void> set(const char *name, double value)
    {
        return detail::explained(
            [&](SoftanvilError *error) { return softanvil_scenario_set_by_name(&scenario_, name, value, error); });
    }

    Result<double> get(std::uint32_t parameter) const
    {
        return detail::read<double>([&](double *value) { return softanvil_scenario_get(&scenario_, parameter, value); });
    }

    Result<double> get(const char *name) const
    {
        return detail::read<double>(
            [&](double *value) { return softanvil_scenario_get_by_name(&scenario_, name, value); });
    }

    /** Bytes of memory that a simulation needs, and their alignment; checks the scenario. */
    struct Memory {
        std::size_t size;
        std::size_t alignment;
    };
    Result<Memory> memory() const
    {
        Memory memory{};
        const auto done = detail::explained([&](SoftanvilError *error) {
            return softanvil_memory_size(&scenario_, &memory.size, &memory.alignment, error);
        });
        return done ? Result<Memory>(memory) : Result<Memory>(done.error());
    }

    /** The scenario as C has it. */
    SoftanvilScenario &get() noexcept { return scenario_; }
    const SoftanvilScenario &get() const noexcept { return scenario_; }

private:
    Scenario() = default;
    SoftanvilScenario scenario_{};
};

/** A simulation, in memory of its own or of the caller. */
class Simulation {
public:
    /** Builds a simulation in memory that the caller keeps longer than the simulation. */
    static Result<Simulation> in(Span<std::byte> memory, const Scenario &scenario)
    {
        return build(Block(), memory.data(), memory.size(), scenario);
    }

    /** Builds a simulation in memory from the heap. */
    static Result<Simulation> make(const Scenario &scenario)
    {
        const auto memory = scenario.memory();
        if (!memory) {
            return memory.error();
        }
        Block block(::operator new(memory->size, cache_line, std::nothrow));
        if (!block) {
            return Error(SOFTANVIL_STATUS_SHORT_BUFFER);
        }
        void *const address = block.get();
        return build(std::move(block), address, memory->size, scenario);
    }

    Simulation(Simulation &&other) noexcept
        : block_(std::move(other.block_)), simulation_(std::exchange(other.simulation_, nullptr))
    {
    }
    Simulation &operator=(Simulation &&other) noexcept
    {
        std::swap(block_, other.block_);
        std::swap(simulation_, other.simulation_);
        return *this;
    }
    Simulation(const Simulation &) = delete;
    Simulation &operator=(const Simulation &) = delete;
    ~Simulation()
    {
        if (simulation_ != nullptr) {
            softanvil_close(simulation_);
        }
    }

    /** Back to the start of the drop. */
    Result<void> reset()
    {
        return detail::status([&] { return softanvil_reset(simulation_); });
    }

    /** Lets the anvil rest for `rest` s, and the impactor fall again on it as it is. */
    Result<void> next_impact(double rest)
    {
        return detail::explained(
            [&](SoftanvilError *error) { return softanvil_next_impact(simulation_, rest, error); });
    }

    /** An input that leaves things as they are, to be changed and handed to a step. */
    Result<SoftanvilInput> input() const
    {
        return detail::read<SoftanvilInput>(
            [&](SoftanvilInput *input) { return softanvil_input_default(simulation_, input); });
    }

    /** Makes steps of the fixed time step. */
    Result<void> step(std::uint64_t steps = 1, const SoftanvilInput *input = nullptr)
    {
        return detail::explained(
            [&](SoftanvilError *error) { return softanvil_step(simulation_, steps, input, error); });
    }

    /** Makes the steps to the end of the running sampling interval. */
    Result<void> step_to_sample(const SoftanvilInput *input = nullptr)
    {
        return detail::explained(
            [&](SoftanvilError *error) { return softanvil_step_to_sample(simulation_, input, error); });
    }

    /** Makes the steps that cover `duration`, s. */
    Result<void> run(double duration, const SoftanvilInput *input = nullptr)
    {
        return detail::explained(
            [&](SoftanvilError *error) { return softanvil_run(simulation_, duration, input, error); });
    }

    /** Makes the steps to the one nearest to `time`, s since the start of the drop. */
    Result<void> run_until(double time, const SoftanvilInput *input = nullptr)
    {
        return detail::explained(
            [&](SoftanvilError *error) { return softanvil_run_until(simulation_, time, input, error); });
    }

    /**
     * As `run`, and calls `trace(const Reader &)` after every sample. It may return false to end the run there; what it
     * throws ends the run and is thrown from here.
     */
    template <class Trace>
    Result<void> run_traced(double duration, Trace &&trace, const SoftanvilInput *input = nullptr)
    {
        Tracer<Trace> tracer{trace, nullptr};
        const auto done = detail::explained([&](SoftanvilError *error) {
            return softanvil_run_traced(simulation_, duration, input, &Tracer<Trace>::call, &tracer, error);
        });
        if (tracer.thrown) {
            std::rethrow_exception(tracer.thrown);
        }
        return done;
    }

    /** What can be read from a simulation, also inside a trace. */
    class Reader {
    public:
        explicit Reader(const SoftanvilSimulation *simulation) noexcept : simulation_(simulation) {}

        /** A `SoftanvilOutput`, in its SI unit. */
        Result<double> output(std::uint32_t output) const
        {
            return detail::read<double>([&](double *value) { return softanvil_output(simulation_, output, value); });
        }

        /** An output by name, such as "contact.force". */
        Result<double> output(const char *name) const
        {
            return detail::read<double>(
                [&](double *value) { return softanvil_output_by_name(simulation_, name, value); });
        }

        /** Time since the start of the drop, s. */
        Result<double> time() const
        {
            return detail::read<double>([&](double *value) { return softanvil_time(simulation_, value); });
        }

        Result<std::uint64_t> step_index() const
        {
            return detail::read<std::uint64_t>(
                [&](std::uint64_t *value) { return softanvil_step_index(simulation_, value); });
        }

        /** The fixed time step, s. */
        Result<double> dt() const
        {
            return detail::read<double>([&](double *value) { return softanvil_dt(simulation_, value); });
        }

        Result<std::uint64_t> steps_per_sample() const
        {
            return detail::read<std::uint64_t>(
                [&](std::uint64_t *value) { return softanvil_steps_per_sample(simulation_, value); });
        }

        /** Digest of all samples so far: equal digests mean equal traces. */
        Result<std::uint64_t> trace_hash() const
        {
            return detail::read<std::uint64_t>(
                [&](std::uint64_t *value) { return softanvil_trace_hash(simulation_, value); });
        }

        /** One component of a `SoftanvilField` where it lies; only its shape if the field is computed. */
        Result<View> view(std::uint32_t field, std::uint32_t component = 0) const
        {
            SoftanvilView view;
            const SoftanvilStatus status = softanvil_field_view(simulation_, field, component, &view);
            return status == SOFTANVIL_STATUS_OK ? Result<View>(View(view)) : Result<View>(Error(status));
        }

        /** Copies one component of a field, row by row, to every `stride`-th place of `values`. */
        Result<void> read(std::uint32_t field, std::uint32_t component, Span<double> values,
                          std::size_t stride = 1) const
        {
            return detail::explained([&](SoftanvilError *error) {
                return softanvil_field_read(simulation_, field, component, values.data(), values.size(), stride, error);
            });
        }

        /** Copies one component of a field, row by row. */
        Result<std::vector<double>> read(std::uint32_t field, std::uint32_t component = 0) const
        {
            using Values = std::vector<double>;
            const auto shape = view(field, component);
            if (!shape) {
                return shape.error();
            }
            Values values(shape->size());
            const auto done = read(field, component, values);
            return done ? Result<Values>(std::move(values)) : Result<Values>(done.error());
        }

        Result<std::size_t> snapshot_size() const
        {
            return detail::read<std::size_t>(
                [&](std::size_t *size) { return softanvil_snapshot_size(simulation_, size); });
        }

        /** Saves the state into memory of at least `snapshot_size`. */
        Result<void> save(Span<std::uint8_t> bytes) const
        {
            return detail::explained([&](SoftanvilError *error) {
                return softanvil_snapshot_save(simulation_, bytes.data(), bytes.size(), error);
            });
        }

        /** Saves the state. */
        Result<std::vector<std::uint8_t>> save() const
        {
            using Bytes = std::vector<std::uint8_t>;
            const auto size = snapshot_size();
            if (!size) {
                return size.error();
            }
            Bytes bytes(*size);
            const auto done = save(Span<std::uint8_t>(bytes));
            return done ? Result<Bytes>(std::move(bytes)) : Result<Bytes>(done.error());
        }

    private:
        const SoftanvilSimulation *simulation_;
    };

    /** What can be read from this simulation. */
    Reader read() const noexcept { return Reader(simulation_); }
    /** Shorthands of `read()`. */
    Result<double> output(std::uint32_t output) const { return read().output(output); }
    Result<double> output(const char *name) const { return read().output(name); }
    Result<double> time() const { return read().time(); }
    Result<std::uint64_t> trace_hash() const { return read().trace_hash(); }
    Result<std::vector<std::uint8_t>> save() const { return read().save(); }

    /** Restores a state that was saved for the same scenario; a refused one changes nothing. */
    Result<void> restore(Span<const std::uint8_t> bytes)
    {
        return detail::explained([&](SoftanvilError *error) {
            return softanvil_snapshot_restore(simulation_, bytes.data(), bytes.size(), error);
        });
    }

    /** The simulation as C has it; NULL once it was moved from. */
    SoftanvilSimulation *get() noexcept { return simulation_; }
    const SoftanvilSimulation *get() const noexcept { return simulation_; }

private:
    static constexpr std::align_val_t cache_line{64};
    struct Free {
        void operator()(void *block) const noexcept { ::operator delete(block, cache_line); }
    };
    using Block = std::unique_ptr<void, Free>;

    template <class Trace>
    struct Tracer {
        std::remove_reference_t<Trace> &trace;
        std::exception_ptr thrown;

        static std::int32_t call(const SoftanvilSimulation *simulation, void *context)
        {
            auto &self = *static_cast<Tracer *>(context);
#ifdef __cpp_exceptions
            try {
                return self.go_on(Reader(simulation)) ? 0 : 1;
            } catch (...) {
                self.thrown = std::current_exception();
                return 1;
            }
#else
            return self.go_on(Reader(simulation)) ? 0 : 1;
#endif
        }

        bool go_on(const Reader &reader)
        {
            if constexpr (std::is_void_v<decltype(trace(reader))>) {
                trace(reader);
                return true;
            } else {
                return trace(reader);
            }
        }
    };

    Simulation(Block block, SoftanvilSimulation *simulation) noexcept
        : block_(std::move(block)), simulation_(simulation)
    {
    }

    static Result<Simulation> build(Block block, void *memory, std::size_t size, const Scenario &scenario)
    {
        SoftanvilSimulation *simulation = nullptr;
        const auto done = detail::explained([&](SoftanvilError *error) {
            return softanvil_init(memory, size, &scenario.get(), &simulation, error);
        });
        return done ? Result<Simulation>(Simulation(std::move(block), simulation)) : Result<Simulation>(done.error());
    }

    Block block_;
    SoftanvilSimulation *simulation_ = nullptr;
};

} // namespace softanvil

#endif /* SOFTANVIL_HPP */
