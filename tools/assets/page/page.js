"use strict";
// The page: what stands in the document becomes drops, and drops become pictures.

const element = id => document.getElementById(id);
const own = JSON.parse(element("start").textContent);
let kernel, simulator, controls, player, plots = [];

/** Simulates a drop as it is asked for, and shows what came of it. */
async function simulate(drop, since = performance.now()) {
  drop.asked++;
  waiting();
  let isDrawn = false;
  const draw = answer => {
    if (!drops.includes(drop)) return;
    take(drop, answer);
    if (answer.section || drop.refusal) showAll();
    else showResults();
    if (!isDrawn) performance.measure("input to picture", { start: since, end: performance.now() });
    isDrawn = true;
  };
  const answer = await simulator.ask(drop, { kind: "drop", asked: askedOf(drop), label: drop.name || drop.preset }, undefined, draw);
  drop.asked--;
  waiting();
  if (answer === null) return;
  draw(answer);
  if (drop.file && drop.data && !drop.refusal) lay(drop).then(showAll);
}

/** What has come of a drop: all that is shown of it, or what the end of its run has changed of that. */
function take(drop, { refused, failed, more, ...answer }) {
  if (refused || failed) drop.refusal = refused ?? { fields: [], message: `The simulation failed: ${failed}` };
  else Object.assign(drop, { data: answer.section ? answer : { ...drop.data, ...answer }, refusal: null });
}

/** Lays the measured trace of a drop over it. */
async function lay(drop) {
  const { name, bytes } = drop.file;
  const answer = await simulator.ask("measured", { kind: "measured", asked: askedOf(drop), name, beside: drop.data.force_time }, bytes);
  if (!answer) return;
  drop.measured = answer.curve ? answer : null;
  drop.understood = answer.curve ? `${name} is drawn over the force.\n${answer.understood}` : answer.refused?.message ?? answer.failed;
}

let busySince = null;
/** Says that a drop is simulated, when it takes long. */
function waiting() {
  const busy = drops.some(drop => drop.asked);
  clearTimeout(busySince);
  if (busy) busySince = setTimeout(() => { element("busy").hidden = false; }, 400);
  else element("busy").hidden = true;
}

let telling = null;
/** Says something to everyone, once it does not change any more. */
function tell(text) {
  clearTimeout(telling);
  telling = setTimeout(() => { element("status").textContent = text; }, 300);
}

/** Draws everything that depends on drops. */
function showAll() {
  shown.drop = Math.min(shown.drop, drops.length - 1);
  // Text on a canvas wants the style worked out, which costs little before the document changes.
  if (ready().length) player.show();
  controls.show(chosen());
  showChoice();
  if (!ready().length) return;
  showResults();
  plots.forEach(plot => plot.draw());
  const peak = chosen().data?.numbers[0];
  if (peak && !chosen().refusal) tell(`${labelOf(chosen())}: ${peak.label} ${peak.text} ${peak.unit}`);
}

/** The drops, of which one has the controls. */
function showChoice() {
  element("drops").replaceChildren(...drops.map((drop, i) => {
    const button = make("button", { type: "button", textContent: labelOf(drop), onclick: () => { shown.drop = i; showAll(); } });
    button.setAttribute("aria-pressed", i === shown.drop);
    return button;
  }));
  document.querySelectorAll(".case").forEach(span => { span.textContent = labelOf(chosen()); });
  element("preset").value = chosen().preset;
  element("remove").disabled = drops.length < 2;
  element("compare").disabled = drops.length >= MOST_DROPS;
}

/** The chosen drop asks for something else. */
function changed() {
  const since = window.event?.timeStamp ?? performance.now(), drop = chosen();
  // First, because the worker is busy while the page shows the change.
  simulate(drop, since);
  history.replaceState(null, "", "#" + toFragment());
  controls.show(drop);
}

/** One more drop, changed by `change`. */
function add(asked, change = () => {}) {
  if (drops.length >= MOST_DROPS) return;
  const drop = newDrop(asked);
  change(drop);
  drops.push(drop);
  shown.drop = drops.length - 1;
  changed();
}

function open(name, bytes) {
  const drop = chosen();
  if (/\.toml$/i.test(name)) {
    Object.assign(drop, { toml: new TextDecoder().decode(bytes), given: new Map(), name: "" });
    changed();
    return;
  }
  drop.file = { name, bytes };
  if (drop.data) lay(drop).then(showAll);
}

async function saveText(kind, name, type) {
  const answer = await simulator.ask(kind, { kind, asked: askedOf(chosen()) });
  if (answer?.text) save(name, answer.text, type);
  else if (answer) tell(answer.refused?.message ?? answer.refused?.fields[0]?.[1] ?? answer.failed);
}

/** Light has become dark, or dark light. */
function repaint() {
  colours.clear();
  player.show();
}

function listen() {
  element("preset").onchange = () => {
    Object.assign(chosen(), { preset: element("preset").value, toml: "", given: new Map(), name: "", measured: null, file: null, understood: "" });
    changed();
  };
  element("compare").onchange = () => {
    const preset = element("compare").value;
    element("compare").value = "";
    const layers = chosen().data?.scenario.layers.length ?? 1, copy = askedOf(chosen());
    if (preset === "copy") add(copy);
    else if (preset === "padded") add(copy, drop => padded(drop, layers));
    else if (preset === "bare") add(copy, drop => bare(drop, layers));
    else if (preset) add({ preset });
  };
  element("remove").onclick = () => {
    if (drops.length < 2) return;
    replace(shown.drop, 1);
    history.replaceState(null, "", "#" + toFragment());
    showAll();
  };
  element("add-layer").onclick = () => { padded(chosen(), chosen().data?.scenario.layers.length ?? 1); changed(); };
  element("start-anew").onclick = () => { chosen().given.clear(); changed(); };
  element("stop").onclick = () => simulator.stop();
  element("toml").onclick = () => saveText("toml", "scenario.toml", "application/toml");
  element("csv").onclick = () => saveText("csv", "trace.csv", "text/csv");
  element("link").onclick = () => navigator.clipboard.writeText(location.href).then(() => tell("The address is copied."), () => tell(location.href));
  element("theme").onclick = () => {
    const dark = getComputedStyle(document.documentElement).colorScheme === "dark";
    document.documentElement.dataset.theme = dark ? "light" : "dark";
    repaint();
  };
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", repaint);
  addEventListener("hashchange", () => begin(fromFragment(location.hash)));
  takeFiles(element("file"), open);
}

/** Takes `number` drops from the page, from this one on, and puts others in their place: theirs are no longer simulated. */
function replace(first, number, ...others) {
  drops.splice(first, number, ...others).forEach(drop => simulator.leave(drop));
}

/** Begins with these drops. */
function begin(these) {
  replace(0, drops.length, ...these.length ? these : [newDrop({})]);
  shown.drop = 0;
  drops.filter(drop => !drop.data).forEach(drop => simulate(drop));
  showAll();
}

/** Shows the moment of the largest force when there is something to see for the first time. */
function goToPeak() {
  const peak = ready()[0]?.data.instants?.find(({ label }) => label === "peak force");
  if (peak) player.goTo(peak.time);
}

async function start() {
  const module = await compileKernel(element("kernel").textContent);
  kernel = await startKernel(module);
  simulator = new Simulator(module, element("kernel-script").textContent + element("worker-script").textContent);
  const { table, legend } = kernel({ kind: "table" });
  controls = new Controls(element("controls"), table, changed);
  player = new Player(kernel, legend, () => plots.forEach(plot => plot.point()));
  const plot = (id, name, content, isOverTime) =>
    new Plot(id, name, { kernel, content: () => content(legend), isOverTime, onTime: time => player.goTo(time) });
  plots = [
    plot("force-time", "Force over time", CONTENT.forces, true),
    plot("force-deformation", "Force over deformation", CONTENT.loops, false),
    plot("energy", "Energy over time", CONTENT.energy, true),
  ];
  const options = () => table.presets.map(({ name, description }) => make("option", { value: name, textContent: `${name}: ${description}` }));
  element("preset").append(...options());
  element("compare").append(...options());
  listen();
  const asked = fromFragment(location.hash);
  begin(asked.length ? asked : own.map(({ data, ...drop }) => newDrop(drop, data && unpack(data))));
  while (!ready().length && drops.some(drop => drop.asked)) await new Promise(wait => setTimeout(wait, 20));
  goToPeak();
  document.documentElement.dataset.ready = "";
}

start().catch(error => {
  element("status").textContent = `This browser cannot run the kernel (${error.message}): WebAssembly with simd128 and DecompressionStream are needed.`;
});
