"use strict";
// The section of a drop on a canvas: regions of colour between the corners of triangles, core and impactor.

/** Colours of the style by their names, read once for light and once for dark: a look at the style after every change of the page would
    work all of it out anew. */
const colours = new Map();
const css = name => {
  if (!colours.has(name)) colours.set(name, getComputedStyle(document.documentElement).getPropertyValue(name).trim());
  return colours.get(name);
};

/** The number of the frame at a time, with the part to the next one. */
function frameAt(section, time) {
  const { time: times } = section, last = times.length - 1;
  if (last < 1) return 0;
  return Math.min(Math.max((time - times[0]) / (times[last] - times[0]) * last, 0), last);
}

/** Numbers of a packed array at a time between two frames, `count` a frame. */
function between({ values, quantum }, count, frame) {
  const last = values.length / count - 1;
  const first = Math.min(Math.floor(frame), last), second = Math.min(first + 1, last), part = frame - first;
  return Float64Array.from({ length: count }, (_, i) => {
    const value = values[first * count + i];
    return quantum * (value + part * (values[second * count + i] - value));
  });
}

/** A value between two frames of an array with one number a frame. */
function at(values, frame) {
  const first = Math.min(Math.floor(frame), values.length - 1), second = Math.min(first + 1, values.length - 1);
  return values[first] + (frame - first) * (values[second] - values[first]);
}

/** Adds to the path the part of a triangle where the value is at least `level`. */
function addRegion(path, x, y, value, nodes, level, sign) {
  let begun = false;
  const go = (px, py) => { if (begun) path.lineTo(sign * px, py); else path.moveTo(sign * px, py); begun = true; };
  for (let k = 0; k < 3; k++) {
    const a = nodes[k], b = nodes[(k + 1) % 3];
    if (value[a] >= level) go(x[a], y[a]);
    if (value[a] >= level !== value[b] >= level) {
      const part = (level - value[a]) / (value[b] - value[a]);
      go(x[a] + part * (x[b] - x[a]), y[a] + part * (y[b] - y[a]));
    }
  }
  if (begun) path.closePath();
}

/** A canvas of so many px, with a context in px. */
function sized(canvas, width, height) {
  const ratio = window.devicePixelRatio || 1;
  canvas.style.height = height + "px";
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const context = canvas.getContext("2d");
  context.scale(ratio, ratio);
  return context;
}

/** Draws a section at a time on a canvas of a width in px, in bands of colour. */
function drawSection(canvas, width, section, time, shade, bands, showMesh) {
  const { mesh, impactor } = section, scale = width / (2.06 * mesh.reach);
  const height = Math.round(scale * (mesh.top + impactor.gap + impactor.slab) + 4), frame = frameAt(section, time);
  const context = sized(canvas, width, height);
  context.transform(scale, 0, 0, -scale, 0.5 * width, height - 2);
  context.lineWidth = 1 / scale;
  const count = mesh.x.length, moved = between(section.displacement, 2 * count, frame), mm = 1000;
  const x = mesh.x.map((rest, i) => rest + mm * moved[2 * i]), y = mesh.y.map((rest, i) => rest + mm * moved[2 * i + 1]);
  const sides = mesh.half ? [1, -1] : [1];
  fillCore(context, mesh, sides);
  const value = between(section.shades[shade], count, frame);
  bands.colours.forEach((colour, band) => {
    const path = new Path2D(), level = band === 0 ? -Infinity : bands.bounds[band];
    for (const sign of sides) for (const nodes of mesh.triangles) addRegion(path, x, y, value, nodes, level, sign);
    context.fillStyle = colour;
    context.fill(path);
  });
  strokeLayers(context, mesh, x, y, sides, showMesh);
  drawImpactor(context, impactor, mesh.top + at(section.face, frame));
}

function fillCore(context, mesh, sides) {
  const core = new Path2D();
  for (const sign of sides) {
    mesh.core.forEach(([px, py], i) => i === 0 ? core.moveTo(sign * px, py) : core.lineTo(sign * px, py));
    core.closePath();
  }
  context.fillStyle = css("--steel");
  context.fill(core);
}

function strokeLayers(context, mesh, x, y, sides, showMesh) {
  for (const sign of sides) {
    const line = new Path2D();
    const along = nodes => nodes.forEach((n, i) => i === 0 ? line.moveTo(sign * x[n], y[n]) : line.lineTo(sign * x[n], y[n]));
    mesh.outlines.forEach(along);
    if (showMesh) for (const nodes of mesh.triangles) { along(nodes); line.closePath(); }
    context.strokeStyle = showMesh ? "rgba(255,255,255,.45)" : css("--ink");
    context.stroke(line);
  }
}

function drawImpactor(context, { outline }, face) {
  const path = new Path2D();
  outline.forEach(([px, py], i) => i === 0 ? path.moveTo(px, face + py) : path.lineTo(px, face + py));
  path.closePath();
  context.fillStyle = css("--steel");
  context.strokeStyle = css("--ink");
  context.fill(path);
  context.stroke(path);
}

/** Draws the bar of the bands of colour. */
function drawBar(canvas, width, label, { bounds, colours, texts, unit, zero }) {
  const step = width / colours.length, context = sized(canvas, width, 56);
  colours.forEach((colour, band) => {
    context.fillStyle = colour;
    context.fillRect(band * step, 6, step + 0.5, 12);
  });
  const every = Math.max(1, Math.ceil(48 / step));
  context.fillStyle = css("--ink");
  context.font = "13px system-ui, sans-serif";
  bounds.forEach((_, i) => {
    if (i % every !== zero % every) return;
    context.textAlign = i === 0 ? "left" : i === colours.length ? "right" : "center";
    context.fillText(texts[i], i * step, 33);
  });
  context.textAlign = "left";
  context.fillText(`${label} (${unit})`, 0, 51);
}
