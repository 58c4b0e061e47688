"""How long the page takes from the move of a slider to the picture of the drop, for docs/performance.md: a measurement, no test.

    tests/page/run.sh target/release VENV latency.py -s
"""

from statistics import median

from conftest import MOVES


def test_from_input_to_picture(open_page):
    page = open_page()
    # The first are those of a compiler that warms up.
    page.evaluate(MOVES, [20, 0])
    print()
    for pause, what in ((0, "drawn on"), (100, "one move")):
        times = page.evaluate(MOVES, [60, pause])
        print(f"input to picture, {what}: {min(times):.0f} ms at best, {median(times):.0f} ms in the middle")
