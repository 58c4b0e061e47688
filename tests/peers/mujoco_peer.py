"""MuJoCo: a two-dimensional flexible body of Saint Venant-Kirchhoff triangles, soft contact constraints.

Its triangles are in plane stress, with moduli that make them as stiff as plane strain against compression.
"""
import sys
import time

import mujoco

import problem

DT = 5e-6
# Half width, depth and height of the impactor's box, m.
BOX = (70e-3, 50e-3, 10e-3)
# A vertex collides as a sphere of this radius, m.
RADIUS = 1e-4
POISSON = 0.49


def model():
    # As stiff as plane strain against compression with sides held; its Poisson's ratio of nearly 2/3 is refused.
    plane_young = (problem.BULK + 4 / 3 * problem.SHEAR) * (1 - POISSON**2)
    points = " ".join(f"{x:.9g} 0 {y:.9g}" for x, y in problem.nodes())
    elements = " ".join(f"{a} {b} {c}" for a, b, c in problem.triangles())
    volume = problem.LENGTH * sum(area(corners) for corners in problem.triangles())
    core = " ".join(str(problem.number(u, 0)) for u in range(problem.COLUMNS + 1))
    bottom = problem.CORE_RADIUS + problem.LAYER + RADIUS + problem.GAP
    text = f"""
    <mujoco>
      <option timestep="{DT}" gravity="0 0 {-problem.GRAVITY}" integrator="Euler" solver="CG" iterations="20"/>
      <size memory="200M"/>
      <worldbody>
        <body name="impactor" pos="0 0 {bottom + BOX[2]}">
          <joint name="fall" type="slide" axis="0 0 1"/>
          <geom name="face" type="box" size="{BOX[0]} {BOX[1]} {BOX[2]}" mass="{0.5 * problem.MASS}" friction="0 0 0"
                condim="1" solref="{2e-5} 1" solimp="0.99 0.999 1e-5"/>
        </body>
        <flexcomp name="layer" type="direct" dim="2" point="{points}" element="{elements}"
                  mass="{volume * problem.DENSITY:.9g}" radius="{RADIUS}" rgba="1 0 0 1">
          <elasticity young="{plane_young:.9g}" poisson="{POISSON}" thickness="{problem.LENGTH}"
                      elastic2d="stretch"/>
          <contact selfcollide="none" condim="1" solref="{2e-5} 1" solimp="0.99 0.999 1e-5"/>
          <pin id="{core}"/>
        </flexcomp>
      </worldbody>
    </mujoco>"""
    return mujoco.MjModel.from_xml_string(text)


def area(corners):
    (ax, ay), (bx, by), (cx, cy) = (problem.nodes()[corner] for corner in corners)
    return 0.5 * ((bx - ax) * (cy - ay) - (cx - ax) * (by - ay))


def main():
    m = model()
    data = mujoco.MjData(m)
    data.qvel[m.jnt_dofadr[m.joint("fall").id]] = -problem.SPEED
    steps = round(problem.DURATION / DT)
    start, before = time.perf_counter(), time.process_time()
    for _ in range(steps):
        mujoco.mj_step(m, data)
    wall, computing = time.perf_counter() - start, time.process_time() - before
    what = "St. Venant-Kirchhoff in plane stress, contact constraints that chatter: no peak"
    return problem.row("MuJoCo flex", mujoco.__version__, what, len(problem.triangles()), steps, wall, computing, None)


if __name__ == "__main__":
    problem.write(sys.argv[1], main())
