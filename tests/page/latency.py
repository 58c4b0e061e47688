"""How long the page takes from the move of a slider to the picture of the drop, for docs/performance.md: a measurement, no test.

    tests/page/run.sh target/release VENV latency.py -s
"""

from statistics import median, quantiles

from conftest import MOVES


def test_from_input_to_picture(open_page):
    page = open_page()
    # The first are those of a compiler that warms up.
    page.evaluate(MOVES, 20)
    times = page.evaluate(MOVES, 100)
    print(f"\ninput to picture: {min(times):.0f} ms at best, {median(times):.0f} ms in the middle, {quantiles(times, n=10)[-1]:.0f} ms in nine of ten")
