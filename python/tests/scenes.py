"""The scenes of the golden traces (tests/golden/src/scenes.rs) as a user of the package says them."""

import softanvil as sa

#: Every 0.25 ms there is a record.
SAMPLES_PER_RECORD = 5


def study(energy):
    s = sa.preset("study")
    s.impactor.energy = energy
    return s


def base(material):
    """5 J on a round anvil, with the numbers of the scenes stated."""
    s = sa.preset("study")
    s.geometry.length = 0.12
    s.impactor.energy = 5.0
    s.core.interface = "bonded"
    s.face.friction_coefficient = 0.3
    s.mesh.element_size = 3e-3
    s.time.step = 2.5e-6
    s.time.duration = 6e-3
    s.measurement.force_threshold = 20.0
    give(s.layers[0], {**RUBBER, **material})
    return s


def give(layer, values):
    for name, value in values.items():
        setattr(layer, name, value)


#: What the preset's silicone has and a plain rubber has not.
OFF = {f"prony_g_{k}": 0.0 for k in range(1, 6)} | {"slider_stiffness": 0.0, "tear_stretch": 0.0}
RUBBER = OFF | {
    "density": 1070.0, "law": "mooney_rivlin", "moduli": "long_term", "volumetric_law": "quadratic", "bulk_modulus": 2e6,
    "c10": 0.12e6, "c01": 0.06e6, "c11": 0.03e6, "c20": 2e3, "c02": 12e3,
}
OF_MOONEY = ("c10", "c01", "c11", "c20", "c02")


def without(names, values):
    return {name: value for name, value in values.items() if name not in names}


def ogden():
    s = base({})
    for name in OF_MOONEY:
        del s["layers[0]." + name]
    give(s.layers[0], {"law": "ogden", "ogden_mu_1": 0.3e6, "ogden_alpha_1": 1.3, "ogden_mu_2": 2e3, "ogden_alpha_2": 5.0,
                       "ogden_mu_3": -0.02e6, "ogden_alpha_3": -2.0, "volumetric_law": "simo",
                       "prony_g_1": 0.3, "prony_tau_1": 0.5e-3, "prony_g_2": 0.2, "prony_tau_2": 20e-3})
    return s


def yeoh():
    s = base({"poissons_ratio": 0.45})
    for name in ("c01", "c11", "c02"):
        del s["layers[0]." + name]
    give(s.layers[0], {"law": "yeoh", "c10": 0.3e6, "c20": -4e3, "c30": 1e3, "moduli": "instantaneous", "prony_g_1": 0.5,
                       "prony_tau_1": 1e-3, "slider_stiffness": 10e6, "slider_yield_stress": 20e3})
    return s


def two_layers():
    s = base({})
    s.layers[0].thickness = "14 mm"
    s.layers.add("skin", **without(OF_MOONEY, RUBBER), thickness=1.5e-3)
    give(s.skin, {"density": 900.0, "bulk_modulus": 8e6, "law": "neo_hookean", "c10": 0.5e6, "maxwell_g_1": 0.4e6,
                  "maxwell_g_2": 0.2e6, "maxwell_g_3": 0.1e6, "maxwell_beta_1": 5e3, "maxwell_beta_2": 500.0,
                  "maxwell_beta_3": 20.0, "tear_stretch": 1.02, "tear_width": 0.1, "tear_residual": 0.2})
    s.time.step = 1.25e-6
    s.time.duration = 4e-3
    return s


def axisymmetric():
    s = base({"slider_stiffness": 10e6, "slider_yield_stress": 30e3})
    s.geometry.formulation = "axisymmetric"
    del s.geometry.length
    s.impactor.height = 0.05
    return s


def driven():
    s = base({"prony_g_1": 0.4, "prony_tau_1": 0.2e-3, "prony_g_2": 0.1, "prony_tau_2": 2e-3, "prony_g_3": 0.1,
              "prony_tau_3": 20e-3, "slider_stiffness": 5e6, "slider_yield_stress": 10e3})
    s.impactor.motion = "driven"
    del s.impactor.drop_energy
    s.impactor.gap = 0.5e-3
    return s


def frictional_core():
    s = base({})
    s.geometry.section = "full"
    s.impactor.offset = 4e-3
    s.impactor.speed = 1.8
    s.core.interface = "frictional"
    s.core.friction_coefficient = 0.2
    s.face.friction_coefficient = 0.15
    return s


def nothing(sim):
    sim.step()


def press(sim):
    """Down by 3.5 mm and back, in 5 ms."""
    x = sim.time_of(sim.step_index + 1) / 2.5e-3
    x = 0.0 if x > 2.0 else 2.0 - x if x > 1.0 else x
    smooth = x * x * x * (10.0 - x * (15.0 - x * 6.0))
    sim.step(position=0.5e-3 - 3.5e-3 * smooth)


def pull(sim):
    sim.step(external_force=0.5 * sim.step_index)


SCENES = {
    "drop-14.7-J": (lambda: study(14.7), nothing),
    "drop-9.8-J": (lambda: study(9.8), nothing),
    "drop-4.9-J": (lambda: study(4.9), nothing),
    "ogden": (ogden, nothing),
    "yeoh": (yeoh, nothing),
    "two-layers": (two_layers, nothing),
    "axisymmetric": (axisymmetric, nothing),
    "driven": (driven, press),
    "frictional-core": (frictional_core, pull),
}
