# Written by stubs.py from the kernel's table of parameters.
from typing import Any, Generic, Literal, Protocol, SupportsFloat, TypeVar, overload

from . import _softanvil

class _Quantity(Protocol):
    """A quantity of pint."""

    @property
    def magnitude(self) -> Any: ...
    def to(self, other: Any, /) -> Any: ...

#: What a parameter takes: a number in its unit, a text ("14.7 J", or a label), or a quantity of pint.
Value = SupportsFloat | str | _Quantity

SHORT: dict[str, str]

_T = TypeVar("_T")

class Parameter(Generic[_T]):
    field: str
    unit: str
    labels: tuple[str, ...]
    minimum: float
    maximum: float
    @overload
    def __get__(self, group: None, owner: type) -> Parameter[_T]: ...
    @overload
    def __get__(self, group: Group, owner: type) -> _T: ...
    def __set__(self, group: Group, value: Value) -> None: ...
    def __delete__(self, group: Group) -> None: ...

class Choice(Generic[_T]):
    """One of several labels."""

    field: str
    labels: tuple[str, ...]
    @overload
    def __get__(self, group: None, owner: type) -> Choice[_T]: ...
    @overload
    def __get__(self, group: Group, owner: type) -> _T: ...
    def __set__(self, group: Group, value: _T) -> None: ...
    def __delete__(self, group: Group) -> None: ...

class Group:
    _settings: _softanvil.Settings
    _prefix: str
    def __init__(self, settings: _softanvil.Settings, prefix: str) -> None: ...
    def as_dict(self) -> dict[str, Any]: ...
    def _repr_html_(self) -> str: ...

class GeometryGroup(Group):
    shape: Choice[Literal["round", "block"]]
    """layer on a round core, or a flat block on a flat core (round | block)"""
    formulation: Choice[Literal["plane_strain", "axisymmetric", "solid"]]
    """kinematics: a section in plane strain or turned about its centre line, or a solid in three dimensions (plane_strain | axisymmetric | solid)"""
    section: Choice[Literal["half", "full"]]
    """half of the section with symmetry, or all of it (not of a solid) (half | full)"""
    body: Choice[Literal["prism", "revolved"]]
    """what a solid makes of its section: drawn along z, or turned about its centre line (prism | revolved)"""
    symmetry: Choice[Literal["quarter", "half", "full"]]
    """part of a solid that is meshed: x >= 0 and z >= 0 with symmetry, z >= 0 with symmetry, or all of it (quarter | half | full)"""
    ends: Choice[Literal["free", "held"]]
    """ends of a solid prism: free, or held along z as a section in plane strain (free | held)"""
    core_radius: Parameter[float]
    """radius of the rigid core (round shape) (0.001 to 1 m)"""
    length: Parameter[float]
    """largest out-of-plane thickness in plane strain (effective length of the layers), or length of a solid prism (0.001 to 10 m)"""
    block_width: Parameter[float]
    """full width, or diameter if axisymmetric (block shape) (0.0001 to 10 m)"""

class ImpactorGroup(Group):
    motion: Choice[Literal["drop", "driven", "prescribed"]]
    """a falling mass, a position given from outside with every call, or down at a speed to a depth and hold (drop | driven | prescribed)"""
    mass: Parameter[float]
    """mass of the impactor (0.001 to 10000 kg)"""
    shape: Choice[Literal["round", "rectangular", "sphere", "bar"]]
    """a flat disc, a flat rectangle, a ball (axisymmetric) or a round bar along the anvil (plane strain) (round | rectangular | sphere | bar)"""
    face_diameter: Parameter[float]
    """diameter of a round face, a sphere or a bar; the chord of a round face that covers a round section is its thickness in plane strain, and a narrower one counts as a rectangle of its area and width (0.001 to 10 m)"""
    face_width: Parameter[float]
    """width of a rectangular face across the section (0.001 to 10 m)"""
    face_length: Parameter[float]
    """length of a rectangular face or of a bar along the anvil: the thickness of the section in plane strain, up to geometry.length; over a dome a rectangular face counts as a disc of its area (0.001 to 10 m)"""
    offset: Parameter[float]
    """distance of the face's centre from the centre line, to the right (full section; half or full solid) (-1 to 1 m)"""
    gap: Parameter[float]
    """height of the face above the anvil at the start (0 to 1 m)"""
    gravity: Parameter[float]
    """acceleration of gravity (0 to 100 m/s2)"""
    rail_friction: Parameter[float]
    """friction of the rails that guide the falling mass: against its motion, and what holds it at rest (0 to 100000 N)"""
    rail_damping: Parameter[float]
    """force of the rails against the motion, over the speed (0 to 1e+06 N.s/m)"""
    drop_by: Choice[Literal["height", "energy", "speed"]]
    """which of the next three states the drop (height | energy | speed)"""
    drop_height: Parameter[float]
    """free fall before the start (0 to 100 m)"""
    height: Parameter[float]
    """free fall before the start, whatever states it; given, it states the drop (0 to 100 m)"""
    drop_energy: Parameter[float]
    """kinetic energy at the start (0 to 100000 J)"""
    energy: Parameter[float]
    """kinetic energy at the start, whatever states it; given, it states the drop (0 to 100000 J)"""
    drop_speed: Parameter[float]
    """downward speed at the start (0 to 100 m/s)"""
    speed: Parameter[float]
    """downward speed at the start, whatever states it; given, it states the drop (0 to 100 m/s)"""
    prescribed_speed: Parameter[float]
    """downward speed of the prescribed motion (1e-06 to 100 m/s)"""
    prescribed_depth: Parameter[float]
    """depth below the undeformed anvil at which the prescribed motion ends and holds (0 to 1 m)"""
    prescribed_rise: Parameter[float]
    """time over which the prescribed speed rises at the start and falls at the end, smoothly; at most travel / speed (0 to 100 s)"""

class LayerParameters(Group):
    thickness: Parameter[float]
    """thickness at rest, at least 0.01 mm (0 to 0.5 m)"""
    rows: Parameter[int]
    """rows of cells through the thickness; 0 takes as many as come nearest to mesh.element_size (0 to 10000)"""
    width: Parameter[float]
    """width along its lower side, full or, of a dome, the diameter; 0 is as wide as what is below it (0 to 10 m)"""
    interface: Choice[Literal["bonded", "frictional", "separating"]]
    """how it sits on the layer below: glued, or free to lift and slide, with friction or without (bonded | frictional | separating)"""
    friction_coefficient: Parameter[float]
    """Coulomb coefficient of a frictional interface below it (0 to 10)"""
    gap: Parameter[float]
    """distance to the layer below at rest, where they are not bonded (0 to 0.1 m)"""
    density: Parameter[float]
    """density (10 to 20000 kg/m3)"""
    law: Choice[Literal["neo_hookean", "mooney_rivlin", "yeoh", "ogden", "gent", "arruda_boyce", "hyperfoam"]]
    """hyperelastic law, isochoric but for hyperfoam (mooney_rivlin has 2, 3 or 5 parameters, by coefficients of zero) (neo_hookean | mooney_rivlin | yeoh | ogden | gent | arruda_boyce | hyperfoam)"""
    moduli: Choice[Literal["long_term", "instantaneous"]]
    """what the elastic coefficients are: after full relaxation, or before any (long_term | instantaneous)"""
    c10: Parameter[float]
    """coefficient of (I1 - 3) in neo_hookean, mooney_rivlin and yeoh (-1e+09 to 1e+09 Pa)"""
    c01: Parameter[float]
    """mooney_rivlin coefficient of (I2 - 3) (-1e+09 to 1e+09 Pa)"""
    c11: Parameter[float]
    """mooney_rivlin coefficient of (I1 - 3)(I2 - 3) (-1e+09 to 1e+09 Pa)"""
    c20: Parameter[float]
    """mooney_rivlin and yeoh coefficient of (I1 - 3)^2 (-1e+09 to 1e+09 Pa)"""
    c02: Parameter[float]
    """mooney_rivlin coefficient of (I2 - 3)^2 (-1e+09 to 1e+09 Pa)"""
    c30: Parameter[float]
    """yeoh coefficient of (I1 - 3)^3 (-1e+09 to 1e+09 Pa)"""
    ogden_mu_1: Parameter[float]
    """ogden coefficient, W = sum mu/alpha (l1^alpha + l2^alpha + l3^alpha - 3); 0 switches the term off (-1e+09 to 1e+09 Pa)"""
    ogden_alpha_1: Parameter[float]
    """ogden exponent; the shear modulus at rest is sum mu alpha / 2 (-30 to 30)"""
    ogden_mu_2: Parameter[float]
    """ogden coefficient, W = sum mu/alpha (l1^alpha + l2^alpha + l3^alpha - 3); 0 switches the term off (-1e+09 to 1e+09 Pa)"""
    ogden_alpha_2: Parameter[float]
    """ogden exponent; the shear modulus at rest is sum mu alpha / 2 (-30 to 30)"""
    ogden_mu_3: Parameter[float]
    """ogden coefficient, W = sum mu/alpha (l1^alpha + l2^alpha + l3^alpha - 3); 0 switches the term off (-1e+09 to 1e+09 Pa)"""
    ogden_alpha_3: Parameter[float]
    """ogden exponent; the shear modulus at rest is sum mu alpha / 2 (-30 to 30)"""
    gent_mu: Parameter[float]
    """gent shear modulus at rest, W = -mu Jm/2 ln(1 - (I1 - 3)/Jm) (0 to 1e+09 Pa)"""
    gent_jm: Parameter[float]
    """gent limit Jm of I1 - 3 (0.01 to 1e+06)"""
    arruda_boyce_mu: Parameter[float]
    """arruda_boyce modulus; that of shear at rest is mu (1 + 3/5 lambda_m^-2 + ...), series of five terms (0 to 1e+09 Pa)"""
    arruda_boyce_lambda_m: Parameter[float]
    """arruda_boyce stretch at which the chains are fully extended, the root of their number of links (1 to 100)"""
    foam_mu_1: Parameter[float]
    """hyperfoam modulus, W = sum 2 mu/alpha^2 (l1^alpha + l2^alpha + l3^alpha - 3 + (J^(-alpha beta) - 1)/beta); the shear modulus at rest is their sum; 0 switches the term off (-1e+09 to 1e+09 Pa)"""
    foam_alpha_1: Parameter[float]
    """hyperfoam exponent; 0 switches the term off (-30 to 30)"""
    foam_nu_1: Parameter[float]
    """hyperfoam Poisson's ratio of the term, beta = nu/(1 - 2 nu) (0 to 0.499)"""
    foam_mu_2: Parameter[float]
    """hyperfoam modulus, W = sum 2 mu/alpha^2 (l1^alpha + l2^alpha + l3^alpha - 3 + (J^(-alpha beta) - 1)/beta); the shear modulus at rest is their sum; 0 switches the term off (-1e+09 to 1e+09 Pa)"""
    foam_alpha_2: Parameter[float]
    """hyperfoam exponent; 0 switches the term off (-30 to 30)"""
    foam_nu_2: Parameter[float]
    """hyperfoam Poisson's ratio of the term, beta = nu/(1 - 2 nu) (0 to 0.499)"""
    foam_mu_3: Parameter[float]
    """hyperfoam modulus, W = sum 2 mu/alpha^2 (l1^alpha + l2^alpha + l3^alpha - 3 + (J^(-alpha beta) - 1)/beta); the shear modulus at rest is their sum; 0 switches the term off (-1e+09 to 1e+09 Pa)"""
    foam_alpha_3: Parameter[float]
    """hyperfoam exponent; 0 switches the term off (-30 to 30)"""
    foam_nu_3: Parameter[float]
    """hyperfoam Poisson's ratio of the term, beta = nu/(1 - 2 nu) (0 to 0.499)"""
    volumetric_law: Choice[Literal["quadratic", "simo"]]
    """energy of volume change: K/2 (J-1)^2, or K/4 (J^2 - 1 - 2 ln J), which no compression brings to J = 0 (quadratic | simo)"""
    volumetric_by: Choice[Literal["bulk_modulus", "poissons_ratio"]]
    """which of the next two states the compressibility (bulk_modulus | poissons_ratio)"""
    bulk_modulus: Parameter[float]
    """bulk modulus (100 to 1e+12 Pa)"""
    poissons_ratio: Parameter[float]
    """Poisson's ratio of the long-term law (0 to 0.4999)"""
    prony_g_1: Parameter[float]
    """Prony coefficient, normalised on the instantaneous modulus; 0 switches the term off (0 to 0.9999)"""
    prony_tau_1: Parameter[float]
    """relaxation time of the Prony term (1e-07 to 1e+06 s)"""
    prony_g_2: Parameter[float]
    """Prony coefficient, normalised on the instantaneous modulus; 0 switches the term off (0 to 0.9999)"""
    prony_tau_2: Parameter[float]
    """relaxation time of the Prony term (1e-07 to 1e+06 s)"""
    prony_g_3: Parameter[float]
    """Prony coefficient, normalised on the instantaneous modulus; 0 switches the term off (0 to 0.9999)"""
    prony_tau_3: Parameter[float]
    """relaxation time of the Prony term (1e-07 to 1e+06 s)"""
    prony_g_4: Parameter[float]
    """Prony coefficient, normalised on the instantaneous modulus; 0 switches the term off (0 to 0.9999)"""
    prony_tau_4: Parameter[float]
    """relaxation time of the Prony term (1e-07 to 1e+06 s)"""
    prony_g_5: Parameter[float]
    """Prony coefficient, normalised on the instantaneous modulus; 0 switches the term off (0 to 0.9999)"""
    prony_tau_5: Parameter[float]
    """relaxation time of the Prony term (1e-07 to 1e+06 s)"""
    maxwell_g_1: Parameter[float]
    """shear modulus of an additive Maxwell term; 0 switches the term off (0 to 1e+11 Pa)"""
    maxwell_beta_1: Parameter[float]
    """decay constant of the Maxwell term, one over its relaxation time (1e-06 to 1e+07 1/s)"""
    maxwell_g_2: Parameter[float]
    """shear modulus of an additive Maxwell term; 0 switches the term off (0 to 1e+11 Pa)"""
    maxwell_beta_2: Parameter[float]
    """decay constant of the Maxwell term, one over its relaxation time (1e-06 to 1e+07 1/s)"""
    maxwell_g_3: Parameter[float]
    """shear modulus of an additive Maxwell term; 0 switches the term off (0 to 1e+11 Pa)"""
    maxwell_beta_3: Parameter[float]
    """decay constant of the Maxwell term, one over its relaxation time (1e-06 to 1e+07 1/s)"""
    maxwell_g_4: Parameter[float]
    """shear modulus of an additive Maxwell term; 0 switches the term off (0 to 1e+11 Pa)"""
    maxwell_beta_4: Parameter[float]
    """decay constant of the Maxwell term, one over its relaxation time (1e-06 to 1e+07 1/s)"""
    maxwell_g_5: Parameter[float]
    """shear modulus of an additive Maxwell term; 0 switches the term off (0 to 1e+11 Pa)"""
    maxwell_beta_5: Parameter[float]
    """decay constant of the Maxwell term, one over its relaxation time (1e-06 to 1e+07 1/s)"""
    slider_stiffness: Parameter[float]
    """shear modulus G of the damping spring; 0 switches the spring-slider off (0 to 1e+11 Pa)"""
    slider_yield_stress: Parameter[float]
    """von Mises stress SIGF at which the slider slips (0 to 1e+10 Pa)"""
    tear_stretch: Parameter[float]
    """largest principal stretch at which the material begins to tear, at least 1; 0 switches tearing off (0 to 100)"""
    tear_width: Parameter[float]
    """stretch over which the deviatoric stress falls (0.001 to 10)"""
    tear_residual: Parameter[float]
    """part of the deviatoric stress that remains after the tear (0 to 1)"""
    softening_r: Parameter[float]
    """r of the softening after the first load (Ogden and Roxburgh 1999), at least 1; 0 switches it off (0 to 100)"""
    softening_m: Parameter[float]
    """m of the softening, the energy that its scale starts from (1 to 1e+09 Pa)"""
    softening_beta: Parameter[float]
    """beta of the softening, the part of the largest energy so far in its scale (0 to 10)"""

class CoreGroup(Group):
    interface: Choice[Literal["bonded", "frictional", "sliding", "separating"]]
    """how the layer sits on the core: glued, in contact with friction, on rollers (neither lifts nor rubs), or in contact that lifts and does not rub (bonded | frictional | sliding | separating)"""
    friction_coefficient: Parameter[float]
    """Coulomb coefficient of a frictional core (0 to 10)"""

class FaceGroup(Group):
    friction_coefficient: Parameter[float]
    """Coulomb coefficient under the impactor (0 to 10)"""

class MeshGroup(Group):
    element_size: Parameter[float]
    """edge length that the structured mesh aims at (1e-05 to 0.1 m)"""

class TimeGroup(Group):
    step_by: Choice[Literal["safety_factor", "given"]]
    """which of the next two states the time step (safety_factor | given)"""
    safety_factor: Parameter[float]
    """fraction of the smallest stability limit that a trial of the scenario finds (0.01 to 1)"""
    step: Parameter[float]
    """requested step; the largest whole divisor of 50 us not above it is used (1e-10 to 5e-05 s)"""
    design_compression: Parameter[float]
    """part of the layer's thickness that a driven face presses it by at most, for which the step is chosen (0.01 to 0.95)"""
    duration: Parameter[float]
    """simulated time of a run (5e-05 to 100 s)"""

class MeasurementGroup(Group):
    force_threshold: Parameter[float]
    """force that begins and ends the impact duration (0 to 100000 N)"""
    channel_class: Parameter[float]
    """channel frequency class (SAE J211, ISO 6487) of contact.force_filtered, such as 60, 180, 600 or 1000 (1 to 2000 Hz)"""

GROUPS: dict[str, type[Group]]
