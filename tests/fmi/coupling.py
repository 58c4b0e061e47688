"""A drop in two parts: the anvil as an FMU with a driven impactor, the falling mass in this master. Prints the deviation from
the drop with the impactor inside against the communication step, and draws docs/coupling.svg with --plot FILE.

    python coupling.py FMU [--plot FILE]
"""

import argparse
import tempfile

from fmpy import extract, read_model_description

from slave import Slave

MASS, GRAVITY, GAP, ENERGY, DURATION = 5.0, 9.81, 2e-3, 14.7, 15e-3
STEPS = [800e-6, 400e-6, 200e-6, 100e-6, 50e-6]
RESULTS = {"result.max_deformation": "largest deformation", "result.impulse": "impulse", "result.peak_force": "peak force"}


def read(anvil):
    return {name: anvil.real(name) for name in RESULTS}


def inside(anvil):
    """The mass in the FMU."""
    return read(anvil.start().run(round(DURATION / 50e-6)))


def coupled(anvil, size, with_velocity=True):
    """The mass here. It predicts its motion over the next communication step with the force that it expects, the last mean
    force carried on along a straight line, and tells the anvil where it will be at the end of that step, and how fast. Then it
    corrects itself by the impulse that came."""
    anvil.start(impactor__motion=1)
    position, velocity, impulse, forces = GAP, -((2 * ENERGY / MASS) ** 0.5), 0.0, (0.0, 0.0)
    for _ in range(int(DURATION / size + 1e-9)):
        expected = max(0.0, 2 * forces[1] - forces[0]) / MASS - GRAVITY
        anvil.set(impactor__driven_position=position + size * (velocity + 0.5 * size * expected))
        if with_velocity:
            anvil.set(impactor__driven_velocity=velocity + size * expected)
        anvil.run(1, size)
        before, impulse = impulse, anvil.real("result.impulse")
        forces = forces[1], (impulse - before) / size
        change = size * (forces[1] / MASS - GRAVITY)
        position += size * (velocity + 0.5 * change)
        velocity += change
    return read(anvil)


def deviations(fmu):
    """Relative deviation of each result, by communication step."""
    description = read_model_description(fmu)
    with tempfile.TemporaryDirectory() as folder:
        folder = extract(fmu, folder)

        def fresh(work):
            with Slave(folder, description) as anvil:
                return work(anvil)

        expected = fresh(inside)
        found = {size: fresh(lambda anvil, size=size: coupled(anvil, size)) for size in STEPS}
    return {name: [abs(found[size][name] / expected[name] - 1) for size in STEPS] for name in RESULTS}


def plot(errors, path):
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "softanvil"
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(8, 5))
    for name, label in RESULTS.items():
        axes.loglog([size * 1e6 for size in STEPS], [100 * error for error in errors[name]], "o-", label=label)
    first = errors["result.max_deformation"][0]
    second_order = [100 * first * (size / STEPS[0]) ** 2 for size in STEPS]
    axes.loglog([size * 1e6 for size in STEPS], second_order, "k--", label="second order")
    axes.minorticks_off()
    axes.set_xticks([size * 1e6 for size in STEPS], [f"{size * 1e6:.0f}" for size in STEPS])
    axes.set_yticks([0.001, 0.01, 0.1, 1, 10], ["0.001", "0.01", "0.1", "1", "10"])
    axes.set_xlabel("communication step [µs]")
    axes.set_ylabel("deviation from the drop with the impactor inside [%]")
    axes.set_title("A mass outside drives the anvil: convergence with the communication step (14.7 J)")
    axes.grid(True, which="both", alpha=0.3)
    axes.legend()
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("fmu")
    parser.add_argument("--plot", metavar="FILE")
    arguments = parser.parse_args()
    errors = deviations(arguments.fmu)
    print("step [us]  " + "  ".join(f"{label:>20}" for label in RESULTS.values()))
    for row, size in enumerate(STEPS):
        print(f"{size * 1e6:9.0f}  " + "  ".join(f"{100 * errors[name][row]:18.3f} %" for name in RESULTS))
    if arguments.plot:
        plot(errors, arguments.plot)


if __name__ == "__main__":
    main()
