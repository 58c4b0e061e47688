"""The report's page in Chromium, without a network: it draws, zooms and moves, and shows the numbers of the report."""

import json
import os
import re
import shutil
from pathlib import Path

import pytest
from playwright.sync_api import sync_playwright

REPORT = Path(os.environ["SOFTANVIL_WORK"]) / "report"
PLOTS = ["force-time", "force-deformation", "energy"]
CHARTS = {"force-time": "forceTime", "force-deformation": "forceDeformation", "energy": "energy"}


@pytest.fixture(scope="module")
def browser():
    with sync_playwright() as playwright:
        # Chromium's own sandbox refuses root.
        yield playwright.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])


@pytest.fixture
def scheme():
    return "light"


@pytest.fixture
def page(browser, scheme):
    context = browser.new_context(color_scheme=scheme, viewport={"width": 1100, "height": 900})
    context.set_offline(True)
    page = context.new_page()
    page.wrong = []
    page.on("console", lambda message: page.wrong.append(message.text) if message.type in ("error", "warning") else None)
    page.on("pageerror", lambda error: page.wrong.append(str(error)))
    page.on("request", lambda asked: page.wrong.append(asked.url) if not asked.url.startswith(("file:", "data:")) else None)
    page.goto((REPORT / "report.html").as_uri())
    yield page
    assert page.wrong == []
    context.close()


def colours(page, selector):
    """How many colours a canvas shows, in every eighth pixel."""
    return page.eval_on_selector(selector, """canvas => {
        const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data, found = new Set();
        for (let i = 0; i < pixels.length; i += 32) found.add((pixels[i] << 16) + (pixels[i + 1] << 8) + pixels[i + 2]);
        return found.size;
    }""")


def picture(page, selector):
    return page.eval_on_selector(selector, "canvas => canvas.toDataURL()")


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_every_plot_and_the_section_are_drawn(page, scheme):
    for plot in PLOTS:
        assert colours(page, f"#{plot} .uplot canvas") > 4, plot
        assert "(J)" in page.inner_text("#energy .u-legend") and page.is_visible(f"#{plot} .u-legend")
    page.click("#instants button:nth-child(2)")
    assert colours(page, "#section") > 8
    assert page.locator("#instants canvas").count() == 4


@pytest.mark.parametrize("plot", PLOTS)
def test_a_drag_zooms_and_a_double_click_shows_the_whole(page, plot):
    scales = lambda: page.evaluate(f"['x', 'y'].map(key => [{CHARTS[plot]}.scales[key].min, {CHARTS[plot]}.scales[key].max])")
    page.click("#play")
    before, drawn = scales(), picture(page, f"#{plot} .uplot canvas")
    over = page.locator(f"#{plot} .u-over")
    over.scroll_into_view_if_needed()
    box = over.bounding_box()
    at = lambda part: (box["x"] + part[0] * box["width"], box["y"] + part[1] * box["height"])
    page.mouse.move(*at((0.2, 0.3)))
    page.mouse.down()
    page.mouse.move(*at((0.6, 0.8)), steps=5)
    page.mouse.up()
    page.wait_for_timeout(100)
    zoomed = scales()
    assert before[0][0] <= zoomed[0][0] < zoomed[0][1] < before[0][1], (before, zoomed)
    part = (zoomed[0][1] - zoomed[0][0]) / (before[0][1] - before[0][0])
    assert abs(part - 0.4) < 0.05, (before, zoomed)
    assert zoomed[1][1] < before[1][1], (before, zoomed)
    assert picture(page, f"#{plot} .uplot canvas") != drawn
    over.dblclick()
    page.wait_for_timeout(100)
    assert scales() == before


def test_the_animation_moves_until_it_is_stopped(page):
    seen = set()
    for _ in range(5):
        seen.add((page.inner_text("#readout"), picture(page, "#section")))
        page.wait_for_timeout(120)
    assert len({text for text, _ in seen}) > 2 and len({image for _, image in seen}) > 2
    page.click("#play")
    stopped = page.inner_text("#readout"), picture(page, "#section")
    page.wait_for_timeout(200)
    assert (page.inner_text("#readout"), picture(page, "#section")) == stopped
    page.fill("#time", "0")
    assert page.inner_text("#readout").endswith(" 0 N")


def test_every_energy_and_quantity_has_its_picture(page):
    summary = json.loads((REPORT / "summary.json").read_text())["validation"]
    images = set()
    for case, number in zip(summary["cases"], (1, 2, 3)):
        page.click(f"#cases button:nth-of-type({number})")
        for quantity in (1, 2):
            page.click(f"#shades button:nth-of-type({quantity})")
            page.click("#instants button:has-text('peak force')")
            images.add(picture(page, "#section"))
        force = float(re.search(r"([\d.]+) N", page.inner_text("#readout"))[1])
        assert abs(force - case["peak_force"]) <= 0.51
        assert page.inner_text("#energy .case") == f"{case['energy']} J"
    assert len(images) == 6


def test_the_table_has_the_numbers_of_the_report(page):
    summary = json.loads((REPORT / "summary.json").read_text())["validation"]
    rows = [row.inner_text().split("\t") for row in page.locator(".wide tbody tr").all()]
    assert len(rows) == 12
    for case, row in zip(summary["cases"], rows[::4]):
        assert row[0] == f"{case['energy']} J" and row[1] == "peak force (N)"
        assert row[2] == f"{case['experiment']['peak_force']:.0f}" and row[5] == f"{case['peak_force']:.0f}"
        assert row[6] == f"{case['error_percent']['peak_force']:+.1f} %"


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_text_is_readable_on_its_ground(page, scheme):
    def luminance(colour):
        parts = [int(part) / 255 for part in re.findall(r"\d+", colour)[:3]]
        linear = [part / 12.92 if part <= 0.03928 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
        return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]

    def contrast():
        for text, ground in (("body", "body"), (".note", "section"), ("#play", "#play"), (".wide tbody td", "section")):
            style = lambda selector, key: page.eval_on_selector(selector, f"e => getComputedStyle(e).{key}")
            pair = sorted([luminance(style(text, "color")), luminance(style(ground, "backgroundColor"))])
            # WCAG 2.1, 1.4.3: 4.5 to 1.
            yield text, (pair[1] + 0.05) / (pair[0] + 0.05)

    dark = lambda: luminance(page.eval_on_selector("body", "e => getComputedStyle(e).backgroundColor")) < 0.2
    for expected in (scheme == "dark", scheme != "dark"):
        assert dark() == expected
        assert all(ratio >= 4.5 for _, ratio in contrast()), list(contrast())
        page.click("#theme")
