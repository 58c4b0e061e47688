"use strict";
// The drops on the page: what is asked for each, what came of it; and the part of the address that says so.

/** Drops that the page shows at most. */
const MOST_DROPS = 4;
const drops = [];
/** What the page shows: the drop whose controls are there, the time since contact in ms, the number of the stress. */
const shown = { drop: 0, time: 0, shade: 0, mesh: false };

const letter = index => "ABCD"[index];
const chosen = () => drops[shown.drop];
const ready = () => drops.filter(drop => drop.data);

/** A drop of `asked` (preset, text of a scenario file, values given over both). */
function newDrop({ preset = "study", toml = "", given = [], name = "" }, data = null) {
  return { preset, toml, given: new Map(given), name, data, refusal: null, measured: null, file: null, understood: "", asked: 0 };
}

const askedOf = drop => ({ preset: drop.preset, toml: drop.toml, given: [...drop.given] });

/** What a legend calls a drop. */
function labelOf(drop) {
  const field = name => name.replace(/^.*\./, "").replaceAll("_", " ");
  const changes = [...drop.given].slice(0, 2).map(([name, text]) => `${field(name)} ${text}`);
  const more = drop.given.size > 2 ? [`${drop.given.size - 2} more`] : [];
  const name = drop.name || (drop.toml ? `${drop.preset} with a file` : drop.preset);
  const head = drops.length > 1 || !drop.name ? `${letter(drops.indexOf(drop))}: ${name}` : name;
  return [head, ...changes, ...more].join(", ");
}

/** The drops as the fragment of an address: preset;name=value;..., a drop after a bar. */
function toFragment() {
  const part = encodeURIComponent;
  return drops.map(drop => [
    part(drop.preset), ...drop.toml ? ["file=" + part(drop.toml)] : [], ...drop.name ? ["name=" + part(drop.name)] : [],
    ...[...drop.given].map(([name, text]) => `${part(name)}=${part(text)}`),
  ].join(";")).join("|");
}

/** The drops that a fragment asks for; none if it asks for none. */
function fromFragment(text) {
  const pieces = text.replace(/^#/, "").split("|").filter(piece => piece).slice(0, MOST_DROPS);
  try {
    return pieces.map(piece => {
      const [preset, ...values] = piece.split(";").map(value => value.split("=").map(decodeURIComponent));
      const of = key => values.find(([name]) => name === key)?.[1] ?? "";
      const given = values.filter(([name, value]) => !["file", "name"].includes(name) && value !== undefined);
      return newDrop({ preset: preset[0], toml: of("file"), name: of("name"), given });
    });
  } catch {
    // No text is encoded so.
    return [];
  }
}
