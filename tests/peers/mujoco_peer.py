"""MuJoCo: a flexible body of Saint Venant-Kirchhoff triangles or tetrahedra, soft contact constraints.

Its triangles are in plane stress, with moduli that make them as stiff as plane strain against compression. Its z is the
height.
"""
import time

import mujoco

import problem

DT = 5e-6
# Half width, length and height of the impactor's box, m.
BOX = (70e-3, 100e-3, 10e-3)
# A vertex collides as a sphere of this radius, m.
RADIUS = 1e-4
# As stiff as plane strain against compression with sides held; its Poisson's ratio of nearly 2/3 is refused.
PLANE_POISSON = 0.49
PLANE_YOUNG = (problem.BULK + 4 / 3 * problem.SHEAR) * (1 - PLANE_POISSON**2)


def elasticity(of):
    if of.slices:
        return f'young="{problem.YOUNG:.9g}" poisson="{problem.POISSON:.9g}"'
    return f'young="{PLANE_YOUNG:.9g}" poisson="{PLANE_POISSON}" thickness="{of.length}" elastic2d="stretch"'


def mirrored(corners):
    """Tetrahedra of positive volume again, whose y and z are exchanged."""
    return (corners[1], corners[0], *corners[2:]) if len(corners) == 4 else corners


def text(of):
    points = " ".join(f"{x:.9g} {z[0] if z else 0:.9g} {y:.9g}" for x, y, *z in of.nodes)
    elements = " ".join(str(corner) for corners in of.elements for corner in mirrored(corners))
    core = " ".join(map(str, of.held(1)))
    contact = f'condim="1" solref="{2e-5} 1" solimp="0.99 0.999 1e-5"'
    return f"""
    <mujoco>
      <option timestep="{DT}" gravity="0 0 {-problem.GRAVITY}" integrator="Euler" solver="CG" iterations="20"/>
      <size memory="200M"/>
      <worldbody>
        <body name="impactor" pos="0 0 {problem.START + RADIUS + BOX[2]}">
          <joint name="fall" type="slide" axis="0 0 1"/>
          <geom name="face" type="box" size="{BOX[0]} {BOX[1]} {BOX[2]}" mass="{problem.MASS / of.parts}" friction="0 0 0"
                {contact}/>
        </body>
        <flexcomp name="layer" type="direct" dim="{of.axes}" point="{points}" element="{elements}"
                  mass="{of.volume * problem.DENSITY:.9g}" radius="{RADIUS}" rgba="1 0 0 1">
          <elasticity {elasticity(of)}/>
          <contact selfcollide="none" {contact}/>
          <pin id="{core}"/>
        </flexcomp>
      </worldbody>
    </mujoco>"""


def build(of):
    spec = mujoco.MjSpec.from_string(text(of))
    core = set(of.held(1))
    for axis, name in ((0, "x"), (2, "z")):
        for node in of.held(axis):
            if node not in core:
                joints = spec.body(f"layer_{node}").joints
                # Its second axis is the problem's z.
                spec.delete(next(joint for joint in joints if joint.axis[axis // 2] == 1.0))
    return spec.compile()


def peer(of):
    m = build(of)
    data = mujoco.MjData(m)
    data.qvel[m.jnt_dofadr[m.joint("fall").id]] = -problem.SPEED
    steps = round(problem.UNTIL_COLLAPSE / DT)
    before = time.process_time()
    for _ in range(steps):
        mujoco.mj_step(m, data)
    computing = time.process_time() - before
    what = "St. Venant-Kirchhoff" + ("" if of.slices else " in plane stress") + ", contact constraints"
    return problem.row(of, "MuJoCo flex", mujoco.__version__, f"{what}; {problem.FIRST}", steps, computing)


if __name__ == "__main__":
    problem.main(peer)
