"use strict";
// The animation and what chooses what it shows.

const element = id => document.getElementById(id);
const slider = element("time"), play = element("play");
let playing = !matchMedia("(prefers-reduced-motion: reduce)").matches;
let clock = null;

const animation = () => data.animations[shown.animation];

function draw() {
  drawSection(element("section"), animation(), shown.frame, shown.shade, element("mesh").checked);
  slider.value = shown.frame;
  element("readout").textContent = `${digits(at(animation().time, shown.frame), 2)} ms, ` +
    `${digits(at(animation().deformation, shown.frame), 2)} mm, ${digits(at(animation().force, shown.frame), 0)} N`;
  forceTime.redraw(false, false);
}

function drawMoments() {
  const place = element("instants");
  place.replaceChildren(...animation().instants.map(({ label, frame }) => {
    const button = Object.assign(document.createElement("button"), { type: "button", onclick: () => goTo(frame) });
    button.append(document.createElement("canvas"), label);
    return button;
  }));
  animation().instants.forEach(({ frame }, i) => drawSection(place.children[i].firstChild, animation(), frame, shown.shade, false));
}

function setPlaying(on) {
  playing = on;
  clock = null;
  play.textContent = on ? "Pause" : "Play";
  if (on) requestAnimationFrame(tick);
}

function goTo(frame) {
  setPlaying(false);
  shown.frame = Math.min(Math.max(frame, 0), animation().time.length - 1);
  draw();
}

function tick(now) {
  if (!playing) return;
  if (clock !== null) {
    // Times of the animation are in ms, at equal intervals.
    const interval = animation().time[1] - animation().time[0];
    shown.frame += (now - clock) / 1000 * element("speed").value / interval;
    if (shown.frame > animation().time.length - 1) shown.frame = 0;
    draw();
  }
  clock = now;
  requestAnimationFrame(tick);
}

/** Buttons of which one is chosen. */
function choice(id, labels, key, changed) {
  const buttons = labels.map((label, i) => Object.assign(document.createElement("button"), {
    type: "button", textContent: label, onclick: () => choose(i),
  }));
  const press = () => buttons.forEach((button, i) => button.setAttribute("aria-pressed", i === shown[key]));
  const choose = i => { shown[key] = i; press(); changed(); };
  element(id).append(...buttons.flatMap(button => [button, " "]));
  press();
}

function showFilm() {
  slider.max = animation().time.length - 1;
  shown.frame = Math.min(shown.frame, slider.max);
  document.querySelectorAll(".case").forEach(span => { span.textContent = animation().label; });
  energy.setData(energyData(animation()));
  showAll();
}

function showAll() {
  drawBar(element("bar"), shown.shade);
  drawMoments();
  draw();
}

choice("cases", data.animations.map(({ label }) => label), "animation", showFilm);
choice("shades", data.shades.map(({ label }) => label), "shade", showAll);
element("mesh").onchange = draw;
slider.oninput = () => goTo(Number(slider.value));
play.onclick = () => setPlaying(!playing);
element("section-png").onclick = () => savePng(element("section"), "section");
element("theme").onclick = () => {
  const dark = getComputedStyle(document.documentElement).colorScheme === "dark";
  document.documentElement.dataset.theme = dark ? "light" : "dark";
  showTheme();
};
function showTheme() {
  showAll();
  for (const chart of [forceTime, forceDeformation, energy]) chart.redraw(false, true);
}
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", showTheme);
forceTime.over.addEventListener("click", event => {
  if (forceTime.select.width > 2) return;
  const times = animation().time;
  goTo((forceTime.posToVal(event.offsetX, "x") - times[0]) / (times[1] - times[0]));
});
onWidth(document.body, showAll);
showFilm();
setPlaying(playing);
