"use strict";
// A plot: the picture that the kernel's drawing code makes, as in the files of the command line, with a cursor over it, a legend
// that has the values there, zoom by pointer and keys, and a file of it.

const SVG = "http://www.w3.org/2000/svg";
const digits = (value, places) => value == null || !isFinite(value) ? "–" : value.toFixed(places);

/** The place in a curve of points at which the abscissa is x, between two of them; null outside of it. */
function placeAt(points, x) {
  if (points.length === 0 || x < points[0][0] || x > points[points.length - 1][0]) return null;
  let low = 0, high = points.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (points[middle][0] <= x) low = middle; else high = middle;
  }
  const [x0, x1] = [points[low][0], points[high][0]];
  return x1 === x0 ? low : low + (x - x0) / (x1 - x0);
}

/** A point of a curve at a place between two of them. */
function pointAt(points, place) {
  const first = Math.floor(place), [a, b] = [points[first], points[Math.min(first + 1, points.length - 1)]];
  return a.map((value, i) => value + (place - first) * (b[i] - value));
}

/** The ordinate of a curve at an abscissa; null outside of it. */
function valueAt(points, x) {
  const place = placeAt(points, x);
  return place === null ? null : pointAt(points, place)[1];
}

/** Deformation and force of a drop at a time, whose two curves have points of the same samples; null without contact. */
function stateAt(drop, time) {
  const place = placeAt(drop.data.force_time.points, time);
  return place === null ? null : pointAt(drop.data.force_deformation.points, place);
}

class Plot {
  /**
   * In the figure `id`. `content()` says what it shows: the picture for the kernel, and its legend, each entry with a swatch, a
   * label and a function from the time to its text and, if it has one, its point. `isOverTime`: whether the abscissa is the time.
   */
  constructor(id, name, { kernel, content, isOverTime, onTime }) {
    Object.assign(this, { id, name, kernel, content, isOverTime, onTime, window: null, hovered: null, drag: null });
    this.figure = document.getElementById(id);
    this.view = Object.assign(document.createElement("div"), { className: "plot", tabIndex: 0 });
    const attributes = {
      role: "slider", "aria-label": `${name}: time of the cursor`, "aria-valuemin": 0, "aria-valuemax": 0, "aria-valuenow": 0,
      "aria-describedby": "plot-keys",
    };
    for (const [key, value] of Object.entries(attributes)) this.view.setAttribute(key, value);
    this.picture = document.createElement("div");
    this.overlay = document.createElementNS(SVG, "svg");
    this.overlay.setAttribute("class", "overlay");
    this.overlay.setAttribute("aria-hidden", "true");
    this.view.append(this.picture, this.overlay);
    this.legend = Object.assign(document.createElement("ul"), { className: "legend" });
    this.figure.append(this.view, this.legend, this.tools());
    this.listen();
    this.width = onWidth(this.view, () => this.draw());
  }

  tools() {
    const tools = Object.assign(document.createElement("p"), { className: "tools" });
    const button = (text, label, onclick) => {
      const made = Object.assign(document.createElement("button"), { type: "button", textContent: text, onclick });
      made.setAttribute("aria-label", label);
      tools.append(made, " ");
    };
    button("Whole", `Whole: ${this.name}`, () => this.zoom(null));
    button("PNG", `PNG: ${this.name}`, () => savePicture(this.picture.firstElementChild, this.id));
    return tools;
  }

  /** Draws everything anew. */
  draw() {
    const { of, legend } = this.content();
    if (!of) return;
    const width = Math.max(240, Math.floor(this.width())), height = Math.round(Math.min(380, 120 + 0.45 * width));
    const answer = this.kernel({ kind: "picture", of, size: [width, height], window: this.window });
    if (answer.failed) return;
    this.picture.innerHTML = answer.svg;
    const drawn = this.picture.firstElementChild;
    drawn.setAttribute("role", "img");
    drawn.setAttribute("aria-label", this.name);
    this.place = answer.place;
    this.overlay.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.overlay.setAttribute("width", width);
    this.overlay.setAttribute("height", height);
    this.entries = legend;
    this.legend.replaceChildren(...legend.map(({ swatch, label }) => {
      const item = document.createElement("li");
      item.append(swatch(), label, " ", document.createElement("b"));
      return item;
    }));
    this.point();
  }

  /** Shows where the cursor is: at the time of the animation, or under the pointer. */
  point() {
    if (!this.place) return;
    const time = this.hovered ?? shown.time, { pixels, values } = this.place;
    const pixel = (axis, value) => pixels[axis][0] + (value - values[axis][0]) / (values[axis][1] - values[axis][0]) * (pixels[axis][1] - pixels[axis][0]);
    const inside = ([x, y]) => x >= values[0][0] && x <= values[0][1] && y >= values[1][0] - 1e-9 && y <= values[1][1] + 1e-9;
    const marks = [];
    if (this.isOverTime && inside([time, values[1][0]])) {
      marks.push(shape("line", { x1: pixel(0, time), x2: pixel(0, time), y1: pixels[1][0], y2: pixels[1][1] }));
    }
    const told = this.entries.map((entry, i) => {
      const { text, point } = entry.at(time);
      this.legend.children[i].lastElementChild.textContent = text;
      if (point && inside(point)) marks.push(shape("circle", { cx: pixel(0, point[0]), cy: pixel(1, point[1]), r: 4 }));
      return text && `${entry.label} ${text}`;
    });
    if (this.drag?.to !== undefined) {
      const [from, to] = [this.drag.from, this.drag.to].sort((a, b) => a - b);
      marks.push(shape("rect", { x: from, width: to - from, y: pixels[1][1], height: pixels[1][0] - pixels[1][1] }));
    }
    this.overlay.replaceChildren(...marks);
    const [first, last] = span();
    this.view.setAttribute("aria-valuemin", digits(first, 2));
    this.view.setAttribute("aria-valuemax", digits(last, 2));
    this.view.setAttribute("aria-valuenow", digits(time, 2));
    this.view.setAttribute("aria-valuetext", [`${digits(time, 2)} ms`, ...told.filter(text => text)].join(", "));
  }

  /** Shows a part of the abscissa, or the whole if it is null. */
  zoom(window) {
    if (window && !(window[1] - window[0] > 1e-3)) return;
    this.window = window;
    this.draw();
  }

  /** The abscissa at a place of the pointer. */
  abscissa(x) {
    const [[left, right], [low, high]] = [this.place.pixels[0], this.place.values[0]];
    return low + (Math.min(Math.max(x, left), right) - left) / (right - left) * (high - low);
  }

  listen() {
    const { view } = this, x = event => event.clientX - view.getBoundingClientRect().left;
    view.addEventListener("pointerdown", event => { if (event.button === 0) this.drag = { from: x(event) }; });
    view.addEventListener("pointermove", event => {
      if (!this.place) return;
      if (this.drag && Math.abs(x(event) - this.drag.from) > 4) {
        this.drag.to = x(event);
        view.setPointerCapture(event.pointerId);
      }
      this.hovered = this.isOverTime ? this.abscissa(x(event)) : null;
      this.point();
    });
    view.addEventListener("pointerup", event => {
      const drag = this.drag;
      this.drag = null;
      if (drag?.to !== undefined) this.zoom([drag.from, drag.to].map(end => this.abscissa(end)).sort((a, b) => a - b));
      else if (drag && this.isOverTime) this.onTime(this.abscissa(x(event)));
    });
    const leave = () => { this.drag = this.hovered = null; this.point(); };
    view.addEventListener("pointerleave", leave);
    view.addEventListener("pointercancel", leave);
    view.addEventListener("dblclick", () => this.zoom(null));
    view.addEventListener("keydown", event => this.key(event));
  }

  /** Arrows and pages move the cursor, plus and minus zoom about it. */
  key(event) {
    const [first, last] = span();
    const steps = { ArrowLeft: -0.05, ArrowDown: -0.05, ArrowRight: 0.05, ArrowUp: 0.05, PageDown: -0.5, PageUp: 0.5 };
    const ends = { Home: first, End: last };
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    this.hovered = null;
    if (event.key in steps) this.onTime(shown.time + steps[event.key]);
    else if (event.key in ends) this.onTime(ends[event.key]);
    else if (event.key === "+" || event.key === "=") this.zoomBy(0.5);
    else if (event.key === "-") this.zoomBy(2);
    else if (event.key === "0" || event.key === "Escape") this.zoom(null);
    else return;
    event.preventDefault();
  }

  zoomBy(factor) {
    const [low, high] = this.place.values[0], points = this.entries.map(entry => entry.at(shown.time).point).filter(point => point);
    const middle = this.isOverTime ? shown.time : points[0]?.[0] ?? 0.5 * (low + high), half = 0.5 * factor * (high - low);
    this.zoom([Math.max(0, middle - half), middle + half]);
  }
}

function shape(name, attributes) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

/** The line and the mark of a run, or a field of colour, for a legend. */
function swatch({ colour, dash, mark }, isArea = false) {
  const made = shape("svg", { width: 34, height: 14, viewBox: "0 0 34 14", "aria-hidden": "true", "data-colour": colour });
  if (isArea) {
    made.append(shape("rect", { x: 8, y: 1, width: 18, height: 12, fill: colour, stroke: "currentColor" }));
    return made;
  }
  made.append(shape("line", { x1: 1, x2: 33, y1: 7, y2: 7, stroke: colour, "stroke-width": 2.25, "stroke-dasharray": (dash ?? []).join(" ") }));
  const marks = {
    circle: () => shape("circle", { cx: 17, cy: 7, r: 4, fill: colour }),
    square: () => shape("rect", { x: 13, y: 3, width: 8, height: 8, fill: colour }),
    triangle: () => shape("path", { d: "M12.5 11h9L17 2z", fill: colour }),
    cross: () => shape("path", { d: "M13 3l8 8M13 11l8 -8", stroke: colour, "stroke-width": 2.25 }),
  };
  if (mark) made.append(marks[mark]());
  return made;
}

/** The width of `element`, kept, because to ask for it after a change lays the whole page out; calls `act` when it has changed,
    never in a loop over heights. */
function onWidth(element, act) {
  let width = element.clientWidth;
  new ResizeObserver(() => {
    if (element.clientWidth === width) return;
    width = element.clientWidth;
    requestAnimationFrame(act);
  }).observe(element);
  return () => width;
}
