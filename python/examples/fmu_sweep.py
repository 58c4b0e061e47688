"""A sweep of an FMU on a cluster of Dask: fmu_sweep.py MODEL.fmu [SCHEDULER].

Any FMU for co-simulation does; this one is Softanvil's (`softanvil fmu --fmi 2`). Every worker unpacks it once.
"""

import sys

import fmpy
import pandas as pd
from distributed import Client, get_worker


def unpacked(model):
    """Folder and description of the FMU, once for every worker."""
    worker = get_worker()
    if getattr(worker, "unpacked", (None,))[0] != model:
        worker.unpacked = model, fmpy.extract(model), fmpy.read_model_description(model)
    return worker.unpacked[1:]


def drop(energy, model):
    """Peak force and impulse of one drop."""
    folder, description = unpacked(model)
    names = ["result.peak_force", "result.impulse"]
    rows = fmpy.simulate_fmu(folder, model_description=description, start_values={"impactor.drop_energy": energy},
                             stop_time=15e-3, output_interval=5e-3, output=names)
    return {"impactor.drop_energy": energy, **{name: float(rows[name][-1]) for name in names}}


def sweep(client, model, energies):
    """A row for every energy, in their order."""
    return pd.DataFrame(client.gather(client.map(drop, energies, model=model, batch_size=64)))


if __name__ == "__main__":
    with Client(*sys.argv[2:3]) as client:
        print(sweep(client, sys.argv[1], [1.0 + 0.1 * k for k in range(140)]))
