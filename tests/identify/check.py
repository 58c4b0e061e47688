"""Whether the material files of one fit say the same: check.py FOLDER FMU C_OUTPUT.

material.toml is read by Python, material.ssv by lxml after the XSD of SSP 1.0 that FMPy brings, the values of material.h
come from a C program; the numbers of the choices are those of the FMU.
"""

import sys
import tomllib
from pathlib import Path

import fmpy.ssp
from fmpy import read_model_description
from lxml import etree

folder, fmu, c_output = (Path(argument) for argument in sys.argv[1:])

material = tomllib.loads((folder / "material.toml").read_text())
# In the FMU and in C a layer goes by its place: the silicone is next to the core.
expected = {f"layers[0].{key}": value for key, value in material["silicone"].items()}
assert len(expected) > 20 and "layers[0].law" in expected, expected

schema = etree.XMLSchema(etree.parse(Path(fmpy.ssp.__file__).parent / "schema" / "SystemStructureParameterValues.xsd"))
tree = etree.parse(folder / "material.ssv")
schema.assertValid(tree)
space = {"ssv": "http://ssp-standard.org/SSP1/SystemStructureParameterValues"}
ssv = {}
for parameter in tree.iterfind(".//ssv:Parameter", space):
    (entry,) = parameter
    value = entry.get("value")
    ssv[parameter.get("name")] = float(value) if etree.QName(entry).localname == "Real" else value
assert ssv == expected, set(ssv.items()) ^ set(expected.items())

numbers = {}
for variable in read_model_description(fmu).modelVariables:
    if variable.name in expected:
        items = variable.declaredType.items if variable.type == "Enumeration" else []
        numbers[variable.name] = {item.name: float(item.value) for item in items}
assert numbers.keys() == expected.keys(), expected.keys() - numbers.keys()
c = {name: float(value) for name, value in (line.split() for line in c_output.read_text().splitlines())}
for name, value in expected.items():
    wanted = numbers[name][value] if isinstance(value, str) else value
    assert c[name] == wanted, f"{name}: {c[name]} in C, {value} = {wanted} in the file"
print(f"{len(expected)} values agree in material.toml, material.ssv and material.h")
