"""What the package costs, as docs/python.md has it: measure.py [MODEL.fmu], with fmpy and felupe installed for the comparisons.

Times are those of processors, the least of several: what else runs on the machine only adds to them.
"""

import sys
import time

import numpy as np

import softanvil as sa


def least(works, times):
    """The least seconds of processors that each of `works` takes; they take turns."""
    taken = [float("inf")] * len(works)
    for _ in range(times):
        for place, work in enumerate(works):
            start = time.process_time()
            work()
            taken[place] = min(taken[place], time.process_time() - start)
    return taken


def overhead(times=100):
    """What `run` adds to a drop: recording 300 samples, the table of results, the way there and back."""
    scenario = sa.preset("study")
    steps = sa.run(scenario).steps
    settings = scenario._settings

    def kernel():
        sa._softanvil.Simulation(settings).step(steps, 0.0, None, None)

    works = [kernel, lambda: sa.run(scenario), lambda: sa.run(scenario).trace]
    alone, whole, traced = least(works, times)
    print(f"a drop: model and steps {1e3 * alone:.2f} ms, run {1e3 * whole:.2f} ms, overhead {100 * (whole / alone - 1):.1f} %")
    print(f"with its trace as a data frame: {1e3 * traced:.2f} ms")
    return whole


def many(drops=64):
    """Many drops: `run_many` and `sweep` on all cores beside one after the other."""
    scenarios = [sa.preset("study") for _ in range(drops)]
    design = sa.design({"impactor.energy": (14.69, 14.71)}, np.linspace(0, 1, drops)[:, None])
    base = sa.preset("study")
    one, batch, swept = least([lambda: [sa.run(scenario) for scenario in scenarios], lambda: sa.run_many(scenarios),
                               lambda: sa.sweep(base, design, progress=False, batch=drops)], 8)
    print(f"{drops} drops, a drop: run {1e3 * one / drops:.2f} ms, run_many {1e3 * batch / drops:.2f} ms, "
          f"sweep {1e3 * swept / drops:.2f} ms")


def fmpy_loop(model):
    """The same drop by fmpy, with the FMU unpacked and its description read once, and a trace every 50 us."""
    import fmpy

    folder, description = fmpy.extract(model), fmpy.read_model_description(model)
    scenario = sa.preset("study")

    def drop():
        fmpy.simulate_fmu(folder, model_description=description, start_values={"impactor.drop_energy": 14.7},
                          stop_time=15e-3, output_interval=50e-6,
                          output=["contact.force", "impactor.position", "result.peak_force"])

    fmu, whole = least([drop, lambda: sa.run(scenario)], 20)
    print(f"fmpy: {1e3 * fmu:.1f} ms a drop with a trace, {fmu / whole:.1f} times that of run")


def felupe_block():
    """A block of neo-Hookean silicone pressed by a flat plate, quasi-static in 10 steps, in felupe, which has no impact; the same
    mesh in the kernel, dynamic, as an impact."""
    import felupe as fem

    def static():
        mesh = fem.Rectangle(a=(0, 0), b=(0.03, 0.015), n=(25, 6))
        region = fem.RegionQuad(mesh)
        field = fem.FieldContainer([fem.FieldPlaneStrain(region, dim=2)])
        solid = fem.SolidBody(fem.NeoHooke(mu=3e5, bulk=1.5e7), field)
        boundaries = {"bottom": fem.Boundary(field[0], fy=0, skip=(False, False)),
                      "move": fem.Boundary(field[0], fy=0.015, skip=(False, False))}
        moves = fem.math.linsteps([0, -1], num=10) * 0.003
        table = np.zeros((len(moves), 2))
        table[:, 1] = moves
        ramp = {boundaries["move"]: moves}
        fem.CharacteristicCurve(steps=[fem.Step(items=[solid], ramp=ramp, boundaries=boundaries)],
                                boundary=boundaries["move"]).evaluate(verbose=0)

    block = sa.preset("block").update({"geometry.block_width": 0.06, "layers[0].thickness": 0.015, "impactor.energy": 3.0,
                                       "mesh.element_size": 2.5e-3})
    result = sa.run(block)
    quasi, drop = least([static, lambda: sa.run(block)], 3)
    print(f"felupe: {1e3 * quasi:.0f} ms for 10 static steps of 120 cells; an impact of {result.elements} triangles, "
          f"{result.steps} steps: {1e3 * drop:.1f} ms")


if __name__ == "__main__":
    overhead()
    many()
    if sys.argv[1:]:
        fmpy_loop(sys.argv[1])
        felupe_block()
