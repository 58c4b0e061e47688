"use strict";
// Files out of the page and into it.

/** Offers a file. */
function save(name, content, type) {
  const link = document.createElement("a"), blob = content instanceof Blob ? content : new Blob([content], { type });
  link.download = name;
  link.href = URL.createObjectURL(blob);
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/** Offers a canvas as PNG, on white. */
function saveCanvas(canvas, name) {
  const copy = Object.assign(document.createElement("canvas"), { width: canvas.width, height: canvas.height });
  const context = copy.getContext("2d");
  context.fillStyle = css("--card");
  context.fillRect(0, 0, copy.width, copy.height);
  context.drawImage(canvas, 0, 0);
  copy.toBlob(blob => save(name + ".png", blob));
}

/** Offers a picture as PNG of twice its size, in the colours of files. */
async function savePicture(svg, name) {
  const [width, height] = ["width", "height"].map(key => Number(svg.getAttribute(key)));
  const image = new Image(2 * width, 2 * height);
  image.src = "data:image/svg+xml;charset=utf-8," + encodeURIComponent(new XMLSerializer().serializeToString(svg));
  await image.decode();
  const canvas = Object.assign(document.createElement("canvas"), { width: 2 * width, height: 2 * height });
  canvas.getContext("2d").drawImage(image, 0, 0, 2 * width, 2 * height);
  canvas.toBlob(blob => save(name + ".png", blob));
}

/** Hands every file that is dropped on the page or chosen to `open(name, bytes)`. */
function takeFiles(input, open) {
  const take = async files => { for (const file of files) open(file.name, new Uint8Array(await file.arrayBuffer())); };
  input.onchange = () => { take([...input.files]); input.value = ""; };
  addEventListener("dragover", event => event.preventDefault());
  addEventListener("drop", event => {
    event.preventDefault();
    take([...event.dataTransfer.files]);
  });
}
