"""How long the page takes from the move of a slider to the picture of the drop, for docs/performance.md: a measurement, no test.

    tests/page/run.sh target/release VENV latency.py -s
"""

from statistics import median

from conftest import MOVES

# Times of the parts, ms: the default drop in the kernel until it is over, its rest, and the drawing of all that is shown.
PARTS = """() => {
    const timed = act => { const start = performance.now(); act(); return performance.now() - start; };
    const drop = { kind: "drop", asked: askedOf(chosen()), label: "" }, times = [[], [], []];
    for (let i = 0; i < 40; i++) {
        times[0].push(timed(() => kernel(drop)));
        times[1].push(timed(() => { while (kernel({ kind: "rest" }).more) {} }));
        times[2].push(timed(showAll));
    }
    return times;
}"""


def test_from_input_to_picture(open_page):
    page = open_page()
    # The first are those of a compiler that warms up.
    page.evaluate(MOVES, [20, 0])
    names = ("the drop in the kernel until it is over", "the rest of its run", "drawing")
    parts = zip(names, page.evaluate(PARTS))
    moves = [("a move right after the picture of the last one", 0), ("a move 100 ms after it", 100)]
    moves = [(what, page.evaluate(MOVES, [60, pause])) for what, pause in moves]
    print()
    for what, times in [*parts, *moves]:
        print(f"{what}: {min(times):.0f} ms at best, {median(times):.0f} ms in the middle")
