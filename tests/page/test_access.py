"""For every person: the rules of WCAG 2.1, levels A and AA, as axe checks them; motion, and print in grey."""

import pytest
from axe_playwright_python.sync_playwright import Axe
from conftest import PHONE, PICTURES, settle

RULES = {"runOnly": {"type": "tag", "values": ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"]}}


def violations(page):
    found = Axe().run(page, options=RULES).response["violations"]
    return [(rule["id"], node["target"], node["failureSummary"]) for rule in found for node in rule["nodes"]]


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("viewport", [None, PHONE])
@pytest.mark.parametrize("file", ["page.html", "report/report.html"])
def test_axe_finds_nothing(open_page, file, viewport, scheme):
    page = open_page(file=file, color_scheme=scheme, **({"viewport": viewport} if viewport else {}))
    page.evaluate("document.querySelectorAll('details').forEach(one => { one.open = true; })")
    assert violations(page) == []


def test_axe_finds_nothing_where_values_are_refused_and_drops_compared(open_page):
    page = open_page("#study;impactor.mass=-1|study;impactor.drop_energy=9.8")
    page.wait_for_function("drops[1].data")
    settle(page)
    assert violations(page) == []


def test_axe_sees_a_fault(open_page):
    page = open_page()
    page.evaluate("document.getElementById('preset').previousElementSibling.remove()")
    assert any(rule == "select-name" for rule, _, _ in violations(page))


def test_all_is_reached_and_worked_by_keyboard(open_page):
    page = open_page()
    reached = set()
    for _ in range(120):
        page.keyboard.press("Tab")
        reached.add(page.evaluate("document.activeElement.id || document.activeElement.getAttribute('aria-label')"))
    for wanted in ("preset", "field-impactor.drop_energy", "toml", "file", "shade", "mesh", "play", "time", "theme", "compare",
                   "PNG: Force over time", "Whole: Energy over time", "Force over deformation: time of the cursor"):
        assert wanted in reached, (wanted, reached)
    names = page.evaluate("[...document.querySelectorAll('button')].map(button => button.getAttribute('aria-label') || button.textContent)")
    assert len(names) == len(set(names)), names


def test_nothing_moves_by_itself(open_page):
    page = open_page(reduced_motion="reduce")
    before = page.evaluate("shown.time")
    page.wait_for_timeout(300)
    assert page.evaluate("shown.time") == before


def test_lines_differ_in_grey(open_page):
    page = open_page(file="report/report.html")
    page.emulate_media(media="print")
    page.screenshot(path=PICTURES / "report-print.png", full_page=True)
    # Of each drop the number of pieces of its line, and the shapes of its marks.
    styles = page.evaluate("""[...document.querySelectorAll("#force-time .legend svg")].slice(0, 3).map(swatch =>
        [swatch.querySelector("line").getAttribute("stroke-dasharray"), swatch.lastElementChild.tagName].join())""")
    assert len(set(styles)) == 3, styles


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_lines_and_areas_stand_out_from_their_ground(open_page, scheme):
    """WCAG 2.1, 1.4.11: 3 to 1; areas by the line about them."""
    page = open_page(file="report/report.html", color_scheme=scheme)
    colours = page.evaluate("""() => {
        const ground = getComputedStyle(document.querySelector("section")).backgroundColor;
        const lines = [...document.querySelectorAll("#force-time .legend line")].map(line => getComputedStyle(line).stroke);
        const edge = getComputedStyle(document.querySelector("#energy .plot polyline")).stroke;
        return [ground, ...lines, edge];
    }""")
    ground, *lines = [luminance(colour) for colour in colours]
    for line in lines:
        low, high = sorted([ground, line])
        assert (high + 0.05) / (low + 0.05) >= 3, colours


def luminance(colour):
    parts = [int(part) / 255 for part in colour[colour.index("(") + 1 : -1].split(",")[:3]]
    linear = [part / 12.92 if part <= 0.03928 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
