"use strict";
// The plots: force over time, force over deformation, energy over time.

const HEIGHT = 380;
const colours = data.animations.map(animation => animation.colour);
/** What the page shows: number of the animation, frame, number of the quantity. */
const shown = { animation: 0, frame: 0, shade: 0 };

const axis = (label, size) => ({
  label, size, labelSize: 24, labelFont: "14px system-ui, sans-serif", font: "13px system-ui, sans-serif",
  stroke: () => css("--ink"), grid: { stroke: () => css("--grid"), width: 1 }, ticks: { stroke: () => css("--grid"), width: 1 },
});
const axes = (x, y) => [axis(x, 46), axis(y, 64)];
const digits = (value, places) => value == null ? "–" : value.toFixed(places);

/** A plot in the figure `id`, with its buttons; it follows the width of the page. */
function plot(id, options, values) {
  const figure = document.getElementById(id), width = () => Math.max(280, figure.clientWidth);
  const chart = new uPlot({ width: width(), height: HEIGHT, ...options }, values, figure);
  const tools = Object.assign(document.createElement("span"), { className: "tools" });
  for (const [name, act] of [["Reset", () => chart.setData(chart.data)], ["PNG", () => savePng(chart.ctx.canvas, id)]]) {
    tools.append(Object.assign(document.createElement("button"), { type: "button", textContent: name, onclick: act }), " ");
  }
  figure.append(tools);
  onWidth(figure, () => chart.setSize({ width: width(), height: HEIGHT }));
  return chart;
}

/** Runs `draw` inside the axes of a chart. */
function inside(u, draw) {
  const { ctx, bbox } = u;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.lineWidth = 2 * uPlot.pxRatio;
  draw(ctx, x => u.valToPos(x, "x", true), y => u.valToPos(y, "y", true));
  ctx.restore();
}

/** Levels of the measured peaks, and where the animation is. */
function drawMarks(u) {
  inside(u, (ctx, x, y) => {
    ctx.setLineDash([6 * uPlot.pxRatio, 4 * uPlot.pxRatio]);
    data.animations.filter(animation => animation.measured).forEach(({ colour, measured }) => {
      ctx.strokeStyle = colour;
      ctx.beginPath();
      ctx.moveTo(x(measured.over[0]), y(measured.force));
      ctx.lineTo(x(measured.over[1]), y(measured.force));
      ctx.stroke();
    });
    ctx.setLineDash([]);
    const animation = data.animations[shown.animation], time = at(animation.time, shown.frame);
    ctx.strokeStyle = css("--soft");
    ctx.lineWidth = uPlot.pxRatio;
    ctx.beginPath();
    ctx.moveTo(x(time), u.bbox.top);
    ctx.lineTo(x(time), u.bbox.top + u.bbox.height);
    ctx.stroke();
  });
}

const longest = data.animations.reduce((a, b) => a.curve.time.length > b.curve.time.length ? a : b).curve.time;
const forceTime = plot("force-time", {
  axes: axes("time since contact (ms)", "contact force (N)"),
  scales: { x: { time: false } },
  cursor: { drag: { x: true, y: true, uni: 30 } },
  series: [{ label: "time (ms)", value: (u, v) => digits(v, 2) }, ...data.animations.map(animation => ({
    label: animation.label + " (N)", stroke: animation.colour, width: 2, points: { show: false }, value: (u, v) => digits(v, 0),
  }))],
  hooks: { draw: [drawMarks] },
}, [longest, ...data.animations.map(({ curve }) => longest.map((_, i) => curve.force[i] ?? null))]);
/** Says in the legend of a chart how the experiment is drawn, if there was one. */
function explain(chart, textContent) {
  if (!data.animations.some(animation => animation.measured)) return;
  chart.root.querySelector(".u-legend").append(Object.assign(document.createElement("span"), { textContent }));
}
explain(forceTime, "dashed: peak of the experiment");

/** A loop, point by point: the deformation goes and comes back. */
function drawLoop(u, number) {
  const [deformation, force] = u.data[number], animation = data.animations[number - 1];
  inside(u, (ctx, x, y) => {
    ctx.strokeStyle = animation.colour;
    ctx.beginPath();
    deformation.forEach((d, i) => i === 0 ? ctx.moveTo(x(d), y(force[i])) : ctx.lineTo(x(d), y(force[i])));
    ctx.stroke();
    if (!animation.measured) return;
    ctx.beginPath();
    ctx.arc(x(animation.measured.deformation), y(animation.measured.force), 5 * uPlot.pxRatio, 0, 2 * Math.PI);
    ctx.stroke();
  });
  return null;
}

const largest = key => Math.max(0, ...data.animations.flatMap(animation => [animation.measured?.[key] ?? 0, ...animation.curve[key]]));
// Axes of some length even where nothing was touched.
const [widest, highest] = [largest("deformation") || 1, largest("force") || 1];
const whole = { x: [0, 1.04 * widest], y: [0, 1.06 * highest] };
const forceDeformation = plot("force-deformation", {
  mode: 2,
  axes: axes("deformation (mm)", "contact force (N)"),
  scales: Object.fromEntries(["x", "y"].map(key => [key, {
    time: false, auto: true, range: (u, min, max) => u.zoomed?.[key] ?? whole[key],
  }])),
  cursor: { drag: { x: true, y: true, uni: 30, setScale: false }, dataIdx: () => null, points: { show: false } },
  legend: { live: false },
  series: [{}, ...data.animations.map(animation => ({
    label: animation.label, stroke: animation.colour, paths: drawLoop, facets: [{ scale: "x", auto: true }, { scale: "y", auto: true }],
  }))],
  hooks: {
    setSelect: [u => {
      const { left, top, width, height } = u.select;
      if (width < 3 && height < 3) return;
      u.zoomed = {
        x: width < 3 ? undefined : [u.posToVal(left, "x"), u.posToVal(left + width, "x")],
        y: height < 3 ? undefined : [u.posToVal(top + height, "y"), u.posToVal(top, "y")],
      };
      u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
      u.setData(u.data);
    }],
  },
}, [null, ...data.animations.map(({ curve }) => [curve.deformation, curve.force])]);
forceDeformation.over.addEventListener("dblclick", () => { forceDeformation.zoomed = null; forceDeformation.setData(forceDeformation.data); });
document.querySelector("#force-deformation .tools button").onclick = () => forceDeformation.over.dispatchEvent(new MouseEvent("dblclick"));
explain(forceDeformation, "circles: maxima of the experiment");

/** Sums of the terms up to each, the whole first. */
const stacked = animation => data.terms.map((_, i) => animation.energy.time.map((_, k) =>
  animation.energy.terms.slice(0, data.terms.length - i).reduce((sum, term) => sum + term[k], 0)));
const energyData = animation => [animation.energy.time, ...stacked(animation), animation.energy.external];
const termOf = number => data.terms.length - number;
const energy = plot("energy", {
  axes: axes("time since contact (ms)", "energy (J)"),
  scales: { x: { time: false }, y: { range: (u, min, max) => [Math.max(0, min), max] } },
  cursor: { drag: { x: true, y: true, uni: 30 }, points: { show: false } },
  series: [{ label: "time (ms)", value: (u, v) => digits(v, 2) }, ...data.terms.map((_, i) => {
    const { label, colour } = data.terms[termOf(i + 1)];
    const own = (u, v, number, k) => digits(k == null ? null : data.animations[shown.animation].energy.terms[termOf(number)][k], 3);
    return { label: label + " (J)", stroke: colour, fill: colour, width: 0, points: { show: false }, value: own };
  }), { label: "brought in (J)", stroke: () => css("--ink"), width: 2, points: { show: false }, value: (u, v) => digits(v, 3) }],
}, energyData(data.animations[0]));
