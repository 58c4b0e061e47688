"use strict";
// The sections of the drops at one time, and what moves it.

class Player {
  constructor(kernel, legend, moved) {
    Object.assign(this, { kernel, legend, moved, playing: false, clock: null, bands: null });
    this.slider = document.getElementById("time");
    this.button = document.getElementById("play");
    this.slider.oninput = () => this.goTo(Number(this.slider.value));
    this.button.onclick = () => this.setPlaying(!this.playing);
    document.getElementById("mesh").onchange = event => { shown.mesh = event.target.checked; this.draw(); };
    const shades = document.getElementById("shade");
    shades.append(...legend.shades.map(({ label }, i) => make("option", { value: i, textContent: label })));
    shades.onchange = () => { shown.shade = Number(shades.value); this.show(); };
    document.getElementById("section-png").onclick = () => {
      this.figures.forEach(({ canvas }, i) => saveCanvas(canvas, `section-${letter(i)}`));
    };
    this.figures = [];
    this.bar = document.getElementById("bar");
    onWidth(document.getElementById("sections"), () => { this.measure(); this.show(); });
  }

  /** Other drops, or another quantity. */
  show() {
    const sections = ready().map(drop => drop.data.section), [first, last] = span();
    const ranges = sections.map(section => section.shades[shown.shade]);
    this.bands = this.kernel({ kind: "levels", range: [Math.min(0, ...ranges.map(({ low }) => low)), Math.max(0, ...ranges.map(({ high }) => high))] });
    [this.slider.min, this.slider.max] = [first, last];
    const place = document.getElementById("sections");
    const before = this.figures.length;
    while (this.figures.length > sections.length) this.figures.pop().figure.remove();
    while (this.figures.length < sections.length) {
      const canvas = make("canvas"), caption = make("figcaption"), figure = make("figure", {}, canvas, caption);
      canvas.setAttribute("role", "img");
      this.figures.push({ figure, canvas, caption });
      place.append(figure);
    }
    if (this.figures.length !== before) this.measure();
    drawBar(this.bar, this.barWidth, this.legend.shades[shown.shade].label, this.bands);
    this.showInstants();
    shown.time = Math.min(Math.max(shown.time, first), last);
    this.draw();
  }

  /** Widths of the canvases: to ask for them with every picture would lay the page out each time. */
  measure() {
    this.barWidth = this.bar.clientWidth;
    for (const figure of this.figures) figure.width = figure.canvas.clientWidth;
  }

  showInstants() {
    const instants = chosen()?.data?.instants ?? [];
    document.getElementById("instants").replaceChildren(...instants.map(({ label, time }) =>
      make("button", { type: "button", textContent: `${label}, ${digits(time, 2)} ms`, onclick: () => this.goTo(time) })));
  }

  /** The sections at the time, and their numbers. */
  draw() {
    if (!this.bands) return;
    ready().forEach((drop, i) => {
      const { section } = drop.data, { canvas, caption, width } = this.figures[i] ?? {}, state = stateAt(drop, shown.time);
      if (!canvas) return;
      drawSection(canvas, width, section, shown.time, shown.shade, this.bands, shown.mesh);
      caption.textContent = `${labelOf(drop)}: force ${digits(state?.[1], 0)} N, deformation ${digits(state?.[0], 2)} mm`;
      canvas.setAttribute("aria-label", `Section of ${labelOf(drop)} under the impactor, coloured by ${this.legend.shades[shown.shade].label}`);
    });
    this.slider.value = shown.time;
    this.slider.setAttribute("aria-valuetext", `${digits(shown.time, 2)} ms since contact`);
    document.getElementById("readout").textContent = `time ${digits(shown.time, 2)} ms`;
    this.moved();
  }

  setPlaying(on) {
    this.playing = on;
    this.clock = null;
    this.button.textContent = on ? "Pause" : "Play";
    if (on) requestAnimationFrame(now => this.tick(now));
  }

  goTo(time) {
    const [first, last] = span();
    this.setPlaying(false);
    shown.time = Math.min(Math.max(time, first), last);
    this.draw();
  }

  tick(now) {
    if (!this.playing) return;
    if (this.clock !== null) {
      const [first, last] = span();
      shown.time += (now - this.clock) / 1000 * Number(document.getElementById("speed").value);
      if (shown.time > last) shown.time = first;
      this.draw();
    }
    this.clock = now;
    requestAnimationFrame(next => this.tick(next));
  }
}

/** First and last time that is shown, ms. */
function span() {
  const times = ready().map(drop => drop.data.section.time);
  return times.length ? [Math.min(...times.map(all => all[0])), Math.max(...times.map(all => all[all.length - 1]))] : [0, 0];
}
