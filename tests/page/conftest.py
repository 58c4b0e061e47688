"""The page in Chromium, offline, from disk; every console message, error and request fails the test."""

import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest
from playwright.sync_api import sync_playwright

WORK = Path(os.environ["SOFTANVIL_WORK"])
PICTURES = Path(os.environ["SOFTANVIL_PICTURES"])
DESKTOP = {"width": 1280, "height": 900}
PHONE = {"width": 320, "height": 640}


@pytest.fixture(scope="session")
def browser():
    with sync_playwright() as playwright:
        # Chromium's own sandbox refuses root.
        yield playwright.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])


@pytest.fixture
def open_page(browser):
    """open_page(fragment, file, **context): the page, when it shows its drops."""
    opened = []

    def open_one(fragment="", file="page.html", **context):
        context = browser.new_context(**{"viewport": DESKTOP, "accept_downloads": True, **context})
        context.set_offline(True)
        page = context.new_page()
        page.wrong = []
        page.on("console", lambda message: page.wrong.append(message.text) if message.type in ("error", "warning") else None)
        page.on("pageerror", lambda error: page.wrong.append(str(error)))
        own = ("file:", "data:", "blob:")
        page.on("request", lambda asked: page.wrong.append(asked.url) if not asked.url.startswith(own) else None)
        page.goto((WORK / file).as_uri() + fragment)
        page.wait_for_selector("html[data-ready]", state="attached")
        settle(page)
        opened.append((context, page))
        return page

    yield open_one
    for context, page in opened:
        assert page.wrong == []
        context.close()


def settle(page):
    """Waits until no drop is simulated any more."""
    page.wait_for_function("drops.every(drop => drop.asked === 0)")


def cli(*arguments):
    """What the command line prints as JSON."""
    return json.loads(subprocess.run([os.environ["SOFTANVIL_CLI"], *arguments, "--json"], check=True, capture_output=True).stdout)


def numbers(page, drop=0):
    """Results of a drop by the names of their outputs, in SI, with the digest."""
    data = page.evaluate(f"drops[{drop}].data")
    return {row["output"]: row["value"] for row in data["numbers"]} | {"hash": data["hash"]}


# Moves the slider of the energy a number of times to and fro by the default, each so many ms after the picture of the one before:
# the times from input to picture, ms.
MOVES = """async ([count, pause]) => {
    const slider = document.querySelector('[aria-label="drop energy, slider"]'), drawn = () => performance.getEntriesByName("input to picture");
    const before = drawn().length;
    for (let i = 0; i < count; i++) {
        slider.value = i % 3 - 1;
        slider.dispatchEvent(new Event("input", { bubbles: true }));
        while (drawn().length <= before + i) await new Promise(wait => setTimeout(wait, 1));
        await new Promise(wait => setTimeout(wait, pause));
    }
    return drawn().slice(before).map(measure => measure.duration);
}"""
