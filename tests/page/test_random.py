"""A thousand sequences of what a person may do on the page, at random, without an exception or a NaN."""

from conftest import settle

SEQUENCES = 1000

PLAY = """async sequences => {
    let state = 12345;
    const random = () => (state = (1103515245 * state + 12345) % 2 ** 31) / 2 ** 31, one = list => list[Math.floor(random() * list.length)];
    const visible = selector => [...document.querySelectorAll(selector)].filter(element => element.offsetParent && !element.disabled);
    const change = (element, kind) => element.dispatchEvent(new Event(kind, { bubbles: true }));
    const TEXTS = ["", "0", "-1", "1e99", "nan", "inf", "0.5", "2", "abc", "1e-12", "7,5", "3"];
    const actions = [
        () => { const slider = one(visible('#controls input[type="range"]')); slider.value = 200 * random() - 100; change(slider, "input"); },
        () => { const slider = one(visible('#controls input[type="range"]')); slider.value = 60 * random() - 30; change(slider, "input"); },
        () => { const field = one(visible('.field input[type="text"]')); field.value = one(TEXTS); change(field, "change"); },
        () => { const field = one(visible('.field input[type="text"]')); field.value = String((Number(field.value) || 1) * (0.5 + random())).replace("Infinity", "inf"); change(field, "change"); },
        () => { const select = one(visible(".field select")); select.value = one([...select.options]).value; change(select, "change"); },
        () => { const back = one(visible(".back")); back?.click(); },
        () => one(visible("#drops button")).click(),
        () => { const compare = element("compare"); compare.value = one([...compare.options]).value; change(compare, "change"); },
        () => element("remove").click(),
        () => element("start-anew").click(),
        () => { element("time").value = 20 * random() - 2; change(element("time"), "input"); },
        () => { element("shade").value = one(["0", "1"]); change(element("shade"), "change"); },
        () => { element("mesh").click(); },
        () => { element("search").value = one(["", "prony", "face", "zzz"]); change(element("search"), "input"); },
        () => one(visible(".plot")).dispatchEvent(new KeyboardEvent("keydown", { key: one(["ArrowLeft", "End", "Home", "+", "-", "0", "PageUp"]) })),
        () => one(visible("#instants button"))?.click(),
    ];
    document.querySelectorAll("details").forEach(details => { details.open = true; });
    const faults = [];
    for (let i = 0; i < sequences && faults.length < 5; i++) {
        // Coarse and short, so that much is seen; now and then as it is.
        if (i % 20 === 0) {
            begin([newDrop({ given: [["mesh.element_size", "0.006"]] })]);
        }
        const made = 1 + Math.floor(3 * random());
        for (let k = 0; k < made; k++) one(actions)();
        const limit = performance.now() + 60;
        do await new Promise(wait => setTimeout(wait, 4)); while (drops.some(drop => drop.asked) && performance.now() < limit);
        const text = [...document.querySelectorAll("#live, #drops")].map(part => part.innerText).join(" ");
        const found = text.match(/[^\\n]*(NaN|undefined|Infinity|\\[object)[^\\n]*/g) ?? [];
        // A refusal says what was typed.
        const strange = found.filter(line => !/is refused/.test(line));
        if (strange.length) faults.push(`${i}: ${strange[0]}`);
        const pictures = document.querySelectorAll(".plot svg [d*=NaN], .plot svg [points*=NaN], .overlay [cx=NaN], .overlay [x1=NaN]");
        if (pictures.length) faults.push(`${i}: ${pictures[0].outerHTML.slice(0, 200)}`);
    }
    return faults;
}"""


def test_a_thousand_random_sequences(open_page):
    page = open_page()
    page.set_default_timeout(300_000)
    assert page.evaluate(PLAY, SEQUENCES) == []
    # It still works.
    page.evaluate("begin([])")
    settle(page)
    assert page.evaluate("chosen().data.hash.length") == 16
