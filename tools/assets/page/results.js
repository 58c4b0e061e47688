"use strict";
// Numbers of the drops beside each other, and what has to be known of them.

/** The table of results: a column for each drop, and for what was measured. */
function showResults() {
  const shownDrops = ready(), measured = chosen()?.measured, head = ["result", ...shownDrops.map(labelOf)];
  if (measured) head.push(measured.curve.label);
  const two = shownDrops.length === 2;
  if (two) head.push("second of the first");
  const cell = (text, label) => {
    const made = make("td", { textContent: text });
    made.dataset.label = label;
    return made;
  };
  const rows = (shownDrops[0]?.data.numbers ?? []).map(({ label, unit, output }) => {
    const numbers = shownDrops.map(drop => drop.data.numbers.find(number => number.output === output));
    const cells = numbers.map((number, i) => cell(number?.text ?? "–", head[i + 1]));
    if (measured) cells.push(cell(measured.numbers[output]?.text ?? "–", measured.curve.label));
    if (two) cells.push(cell(numbers[0]?.value ? digits(100 * numbers[1].value / numbers[0].value, 0) + " %" : "–", "second of the first"));
    return make("tr", {}, make("th", { scope: "row", textContent: `${label} (${unit})` }), ...cells);
  });
  const hashes = shownDrops.map((drop, i) => cell(drop.data.hash ?? "…", head[i + 1]));
  rows.push(make("tr", { className: "hash" }, make("th", { scope: "row", textContent: "digest of the trace" }), ...hashes));
  const table = document.getElementById("results");
  table.tHead.replaceChildren(make("tr", {}, ...head.map(text => make("th", { scope: "col", textContent: text }))));
  table.tBodies[0].replaceChildren(...rows);
  showWords(shownDrops);
}

function showWords(shownDrops) {
  const about = shownDrops.flatMap(drop => [...drop.data.words, drop.data.remark].filter(words => words).map(words => shownDrops.length > 1 ? `${labelOf(drop)}: ${words}` : words));
  document.getElementById("words").replaceChildren(...about.map(textContent => make("li", { textContent })));
  document.getElementById("about").textContent = chosen()?.data?.about ?? "";
  document.getElementById("understood").textContent = chosen()?.understood ?? "";
}

/** What the plots show: pictures for the kernel, and legends. */
const CONTENT = {
  forces(legend) {
    const curves = ready().map(drop => ({ ...drop.data.force_time, label: labelOf(drop) }));
    curves.push(...ready().flatMap(drop => drop.measured ? [drop.measured.curve] : []));
    const entries = curves.map((curve, i) => ({
      swatch: () => swatch(legend.runs[i % legend.runs.length]),
      label: curve.label,
      at: time => {
        const force = valueAt(curve.points, time);
        return { text: `${digits(force, 0)} N`, point: force === null ? null : [time, force] };
      },
    }));
    if (curves.some(curve => curve.measured)) entries.push(ofExperiment("experiment: peak", { colour: "currentColor", dash: [6, 4] }));
    return { of: curves.length ? { force_time: curves } : null, legend: entries };
  },
  loops(legend) {
    const curves = ready().map(drop => ({ ...drop.data.force_deformation, label: labelOf(drop) }));
    const entries = ready().map((drop, i) => ({
      swatch: () => swatch(legend.runs[i % legend.runs.length]),
      label: labelOf(drop),
      at: time => {
        const point = stateAt(drop, time);
        return { text: `${digits(point?.[0], 2)} mm, ${digits(point?.[1], 0)} N`, point };
      },
    }));
    if (curves.some(curve => curve.measured)) entries.push(ofExperiment("experiment: maxima (circles)", { colour: "none" }));
    return { of: curves.length ? { force_deformation: curves } : null, legend: entries };
  },
  energy(legend) {
    const balance = chosen()?.data?.energy;
    if (!balance) return { of: null, legend: [] };
    const entry = (label, style, values, isArea) => {
      const points = balance.time.map((time, i) => [time, values[i]]);
      return { swatch: () => swatch(style, isArea), label, at: time => ({ text: `${digits(valueAt(points, time), 2)} J` }) };
    };
    const terms = balance.terms.map(([place, values]) => entry(legend.terms[place].label, legend.terms[place], values, true));
    return { of: { energy: balance }, legend: [entry("brought in", { colour: "currentColor" }, balance.external), ...terms.reverse()] };
  },
};

const ofExperiment = (label, style) => ({ swatch: () => swatch(style), label, at: () => ({ text: "" }) });
