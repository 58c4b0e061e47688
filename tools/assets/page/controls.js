"use strict";
// The controls of a drop: a field for every parameter of the kernel's table, sliders for the main ones.

/** Factor by which a slider changes a value at most, up and down. */
const REACH = 5;

const make = (name, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
};

/** Says something in an element; a text that stands there stays, because a new one has the page laid out anew. */
const say = (element, text) => { if (element.textContent !== text) element.textContent = text; };

/** The same of an attribute. */
const mark = (element, name, value) => { if (element.getAttribute(name) !== String(value)) element.setAttribute(name, value); };

/** Plausible coefficients of each law, and how many layers there can be: from the kernel. */
const materials = { laws: {}, most_layers: 1 };

/** A law with plausible coefficients, instead of those that were given with another; none if it is taken back. */
function giveLaw({ given }, layer, law) {
  for (const field of new Set(Object.values(materials.laws).flatMap(Object.keys))) given.delete(`layers[${layer}].${field}`);
  for (const [field, value] of Object.entries(materials.laws[law] ?? {})) given.set(`layers[${layer}].${field}`, String(value));
}

/** One more layer on a drop that has so many: a pad of foam. */
function padded(drop, layers) {
  if (layers >= materials.most_layers) return;
  const pad = { thickness: "0.01", density: "100", law: "hyperfoam" };
  drop.given.set("layers.count", String(layers + 1));
  for (const [field, value] of Object.entries(pad)) drop.given.set(`layers[${layers}].${field}`, value);
  giveLaw(drop, layers, pad.law);
}

/** One layer less. */
function bare(drop, layers) {
  if (layers < 2) return;
  for (const name of [...drop.given.keys()]) if (name.startsWith(`layers[${layers - 1}].`)) drop.given.delete(name);
  drop.given.set("layers.count", String(layers - 1));
}

/** A value that follows from others without what rounding has left in its last digits. */
const rounded = text => isNaN(text) || !text ? text ?? "" : String(Number(Number(text).toPrecision(12)));

/** A bound, in powers of ten where it has many zeros. */
const short = bound => Math.abs(bound) >= 1e5 ? bound.toExponential().replace("+", "") : String(bound);

class Controls {
  /** In `place`, from the kernel's `table`; `changed` is called when the chosen drop asks for something else. */
  constructor(place, table, changed) {
    Object.assign(this, { place, table, changed, fields: new Map(), built: "" });
    Object.assign(materials, { laws: table.laws, most_layers: table.most_layers });
    this.rows = new Map(table.parameters.map(row => [row.name, row]));
    this.search = document.getElementById("search");
    this.search.oninput = () => this.filter();
  }

  /** Shows the values of a drop, and what is refused. */
  show(drop) {
    const scenario = drop.data?.scenario, layers = scenario?.layers ?? [];
    const laws = layers.map((_, layer) => scenario.values[`layers[${layer}].law`]);
    const key = JSON.stringify([drops.indexOf(drop), drop.preset, drop.toml, layers, laws]);
    if (scenario && key !== this.built) {
      const focused = document.activeElement?.id;
      this.built = key;
      this.build(layers, laws);
      if (focused?.startsWith("field-")) document.getElementById(focused)?.focus();
    }
    for (const field of this.fields.values()) this.update(field, drop);
    const { fields: refused = [], message = "" } = drop.refusal ?? {};
    const general = refused.length ? refused.filter(([name]) => !this.fields.has(name)).map(([, reason]) => reason) : [message];
    say(document.getElementById("refusal"), general.join(" "));
  }

  build(layers, laws) {
    this.fields.clear();
    const groups = new Map(), rest = document.getElementById("parameters");
    rest.replaceChildren();
    this.place.replaceChildren();
    for (const row of this.table.parameters) {
      if (row.layer !== null && row.layer >= layers.length) continue;
      const title = row.layer === null ? row.name.split(".")[0] : `Layer ${row.layer + 1}` + (layers[row.layer] ? `: ${layers[row.layer]}` : "");
      const isMain = row.main || row.field in (materials.laws[laws[row.layer]] ?? {}), field = this.field(row, isMain);
      if (!isMain) {
        rest.append(field.box);
        continue;
      }
      if (!groups.has(title)) groups.set(title, make("fieldset", {}, make("legend", { textContent: title })));
      groups.get(title).append(field.box);
    }
    this.place.append(...groups.values());
    this.filter();
  }

  /** The field of a row, among the main ones or in the list. */
  field(row, isMain) {
    const id = "field-" + row.name, unit = row.kind === "quantity" && row.unit !== "1" ? row.unit : "";
    const input = row.kind === "choice" ? make("select", { id }, ...row.labels.map(label => make("option", { value: label, textContent: label.replaceAll("_", " ") })))
      : make("input", { id, type: "text", inputMode: "decimal", autocomplete: "off", spellcheck: false });
    const label = make("label", { htmlFor: id, title: row.description }, row.field.replaceAll("_", " "), ...unit ? [" ", make("span", { className: "unit", textContent: unit })] : []);
    const legal = make("p", { className: "legal", id: id + "-legal" }), refusal = make("p", { className: "refusal", id: id + "-refusal" });
    refusal.setAttribute("role", "alert");
    input.setAttribute("aria-describedby", `${legal.id} ${refusal.id}`);
    const back = make("button", { type: "button", className: "back", textContent: "undo", onclick: () => this.take(row, null) });
    back.setAttribute("aria-label", `Undo ${row.name}`);
    const box = make("div", { className: "field" }, label, input, back);
    input.onchange = () => this.take(row, input.value);
    const field = { row, box, input, legal, refusal, back, isMain, slider: null, base: null };
    if (isMain && row.kind === "quantity") {
      field.slider = make("input", { type: "range", min: -100, max: 100, step: 1, value: 0 });
      field.slider.setAttribute("aria-label", `${row.field.replaceAll("_", " ")}, slider`);
      field.slider.oninput = () => this.take(row, this.slid(field));
      box.append(field.slider);
    }
    box.append(legal, refusal);
    this.fields.set(row.name, field);
    return field;
  }

  /** The value at the place of a slider: times or over the value it began with, or a ratio from 0 to 1. */
  slid({ row, slider, base }) {
    const part = Number(slider.value) / 100;
    const value = base > 0 ? base * REACH ** part : (part + 1) / 2 * Math.min(row.range[1], 1);
    return String(Number(Math.min(Math.max(value, row.range[0]), row.range[1]).toPrecision(3)));
  }

  /** The place of a slider for a value. */
  placeOf({ row, base }, value) {
    return Math.round(base > 0 ? 100 * Math.log(value / base) / Math.log(REACH) : 200 * value / Math.min(row.range[1], 1) - 100);
  }

  update(field, drop) {
    const { row, input, slider } = field, name = row.name, scenario = drop.data?.scenario;
    const text = drop.given.get(name) ?? rounded(scenario?.values[name]);
    if (field.base === null && scenario && name in scenario.values) field.base = Number(scenario.values[name]);
    if (input.value !== text && (document.activeElement !== input || row.kind === "choice")) input.value = text;
    if (slider && document.activeElement !== slider) slider.value = this.placeOf(field, Number(text));
    if (slider) {
      slider.hidden = !(field.base > 0 || row.unit === "1");
      mark(slider, "aria-valuetext", `${text} ${row.unit === "1" ? "" : row.unit}`);
    }
    const idle = !drop.given.has(name) && scenario?.idle[name];
    const range = row.kind === "choice" ? "" : `${short(row.range[0])} to ${short(row.range[1])}${row.unit === "1" ? "" : " " + row.unit}`;
    say(field.legal, [range, field.isMain ? "" : row.description, idle ? `no effect: ${idle}` : ""].filter(part => part).join("; "));
    field.box.classList.toggle("idle", Boolean(idle));
    field.back.hidden = !drop.given.has(name);
    const refused = drop.refusal?.fields.find(([of]) => of === name);
    say(field.refusal, refused?.[1] ?? "");
    mark(input, "aria-invalid", Boolean(refused));
  }

  /** A value that a person gives, or takes back (null). */
  take(row, text) {
    const { given } = chosen();
    if (text === null) given.delete(row.name);
    else given.set(row.name, text.trim());
    if (row.field === "law") giveLaw(chosen(), row.layer, text);
    this.changed();
  }

  /** Shows of the list of all parameters those that the search names. */
  filter() {
    const words = this.search.value.toLowerCase().split(/\s+/).filter(word => word);
    let count = 0;
    for (const { row, box, isMain } of this.fields.values()) {
      if (isMain) continue;
      const text = `${row.name} ${row.field.replaceAll("_", " ")} ${row.description} ${row.labels.join(" ")}`.toLowerCase();
      box.hidden = !words.every(word => text.includes(word));
      if (!box.hidden) count++;
    }
    document.getElementById("found").textContent = `${count} parameters`;
  }
}
