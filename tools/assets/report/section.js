"use strict";
// The section on a canvas: regions of colour between the corners of triangles, core and impactor.

const data = JSON.parse(document.getElementById("data").textContent);
const css = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/** Whole numbers of 16 bits from base64, little-endian. */
function integers(text) {
  const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
  const view = new DataView(bytes.buffer);
  return Int16Array.from({ length: bytes.length / 2 }, (_, i) => view.getInt16(2 * i, true));
}

for (const animation of data.animations) {
  animation.displacement = integers(animation.displacement);
  animation.shades = animation.shades.map(integers);
}

/** Numbers of a packed array at a time between two frames, `count` a frame. */
function between(packed, quantum, count, frame) {
  const last = packed.length / count - 1;
  const first = Math.min(Math.floor(frame), last), second = Math.min(first + 1, last), part = frame - first;
  return Float64Array.from({ length: count }, (_, i) => {
    const value = packed[first * count + i];
    return quantum * (value + part * (packed[second * count + i] - value));
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

/** Draws the section of a animation at a frame, over the whole canvas. */
function drawSection(canvas, animation, frame, shade, showMesh) {
  const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth, mesh = data.mesh;
  const widest = 2 * mesh.reach * 1.03, scale = width / widest;
  const height = Math.round(scale * (mesh.top + data.impactor.gap + data.impactor.slab) + 4);
  canvas.style.height = height + "px";
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const context = canvas.getContext("2d");
  context.setTransform(scale * ratio, 0, 0, -scale * ratio, 0.5 * width * ratio, (height - 2) * ratio);
  context.lineWidth = 1 / scale;
  const count = mesh.x.length, moved = between(animation.displacement, data.displacement_quantum, 2 * count, frame);
  const x = mesh.x.map((rest, i) => rest + moved[2 * i]), y = mesh.y.map((rest, i) => rest + moved[2 * i + 1]);
  const sides = mesh.half ? [1, -1] : [1];
  fillCore(context, sides);
  const value = between(animation.shades[shade], data.shades[shade].quantum, count, frame);
  data.shades[shade].colours.forEach((colour, band) => {
    const level = band === 0 ? -Infinity : data.shades[shade].bounds[band];
    const path = new Path2D();
    for (const sign of sides) for (const nodes of mesh.triangles) addRegion(path, x, y, value, nodes, level, sign);
    context.fillStyle = colour;
    context.fill(path);
  });
  strokeLayer(context, x, y, sides, showMesh);
  const face = mesh.top + at(animation.face, frame), impactor = new Path2D();
  data.impactor.outline.forEach(([px, py], i) => i === 0 ? impactor.moveTo(px, face + py) : impactor.lineTo(px, face + py));
  impactor.closePath();
  context.fillStyle = css("--steel");
  context.strokeStyle = css("--ink");
  context.fill(impactor);
  context.stroke(impactor);
}

function fillCore(context, sides) {
  const core = new Path2D();
  for (const sign of sides) {
    data.mesh.core.forEach(([px, py], i) => i === 0 ? core.moveTo(sign * px, py) : core.lineTo(sign * px, py));
    core.closePath();
  }
  context.fillStyle = css("--steel");
  context.fill(core);
}

function strokeLayer(context, x, y, sides, showMesh) {
  for (const sign of sides) {
    const line = new Path2D();
    const along = nodes => nodes.forEach((n, i) => i === 0 ? line.moveTo(sign * x[n], y[n]) : line.lineTo(sign * x[n], y[n]));
    data.mesh.outlines.forEach(along);
    if (showMesh) for (const nodes of data.mesh.triangles) { along(nodes); line.closePath(); }
    context.strokeStyle = showMesh ? "rgba(255,255,255,.45)" : css("--ink");
    context.stroke(line);
  }
}

/** Draws the colour bar of a quantity. */
function drawBar(canvas, shade) {
  const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth, height = 56;
  canvas.style.height = height + "px";
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const context = canvas.getContext("2d");
  context.scale(ratio, ratio);
  const { bounds, colours, texts, label, unit, zero } = data.shades[shade], step = width / colours.length;
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

/** Offers a canvas as a PNG file, on the page's background. */
function savePng(canvas, name) {
  const copy = document.createElement("canvas");
  copy.width = canvas.width;
  copy.height = canvas.height;
  const context = copy.getContext("2d");
  context.fillStyle = css("--card");
  context.fillRect(0, 0, copy.width, copy.height);
  context.drawImage(canvas, 0, 0);
  const link = document.createElement("a");
  link.download = name + ".png";
  link.href = copy.toDataURL("image/png");
  link.click();
}

/** Calls `act` when the width of `element` has changed; never in a loop over heights. */
function onWidth(element, act) {
  let width = element.clientWidth;
  new ResizeObserver(() => {
    if (element.clientWidth === width) return;
    width = element.clientWidth;
    requestAnimationFrame(act);
  }).observe(element);
}
