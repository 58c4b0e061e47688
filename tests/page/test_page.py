"""What the page shows is what the command line computes, whatever is changed on it; and everything on it works."""

import csv
import io
import json
import os
import re
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from conftest import MOVES, PHONE, PICTURES, WORK, cli, numbers, settle

RESULTS = ["peak_force", "max_deformation", "impact_duration", "impulse"]
GOLDEN = Path(__file__).parents[1] / "golden" / "traces"


def set_field(page, name, text):
    field = page.locator(f'[id="field-{name}"]')
    if field.evaluate("field => field.tagName") == "SELECT":
        field.select_option(text)
    else:
        field.fill(text)
        field.press("Enter")
    settle(page)


def same(page, run, drop=0):
    shown = numbers(page, drop)
    assert shown["hash"] == run["trace_hash"]
    assert [shown[f"result.{key}"] for key in RESULTS] == [run[key] for key in RESULTS]


def test_the_first_thing_is_the_study_s_table_with_its_errors(open_page):
    page = open_page()
    table = page.locator("#study")
    assert table.bounding_box()["y"] < 400
    cases = cli("validate")["cases"]
    rows = table.locator("tbody tr").all()
    assert len(rows) == 12
    for case, row in zip(cases, rows[::4]):
        cells = row.locator("td").all_inner_texts()
        assert cells[0] == f"{case['experiment']['peak_force']:.0f}" and cells[3] == f"{case['peak_force']:.0f}"
        assert cells[4] == f"{case['error_percent']['peak_force']:+.1f} %"


def trace_of(page):
    """The chosen drop's trace as the page saves it, a row every 50 us."""
    text = page.evaluate("simulator.ask('csv', { kind: 'csv', asked: askedOf(chosen()) }).then(answer => answer.text)")
    return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(io.StringIO(text))]


@pytest.mark.parametrize("energy", ["14.7", "9.8", "4.9"])
def test_the_bits_are_those_of_the_golden_trace_and_of_the_command_line(open_page, energy):
    page = open_page(f"#study;impactor.drop_energy={energy}")
    assert page.inner_text("#results .hash td") == cli("run", "--energy", energy)["trace_hash"]
    golden = (GOLDEN / f"drop-{energy}-J.txt").read_text().splitlines()
    rows = [line.split() for line in golden if not line.startswith("#")]
    # A record every 0.25 ms. Its force is that of one step, which no trace has; the position depends on those of all steps.
    trace = trace_of(page)[::5]
    assert len(rows) > 50 and len(trace) >= len(rows)
    for (_, _, position, _), sample in zip(rows, trace):
        assert float(position) == sample["impactor.position [m]"]


# A drop with what is shown of it before its run is over, by its preset and the values given over it.
WITH_EARLY = """async ([preset, given]) => {
    const early = [], asked = { kind: "drop", asked: { preset, toml: "", given }, label: "" };
    return { whole: await simulator.ask("test", asked, undefined, answer => early.push(structuredClone(answer))), early };
}"""


def test_what_is_drawn_is_there_before_the_end_of_the_run(open_page):
    """The digest and the numbers are those of the whole run, whose end adds nothing to the pictures."""
    page = open_page()
    found = page.evaluate(WITH_EARLY, ["study", []])
    (early,), whole = found["early"], found["whole"]
    assert early["hash"] is None and "numbers marked * are those so far" in early["remark"]
    assert whole["hash"] == cli("run")["trace_hash"] and whole["remark"] == ""
    assert "section" not in whole and "force_time" not in whole
    peaks = [answer["numbers"][0]["value"] for answer in (early, whole)]
    forces = [force for _, force in early["force_time"]["points"]]
    assert peaks[0] == peaks[1] and abs(max(forces) - peaks[0]) < 0.01
    # Until half a millisecond after the force is below 20 N, the threshold of the study, for good: samples of 0.05 ms.
    below = next(i for i in range(len(forces)) if max(forces[i:]) <= 20)
    assert 0 < below < len(forces) and len(forces) - below <= 12


def test_a_second_impact_is_drawn_as_well(open_page):
    page = open_page()
    given = [["mesh.element_size", "0.006"], ["time.duration", "0.2"]]
    found = page.evaluate(WITH_EARLY, ["study", given])
    (early,), whole = found["early"], found["whole"]
    # The mass comes back: rebound at some 0.6 m/s, twice that over gravity later.
    assert early["force_time"]["points"][-1][0] < 20 and whole["force_time"]["points"][-1][0] > 100
    assert whole["section"] and whole["hash"]


def test_a_later_drop_does_not_wait_for_the_rest_of_one_that_is_shown(open_page):
    page = open_page()
    answers = page.evaluate("""async () => {
        const ask = (energy, early) => simulator.ask("test", { kind: "drop", asked: { preset: "study", toml: "", given: [["impactor.drop_energy", energy]] }, label: "" }, undefined, early);
        let second;
        const first = await ask("10", () => { second = ask("9.8"); });
        return [first, (await second).hash];
    }""")
    assert answers == [None, cli("run", "--energy", "9.8")["trace_hash"]]


@pytest.mark.parametrize("preset", ["study", "study-14.7", "study-incompressible", "elastic", "block", "ecoflex-00-30"])
def test_presets_are_those_of_the_command_line(open_page, preset):
    page = open_page()
    page.select_option("#preset", preset)
    settle(page)
    same(page, cli("run", "--preset", preset))


# Gives a control another value, and takes it back: what came of it, with what was given then.
TRY = """async ([name, text]) => {
    const settled = async () => { while (drops.some(drop => drop.asked)) await new Promise(wait => setTimeout(wait, 1)); };
    const before = [...chosen().given], field = document.getElementById("field-" + name);
    field.value = text;
    field.dispatchEvent(new Event("change", { bubbles: true }));
    await settled();
    const { refusal, data, given } = chosen(), numbers = ({ hash, numbers }) => [hash, ...numbers.map(({ value }) => value)];
    const reasons = [...document.querySelectorAll(".refusal")].map(one => one.innerText).filter(text => text);
    const found = { refused: refusal !== null, reasons, hash: data.hash, numbers: numbers(data), given: [...given] };
    chosen().given = new Map(before);
    changed();
    await settled();
    return { ...found, after: numbers(chosen().data) };
}"""


def other_value(field):
    """Another value of a control: the next choice, one more, a tenth more or a little instead of nothing."""
    if field["labels"]:
        return field["labels"][(field["labels"].index(field["value"]) + 1) % len(field["labels"])]
    if field["kind"] != "quantity":
        return str(int(field["value"]) + 1)
    return repr(1.1 * float(field["value"])) if float(field["value"]) else "0.05"


def command_line(preset, given):
    """What the command line makes of a preset with these values."""
    changes = [part for name, value in given for part in ("--set", f"{name}={value}")]
    return subprocess.run([os.environ["SOFTANVIL_CLI"], "run", "--preset", preset, "--json", *changes], capture_output=True, text=True)


@pytest.mark.parametrize("preset, layers", [("study", [None, 0]), ("rugby-soft-anvil", [1])])
def test_every_control_changes_the_drop_as_the_command_line_does(open_page, preset, layers):
    """All of the scenario and of a layer; then of the pad on it. What the page refuses, the command line does for the same reason."""
    # Coarse, because it is hundreds of drops.
    page = open_page(f"#{preset};mesh.element_size=0.008")
    page.click("#all summary")
    fields = page.evaluate("[...controls.fields.values()].map(({ row, input }) => ({ ...row, value: input.value }))")
    names = {field["name"]: other_value(field) for field in fields if field["layer"] in layers}
    assert len(names) > 40
    before = page.evaluate("[chosen().data.hash, ...chosen().data.numbers.map(({ value }) => value)]")
    with ThreadPoolExecutor(2) as pool:
        tried = {name: page.evaluate(TRY, [name, text]) for name, text in names.items()}
        runs = dict(zip(tried, pool.map(lambda one: command_line(preset, one["given"]), tried.values())))
    for name, found in tried.items():
        run, said = runs[name], " ".join(runs[name].stderr.split())
        if found["refused"]:
            assert run.returncode != 0 and found["reasons"] and found["numbers"] == before, name
            assert all(" ".join(reason.split()) in said for reason in found["reasons"]), (name, found["reasons"], said)
        else:
            assert run.returncode == 0, (name, said)
            assert json.loads(run.stdout)["trace_hash"] == found["hash"], name
        assert found["after"] == before, name
    assert sum(found["numbers"] != before for found in tried.values()) > 20


def test_every_slider_moves_its_field_and_the_drop(open_page):
    page = open_page()
    for slider in page.locator('#controls input[type="range"]:visible').all():
        field = slider.locator('xpath=../input[@type="text"]')
        name = field.get_attribute("id").removeprefix("field-")
        if page.evaluate("name => name in chosen().data.scenario.idle", name):
            continue
        before, text = numbers(page), field.input_value()
        slider.focus()
        slider.press("ArrowLeft")
        settle(page)
        assert field.input_value() != text and numbers(page)["hash"] != before["hash"], name
        page.click(f'[aria-label="Undo {name}"]')
        settle(page)


def test_a_law_comes_with_coefficients_and_a_pad_with_a_foam(open_page):
    page = open_page()
    for law in page.evaluate('[...document.getElementById("field-layers[0].law").options].map(option => option.value)'):
        set_field(page, "layers[0].law", law)
        assert page.evaluate("chosen().refusal") is None, law
        assert page.evaluate("chosen().data.scenario.values['layers[0].law']") == law
    page.click("#start-anew")
    page.click("#add-layer")
    settle(page)
    given = page.evaluate("[...chosen().given].map(value => value.join('='))")
    same(page, cli("run", *[part for value in given for part in ("--set", value)]))
    assert page.evaluate("chosen().data.scenario.layers.length") == 2


@pytest.mark.parametrize("name, text, reason", [
    ("impactor.mass", "-1", "impactor.mass = -1 kg is refused: expected 0.001 to 10000 kg"),
    ("impactor.mass", "heavy", "expected a number, 0.001 to 10000 kg"),
    ("layers[0].thickness", "", "expected a number, 0 to 0.5 m"),
    ("layers[0].thickness", "1e-9", "expected at least"),
    ("layers.count", "1.5", "layers.count = 1.5 is refused: expected 1 to 4"),
    ("layers[0].slider_yield_stress", "5e3", "has no effect: layers[0].slider_stiffness is 0"),
])
def test_what_is_refused_says_why_beside_its_field_and_nothing_is_lost(open_page, name, text, reason):
    page = open_page()
    set_field(page, "impactor.drop_energy", "9.8")
    before = numbers(page)
    set_field(page, name, text)
    field = page.locator(f'[id="field-{name}"]')
    assert reason in page.inner_text(f'[id="field-{name}-refusal"]')
    assert field.get_attribute("aria-invalid") == "true" and field.input_value() == text
    assert numbers(page) == before and page.evaluate("chosen().given.get('impactor.drop_energy')") == "9.8"
    page.click(f'[aria-label="Undo {name}"]')
    settle(page)
    assert page.evaluate("chosen().refusal") is None and numbers(page) == before


def test_two_drops_stand_beside_each_other(open_page):
    page = open_page()
    page.select_option("#compare", "padded")
    settle(page)
    assert page.locator("#sections canvas").count() == 2 and page.locator("#drops button").count() == 2
    bare, padded = numbers(page, 0), numbers(page, 1)
    assert padded["result.peak_force"] < bare["result.peak_force"]
    share = 100 * padded["result.peak_force"] / bare["result.peak_force"]
    assert page.locator("#results tbody tr").first.locator("td").all_inner_texts()[2] == f"{share:.0f} %"
    page.screenshot(path=PICTURES / "bare-and-padded.png", full_page=True)
    page.click("#remove")
    assert page.locator("#sections canvas").count() == 1


def test_the_address_gives_the_drops_again(open_page):
    page = open_page()
    set_field(page, "impactor.drop_energy", "9.8")
    page.select_option("#compare", "study-14.7")
    settle(page)
    again = open_page(page.evaluate("location.hash"))
    again.wait_for_function("drops.length === 2 && drops.every(drop => drop.data)")
    assert [numbers(again, i) for i in (0, 1)] == [numbers(page, i) for i in (0, 1)]
    assert open_page("#%E0%A4%A|;;=|nothing").evaluate("drops.length") >= 1


def test_files_come_out_as_the_command_line_writes_them(open_page, tmp_path):
    page = open_page()
    set_field(page, "impactor.drop_energy", "9.8")
    saved = {}
    for button in ("toml", "csv", "section-png"):
        with page.expect_download() as download:
            page.click(f"#{button}")
        saved[button] = Path(download.value.path()).read_bytes()
    with page.expect_download() as download:
        page.click('[aria-label="PNG: Force over time"]')
    assert Path(download.value.path()).read_bytes()[:8] == saved["section-png"][:8] == b"\x89PNG\r\n\x1a\n"
    (tmp_path / "scenario.toml").write_bytes(saved["toml"])
    run = [os.environ["SOFTANVIL_CLI"], "run", "--scenario", str(tmp_path / "scenario.toml"), "--csv", str(tmp_path / "trace.csv")]
    subprocess.run(run, check=True, capture_output=True)
    assert (tmp_path / "trace.csv").read_bytes() == saved["csv"]
    same(page, cli("run", "--scenario", str(tmp_path / "scenario.toml")))


def test_files_go_in(open_page, tmp_path):
    page = open_page()
    (tmp_path / "mine.toml").write_text("[impactor]\nmass = 4.0\n")
    page.set_input_files("#file", tmp_path / "mine.toml")
    # It is read before anything is simulated.
    page.wait_for_function("chosen().toml")
    settle(page)
    same(page, cli("run", "--scenario", str(tmp_path / "mine.toml")))
    lines = ["time [ms],force [kN]", *(f"{1e3 * row['time [s]']},{row['contact.force [N]'] / 1e3}" for row in trace_of(page))]
    (tmp_path / "measured.csv").write_text("\n".join(lines))
    page.set_input_files("#file", tmp_path / "measured.csv")
    page.wait_for_function("chosen().measured")
    peak = numbers(page)["result.peak_force"]
    assert abs(page.evaluate("chosen().measured.numbers['result.peak_force'].value") - peak) < 1e-3 * peak
    # The trace lies on the force that it was made of.
    ours, theirs = (page.evaluate(f"valueAt({curve}.points, 2.5)") for curve in ("chosen().data.force_time", "chosen().measured.curve"))
    assert abs(ours - theirs) < 0.02 * peak
    assert "measured.csv" in page.inner_text("#force-time .legend") and page.inner_text("#understood")
    (tmp_path / "nonsense.csv").write_text("no numbers\n")
    page.set_input_files("#file", tmp_path / "nonsense.csv")
    page.wait_for_function("document.getElementById('understood').textContent.includes('nonsense.csv')")


@pytest.mark.parametrize("plot", ["force-time", "force-deformation", "energy"])
def test_plots_are_used_by_pointer_and_by_keyboard(open_page, plot):
    page = open_page()
    index = ["force-time", "force-deformation", "energy"].index(plot)
    window = lambda: page.evaluate(f"plots[{index}].place.values[0]")
    view, whole = page.locator(f"#{plot} .plot"), window()
    view.scroll_into_view_if_needed()
    box = view.bounding_box()
    for part, act in ((0.4, page.mouse.down), (0.7, page.mouse.up)):
        page.mouse.move(box["x"] + part * box["width"], box["y"] + 0.4 * box["height"], steps=4)
        act()
    zoomed = window()
    assert whole[0] < zoomed[0] < zoomed[1] < whole[1]
    view.dblclick()
    assert window() == whole
    view.focus()
    time = page.evaluate("shown.time")
    page.keyboard.press("ArrowRight")
    assert abs(page.evaluate("shown.time") - time - 0.05) < 1e-9
    text = view.get_attribute("aria-valuetext")
    assert text.startswith(f"{time + 0.05:.2f} ms") and re.search(r" (N|J)", text)
    page.keyboard.press("+")
    assert window()[1] - window()[0] < whole[1] - whole[0]
    page.keyboard.press("Escape")
    assert window() == whole


def test_the_animation_plays_only_when_it_is_asked_to(open_page):
    page = open_page()
    picture = lambda: page.eval_on_selector("#sections canvas", "canvas => canvas.toDataURL()")
    still = picture()
    page.wait_for_timeout(200)
    assert picture() == still
    page.click("#play")
    page.wait_for_timeout(400)
    page.click("#play")
    assert picture() != still
    page.click("#instants button:has-text('peak force')")
    force = float(re.search(r"force (\d+) N", page.inner_text("#sections figcaption"))[1])
    assert abs(force - numbers(page)["result.peak_force"]) < 0.51


def test_a_long_run_can_be_stopped_and_the_page_never_waits(open_page):
    page = open_page()
    page.click("#all summary")
    page.locator('[id="field-mesh.element_size"]').fill("0.0004")
    page.locator('[id="field-mesh.element_size"]').press("Enter")
    page.wait_for_selector("#busy:not([hidden])")
    ticks = page.evaluate("new Promise(done => { let n = 0; const f = () => ++n < 10 ? requestAnimationFrame(f) : done(n); f(); })")
    assert ticks == 10
    page.click("#stop")
    settle(page)
    page.click('[aria-label="Undo mesh.element_size"]')
    settle(page)
    same(page, cli("run"))


def test_a_drop_that_was_taken_away_is_simulated_no_more(open_page):
    """Otherwise those that are there would wait for the end of its run, of minutes."""
    page = open_page()
    page.select_option("#compare", "study-14.7")
    settle(page)
    page.evaluate("chosen().given = new Map([['mesh.element_size', '0.0004'], ['time.duration', '5']]), changed()")
    page.evaluate("shown.drop = 0, chosen().given.set('impactor.drop_energy', '9.8'), changed(), shown.drop = 1")
    assert page.evaluate("drops.map(drop => drop.asked)") == [1, 1]
    page.click("#remove")
    settle(page)
    same(page, cli("run", "--energy", "9.8"))


def test_a_drop_is_broken_off_only_for_a_later_one_of_its_own(open_page):
    """Not for one of another that was there, was answered, and came again within its patience."""
    page = open_page()
    answers = page.evaluate("""async () => {
        const ask = (key, size) => simulator.ask(key, { kind: "drop", label: "", asked: { preset: "study", toml: "", given: [["mesh.element_size", size]] } });
        await ask("first", "0.008");
        const slow = ask("second", "0.0017"), again = ask("first", "0.007");
        return [(await slow)?.hash.length, (await again)?.hash.length];
    }""")
    assert answers == [16, 16]


def test_every_move_of_a_slider_ends_in_a_picture(open_page):
    """How soon is what latency.py measures."""
    page = open_page()
    assert len(page.evaluate(MOVES, [10, 0])) == 10


@pytest.mark.parametrize("name, options", [
    ("desktop", {}), ("desktop-dark", {"color_scheme": "dark"}), ("phone", {"viewport": PHONE}),
    ("phone-dark", {"viewport": PHONE, "color_scheme": "dark"}),
])
@pytest.mark.parametrize("file", ["page.html", "report/report.html"])
def test_it_fits_the_screen(open_page, file, name, options):
    page = open_page(file=file, **options)
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    page.screenshot(path=PICTURES / f"{Path(file).stem}-{name}.png", full_page=True)


def test_it_is_small():
    assert (WORK / "page.html").stat().st_size < 1_500_000
