"""A calibration on a cluster of Dask: calibrate_on_cluster.py [SCHEDULER].

`sa.calibrate` searches on the cores of one machine. On a cluster scipy's differential evolution asks for a generation at once,
which the workers simulate. What is searched for are two coefficients of the silicone, from peak force and deformation of two drops.
"""

import functools
import sys

import numpy as np
from distributed import Client
from scipy.optimize import differential_evolution

import softanvil as sa

#: Coefficients, Pa, with their ranges in powers of ten.
SEARCHED = {"silicone.c10": (4.5, 5.5), "silicone.c20": (4.5, 5.7)}
ENERGIES = (4.9, 9.8)


def base():
    """What is dropped: a coarse mesh for a start."""
    return sa.preset("study").update({"mesh.element_size": "6 mm"})


def numbers(point):
    """Peak force and deformation of the drops, with the coefficients at `point`; NaN where one fails."""
    values = dict(zip(SEARCHED, (float(10.0**power) for power in point), strict=True))
    scenarios = [base().update({**values, "impactor.energy": energy}) for energy in ENERGIES]
    results = sa.run_many(scenarios, threads=1, errors="return")
    return [number for r in results for number in
            ((r.peak_force, r.max_deformation) if isinstance(r, sa.Result) else (np.nan, np.nan))]


def score(point, measured):
    """Root mean square of the relative errors."""
    errors = np.array(numbers(point)) / measured - 1
    return float(np.sqrt(np.mean(errors**2))) if np.isfinite(errors).all() else 1e3


def calibrate(client, measured, generations=20):
    """The best point that differential evolution finds."""
    def on_cluster(function, points):
        return client.gather(client.map(function, list(points), pure=False))

    return differential_evolution(functools.partial(score, measured=np.array(measured)), list(SEARCHED.values()), rng=1,
                                  popsize=8, maxiter=generations, tol=1e-3, polish=False, updating="deferred", workers=on_cluster)


if __name__ == "__main__":
    with Client(*sys.argv[1:2]) as client:
        found = calibrate(client, numbers((np.log10(1.48e5), np.log10(1.32e5))))
        print({name: round(10.0**power) for name, power in zip(SEARCHED, found.x, strict=True)}, found.fun)
