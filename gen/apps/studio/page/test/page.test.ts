/** What of the page needs no browser: edits of texts, whose value counts, sliders, keys. */

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { parse } from "jsonc-parser";
import { changedOrganisms, grownFrom } from "../src/changes";
import { reckon } from "../src/controls/reckon";
import { scaleOf, usualScale, valueAt } from "../src/controls/scale";
import { insertAt, removeAt, setAt } from "../src/edits";
import { handleAt, keyLists, keysOf, valueAtTime, wayOf, withKey } from "../src/keyframes";
import { balanced, boundsOf, colorAt, flooded, largestPiece, upright, type Pixels } from "../src/photographs/pixels";
import { getAt, isObject, type Path } from "../src/pointer";
import { inOrderOf } from "../src/panels/add_organism";
import { beside, Preset, speciesIn } from "../src/preset";
import { fieldOf, PresetSchema, type NumberField } from "../src/schema";
import { relativeTo, withSpecies } from "../src/species";
import { sizeFor } from "../src/film_size";
import { lostEdits } from "../src/lost_edits";
import { suggested } from "../src/panels/saving";
import { partsFor } from "../src/materials";
import { Stand } from "../src/view/copies";
import type { Studio } from "../src/view/drawn";
import type { CopiesPart } from "../src/view/header";
import type { Packet } from "../src/view/packet";
import { frameNear, timesOver } from "../src/panels/storyboard";
import { viewsOf } from "../src/panels/views";
import type { Header, Part } from "../src/view/header";
import { merged } from "../src/view/merge";
import { LONGEST, Pace } from "../src/view/pace";
import { enlarged, everyOf, firstOf, LARGEST } from "../src/view/thinning";

const TEXT = `{
  // What it is
  "title": "One", // said here
  "scene": {"floor": {"relief": 0.1}},
  "organisms": [
    {"kind": "coral", "height": 1}, /* the first */
    {"kind": "rock"} // the last
  ]
}
`;

test("a value is changed and all else stays", () => {
  assert.equal(setAt(TEXT, ["scene", "floor", "relief"], 0.2), TEXT.replace("0.1", "0.2"));
});

test("a member is added as its neighbours stand", () => {
  assert.ok(setAt(TEXT, ["scene", "floor", "scale"], 3).includes('{"relief": 0.1, "scale": 3}'));
  assert.ok(setAt(TEXT, ["seed"], 4).endsWith('  ],\n  "seed": 4\n}\n'));
  assert.ok(setAt(TEXT, ["film", "fps"], 4).includes('"film": {"fps": 4}'));
});

test("what was added is removed without a trace", () => {
  for (const path of [["seed"], ["scene", "floor", "scale"], ["film", "fps"], ["organisms", 0, "wave", "speed"]] as Path[])
    assert.equal(removeAt(setAt(TEXT, path, 7), path), TEXT);
});

test("comments stay at what they belong to", () => {
  const added = setAt('{\n  "a": 1 // one\n}', ["b"], 2);
  assert.equal(added, '{\n  "a": 1, // one\n  "b": 2\n}');
  const removed = removeAt('{\n  "a": 1, // one\n  "b": 2}', ["b"]);
  assert.deepEqual(parse(removed), { a: 1 });
  assert.ok(removed.includes("// one\n"));
});

test("items of lists come and go", () => {
  const more = insertAt(TEXT, ["organisms"], 2, { kind: "ivy" });
  assert.ok(more.includes('{"kind": "rock"}, // the last\n    {"kind": "ivy"}\n'));
  const fewer = removeAt(TEXT, ["organisms", 0]);
  assert.deepEqual((parse(fewer) as { organisms: unknown }).organisms, [{ kind: "rock" }]);
  const between = parse(insertAt(TEXT, ["organisms"], 1, { kind: "ivy" })) as { organisms: { kind: string }[] };
  assert.deepEqual(between.organisms.map((o) => o.kind), ["coral", "ivy", "rock"]);
});

test("any edit of a text does to its value what it says", () => {
  const before = parse(TEXT) as unknown;
  const paths: Path[] = [];
  const walk = (value: unknown, path: Path): void => {
    if (path.length) paths.push(path);
    if (Array.isArray(value)) value.forEach((v, i) => walk(v, [...path, i]));
    else if (isObject(value)) Object.entries(value).forEach(([k, v]) => walk(v, [...path, k]));
  };
  walk(before, []);
  assert.ok(paths.length > 8);
  for (const path of paths) {
    assert.deepEqual(getAt(parse(setAt(TEXT, path, [1, { x: "y" }])), path), [1, { x: "y" }]);
    const errors: never[] = [];
    parse(removeAt(TEXT, path), errors, { allowTrailingComma: false });
    assert.deepEqual(errors, [], path.join("/"));
  }
});

test("an organism's own value wins, then the scene's, and force turns that round", () => {
  const text = (force: string): string =>
    `{"defaults": {"wave": {"amplitude": 9}}, "force": ${force}, "organisms": [{"kind": "coral", "wave": {"amplitude": 4, "speed": 1}, "lift": 1}]}`;
  const free = new Preset(text("[]"));
  assert.deepEqual(free.organism(0).wave, { amplitude: 4, speed: 1 });
  assert.equal(free.scope(0, ["wave", "amplitude"]), "own");
  assert.equal(free.scope(0, ["wave", "phase"]), "unset");
  const part = new Preset(text('["wave/amplitude", "lift"]'));
  assert.deepEqual(part.organism(0).wave, { amplitude: 9, speed: 1 });
  assert.equal(part.organism(0).lift, undefined);
  assert.equal(part.scope(0, ["wave", "amplitude"]), "all");
  assert.deepEqual(new Preset(text('["wave"]')).organism(0).wave, { amplitude: 9 });
});

test("a base lies below, and lists count as a whole", () => {
  const preset = new Preset('{"title": "mine", "organisms": [{"kind": "ivy"}]}', { seed: 3, title: "base", organisms: [{}, {}] });
  assert.equal(preset.whole.seed, 3);
  assert.equal(preset.title, "mine");
  assert.equal(preset.organisms.length, 1);
  assert.equal(beside("/a/b/c.json", "../d.json"), "/a/d.json");
  assert.equal(beside("c.json", "d.json"), "d.json");
});

test("a slider reaches both ends, and its way back is its way there", () => {
  for (const [minimum, maximum, standard] of [[0, 1, 0.5], [0.0001, 100, 0.05], [0, 1000, 2], [-1e6, 1e6, 0], [-180, 180, 25], [0, 5000, 50]]) {
    const field = fieldOf({ type: "number", minimum, maximum, default: standard }, "") as NumberField;
    const scale = scaleOf(field);
    assert.equal(valueAt(scale, field, 0), minimum);
    assert.equal(valueAt(scale, field, 1), maximum);
    let last = -Infinity;
    for (let way = 0.05; way < 1; way += 0.05) {
      const value = scale.toValue(way);
      assert.ok(value > last);
      assert.ok(Math.abs(scale.toWay(value) - way) < 1e-6, `${minimum}..${maximum} at ${way}`);
      last = value;
    }
  }
});

test("between keys a value goes smoothly, and rests at the ends", () => {
  const keys = [[0, 0], [1, 10], [3, 10]];
  assert.equal(valueAtTime(keys, -1), 0);
  assert.equal(valueAtTime(keys, 0.5), 5);
  assert.equal(valueAtTime(keys, 2), 10);
  assert.equal(valueAtTime(7, 2), 7);
  assert.deepEqual(valueAtTime([[0, [0, 4]], [2, [2, 4]]], 1), [1, 4]);
  assert.deepEqual(withKey(keys, 1.01, 8), [[0, 0], [1.01, 8], [3, 10]]);
});

test("a key says how the way to the next one goes", () => {
  assert.equal(valueAtTime([[0, 0, "in"], [2, 8]], 1), 2);
  assert.equal(valueAtTime([[0, 0, { ease: "none" }], [2, 8], [3, 0]], 0.5), 2);
  // A handle bends the way, and the one that is missing is opposite to it.
  const bent = [[0, [0, 0, 0], { out: [0, 3, 0] }], [2, [6, 0, 0], { in: [0, 3, 0] }]];
  assert.deepEqual(valueAtTime(bent, 1), [3, 2.25, 0]);
  const way = wayOf(keysOf(bent)!, 4);
  assert.deepEqual([...way.slice(6, 9)], [3, 2.25, 0]);
  assert.deepEqual(handleAt(keysOf([[0, [0, 0, 0]], [1, [1, 1, 1], { out: [0, 1, 0] }], [2, [4, 4, 4]]])!, 1, "in"), [-0, -1, -0]);
  assert.deepEqual(withKey([[0, 1, "both"], [2, 3]], 0, 5), [[0, 5, "both"], [2, 3]]);
  assert.equal(keyLists({ angle: [[0, 1, "in"], [2, 3]], ends: [[0, 1, 2], [3, 4, 5]] }).length, 1);
});

const SCHEMA = JSON.parse(readFileSync(new URL("../../../../../docs/preset.schema.json", `file://${process.cwd()}/test/`), "utf8")) as Record<string, unknown>;

test("the schema of presets is read whole", () => {
  const schema = new PresetSchema(SCHEMA);
  assert.ok(schema.kinds.length > 10 && schema.kinds.every((k) => k.doc));
  for (const { value } of schema.kinds) assert.ok(schema.kind(value).fields.size > 8, value);
  const skin = schema.at(["organisms", 0, "skin", "tint", "base"], ["coral"]);
  assert.equal(skin?.type, "color");
  assert.equal(schema.at(["scene", "camera", "angle"], [])?.type, "keyed");
  assert.equal(schema.at(["scene", "camera", "angle"], [])?.unit, "°");
  assert.equal(schema.at(["defaults", "season"], ["tree"])?.type, "object");
});

test("the subject is what the camera is set to, what the title names, or the first that lives", () => {
  const subject = (text: object): number => new Preset(JSON.stringify(text)).subject;
  const bonsai = [{ kind: "vase", name: "plinth" }, { kind: "vase", name: "pot" }, { kind: "tree", name: "pine" }];
  assert.equal(subject({ title: "A bonsai", organisms: bonsai }), 2);
  assert.equal(subject({ title: "A pot", organisms: bonsai }), 1);
  assert.equal(subject({ title: "The plinth", scene: { camera: { focus: "pot" } }, organisms: bonsai }), 1);
  assert.equal(subject({ title: "Two", organisms: [{ kind: "bridge" }, { kind: "plant", name: "bush" }] }), 1);
  assert.equal(subject({ organisms: [{ kind: "rock" }] }), 0);
});

test("kinds to add come in the order of the setting", () => {
  const kinds = ["coral", "rock", "tree"].map((value) => ({ value }));
  const order = (setting: string): string => inOrderOf(setting, kinds).map(({ value }) => value).join();
  assert.equal(order("underwater"), "coral,rock,tree");
  assert.equal(order("garden"), "tree,rock,coral");
});

test("a kind names what shapes it most, and all of it exists", () => {
  const schema = new PresetSchema(SCHEMA);
  const missing = schema.kinds.flatMap(({ value }) => schema.leading(value)
    .filter((path) => !schema.at(["organisms", 0, ...path], [value])).map((path) => `${value}: ${path.join("/")}`));
  assert.deepEqual(missing, []);
});

test("a stand of which nothing is seen from afar makes no errors", (t) => {
  const errors = t.mock.method(console, "error", () => undefined);
  const packet = { header: {} as Header, base: 0, bytes: new Float32Array(10).buffer } as unknown as Packet;
  const part = { kind: "copies", id: "a", entry: 0, specimen: -1, model: 0, levels: [{ grain: 0, parts: [] }, { grain: 1, parts: [] }], instances: { at: 0, n: 10, t: "f32" } } as CopiesPart;
  assert.equal(new Stand(packet, part, { shared: {}, pictures: {} } as unknown as Studio).drawn().length, 0);
  assert.equal(errors.mock.callCount(), 0);
});

test("leaves are swapped for those of the same kind, surfaces for any that fit", () => {
  const schema = new PresetSchema(SCHEMA);
  const oak = { file: "oak.json", name: "oak", kind: "tree", values: { bark: { kind: "bark" }, leaves: { size: 0.1 } } };
  const ivy = { file: "ivy.json", name: "ivy", kind: "ivy", values: { bark: { kind: "bark" }, leaves: { size: 0.05 } } };
  assert.deepEqual(partsFor(schema, [oak, ivy], "tree", "leaves").map(({ values }) => values), [{ leaves: { size: 0.1 } }]);
  assert.deepEqual(partsFor(schema, [oak, ivy], "tree", "surface").map(({ values }) => values), [{ bark: { kind: "bark" } }], "alike ones once");
  assert.deepEqual(partsFor(schema, [oak], "rock", "surface"), []);
});

test("few things are neither thinned nor enlarged, and many do not balloon", () => {
  for (const count of [1, 2, 50, 399, 799]) {
    assert.equal(everyOf(count, 0.02), 1);
    assert.equal(enlarged(everyOf(count, 0.02)), 1);
  }
  assert.equal(firstOf(30, 0.02), 30);
  assert.equal(firstOf(3900, 0.02), 3900, "a plant of few pieces is never cut");
  assert.equal(everyOf(1e6, 1), 1);
  assert.equal(everyOf(1e6, 0.02), 50);
  assert.ok(1e5 / everyOf(1e5, 1e-9) >= 400);
  assert.equal(firstOf(1e5, 0.1), 1e4);
  assert.ok(enlarged(50) <= LARGEST && LARGEST <= 2);
});

const SPECIES = `{"defaults": {"wave": {"amplitude": 3}}, "organisms": [
  {"kind": "massive", "name": "brain", "count": 9, "place": {"at": [[0, 0]], "rock": 0.5}, "height": 0.2, "colors": ["#112233"], "tissue": {"color": "#a98a4c", "cup": 0.003}, "file": "a.obj"}]}`;
const OF_SPECIES = `{
  // A reef
  "defaults": {"height": 7, "lumps": 2},
  "organisms": [
    {"species": "s/brain.json", "place": {"at": [[1, 1]]}, "tissue": {"cup": 0.1}} // mine
  ]
}
`;

test("what a species says counts where the organism says nothing", () => {
  const species = speciesIn(new Preset(SPECIES))!;
  const preset = new Preset(OF_SPECIES, {}, (name) => (name === "s/brain.json" ? species : undefined));
  assert.deepEqual([preset.kindOf(0), preset.nameOf(0)], ["massive", "brain"]);
  const whole = preset.organism(0);
  assert.deepEqual(whole.place, { at: [[1, 1]], rock: 0.5 });
  assert.deepEqual(whole.tissue, { color: "#a98a4c", cup: 0.1 });
  assert.deepEqual([whole.height, whole.lumps, whole.count], [0.2, 2, undefined]);
  assert.deepEqual(whole.wave, { amplitude: 3 });
  const scopes = [["height"], ["lumps"], ["tissue", "cup"], ["tissue", "color"], ["count"]].map((path) => preset.scope(0, path));
  assert.deepEqual(scopes, ["species", "all", "own", "species", "unset"]);
});

test("a species that becomes one's own leaves comments where they are", () => {
  const species = speciesIn(new Preset(SPECIES))!;
  const preset = new Preset(OF_SPECIES);
  const own = withSpecies(OF_SPECIES, ["organisms", 0], preset.organisms[0], species, (name) => relativeTo("/home/reef.json", beside("/home/s/brain.json", name)));
  assert.ok(own.includes("// A reef\n") && own.includes("// mine\n") && own.includes('{"kind": "massive", '));
  const organism = new Preset(own).organisms[0]!;
  assert.equal(organism.species, undefined);
  assert.deepEqual(organism.tissue, { cup: 0.1, color: "#a98a4c" });
  assert.deepEqual(organism.place, { at: [[1, 1]], rock: 0.5 });
  assert.equal(organism.file, "s/a.obj");
});

test("a file is named as seen from another", () => {
  assert.equal(relativeTo("/a/b/x.json", "/a/b/s/y.json"), "s/y.json");
  assert.equal(relativeTo("/a/b/x.json", "/a/c/y.json"), "../c/y.json");
  assert.equal(beside("/a/b/x.json", relativeTo("/a/b/x.json", "/q/y.json")), "/q/y.json");
});

test("numbers are read as people type them", () => {
  const read: [string, string, number][] = [
    ["1,5", "", 1.5], ["1.5", "", 1.5], ["1.234,5", "", 1234.5], ["1,234.5", "", 1234.5], ["1.234.567", "", 1234567], [",5", "", 0.5],
    ["2*0.7", "", 1.4], ["2 * 0,7", "", 1.4], ["(1+2)/4", "", 0.75], ["-3--1", "", -2], ["−2", "", -2], ["1e-3", "", 0.001], ["3*0.1", "", 0.3],
    ["50cm", "m", 0.5], ["5 mm", "m", 0.005], ["1.2 km", "m", 1200], ["1m+20cm", "m", 1.2], ["(1+1)cm", "m", 0.02], ["90°", "°", 90], ["30 deg", "°", 30], ["50%", "", 0.5],
  ];
  for (const [text, unit, value] of read) assert.deepEqual(reckon(text, unit), { value }, text);
});

test("what is no number is told of", () => {
  for (const [text, unit] of [["", ""], ["abc", ""], ["1..2", ""], ["2*", ""], ["(1", ""], ["1)", ""], ["5 cm", "°"], ["5 kg", "m"], ["3cm", ""], ["1/0", ""]] as const)
    assert.ok("wrong" in reckon(text, unit), text);
});

test("a slider reaches what one usually wants, and what is typed beyond it", () => {
  const years = fieldOf({ type: "integer", minimum: 0, maximum: 499, default: 20 }, "") as NumberField;
  assert.deepEqual([usualScale(years, 29).low, usualScale(years, 29).high], [0, 87]);
  assert.ok(usualScale(years, 300).high >= 300);
  const turn = fieldOf({ type: "number", minimum: -180, maximum: 180, default: 25, description: "Turn (degrees)" }, "") as NumberField;
  assert.deepEqual([usualScale(turn, 25).low, usualScale(turn, 25).high], [-180, 180]);
  const share = fieldOf({ type: "number", minimum: 0, maximum: 1, default: 0.05 }, "") as NumberField;
  assert.equal(usualScale(share, 0.05).high, 1);
  const raise = fieldOf({ type: "number", minimum: -100, maximum: 1000, default: 0 }, "") as NumberField;
  const scale = usualScale(raise, 0);
  assert.deepEqual([valueAt(scale, raise, 0), valueAt(scale, raise, 1)], [-3, 3]);
});

test("pictures are rendered in the film's own shape", () => {
  for (const name of ["film", "half", "double", "320", "1920"]) {
    const [w, h] = sizeFor(name, [640, 480]);
    assert.equal(w / h, 4 / 3, name);
  }
  assert.deepEqual(sizeFor("320", [640, 480]), [320, 240]);
});

test("what is changed is known, and that all may be another", () => {
  const from = (text: string): ReturnType<typeof grownFrom> => grownFrom(new Preset(text));
  const was = from('{"seed": 1, "title": "a", "organisms": [{"kind": "rock"}, {"kind": "coral", "height": 1}]}');
  assert.deepEqual(changedOrganisms(was, from('{"seed": 1, "title": "b", "organisms": [{"kind": "rock"}, {"kind": "coral", "height": 2}]}')), [1]);
  assert.deepEqual(changedOrganisms(was, from('{"seed": 2, "organisms": [{"kind": "rock"}, {"kind": "coral", "height": 2}]}')), []);
  assert.deepEqual(changedOrganisms(was, from('{"seed": 1, "organisms": [{"kind": "rock"}]}')), []);
  assert.deepEqual(changedOrganisms(was, from('{"seed": 1, "defaults": {"size": 2}, "organisms": [{"kind": "rock"}, {"kind": "coral", "height": 1}]}')), [0, 1]);
  assert.deepEqual(changedOrganisms(null, was), []);
  const text = '{"organisms": [{"species": "a.json"}]}';
  const known = grownFrom(new Preset(text, {}, () => ({ size: 2 })));
  assert.deepEqual(changedOrganisms(grownFrom(new Preset(text)), known), [], "a species that has been read is no change");
});

test("what is missing from a picture stays as it was", () => {
  const part = (id: string, entry: number, specimen: number): Part => ({ id, kind: "mesh", entry, specimen }) as Part;
  const header = (parts: Part[], missing: number[], specimens: Header["specimens"]): Header =>
    ({ parts, missing, specimens, nodes: 1, camera: { at: [0, 0, parts.length] }, entries: [{ name: "a", specimens: 1 }, { name: "b", specimens: specimens.length - 1 }] }) as unknown as Header;
  const at = (entry: number): Header["specimens"][number] => ({ entry, foot: [entry, 0, 0], placed: 0, turn: [0, 0, 0, 1], size: 1 });
  const was = header([part("ground", -1, -1), part("a1", 0, 0), part("b1", 1, 1)], [], [at(0), at(1)]);
  const now = merged(was, header([part("ground", -1, -1), part("a2", 0, 0)], [1], [at(0)]));
  assert.deepEqual(now.parts.map((p) => [p.id, p.specimen]), [["ground", -1], ["a2", 0], ["b1", 1]]);
  assert.deepEqual(now.specimens.map((s) => s.entry), [0, 1]);
  assert.deepEqual(now.entries.map((e) => e.specimens), [1, 1]);
  assert.equal(now.camera, was.camera);
});

test("a storyboard goes from the first frame to the last", () => {
  assert.deepEqual(timesOver(1, 2), [0, 0.5, 1]);
  const times = timesOver(99 / 24, 24);
  assert.equal(times.length, 12);
  assert.deepEqual([times[0], times.at(-1)], [0, 99 / 24]);
  times.forEach((t) => assert.ok(Math.abs(t * 24 - Math.round(t * 24)) < 1e-9));
  assert.deepEqual(timesOver(0, 24), [0]);
});

test("a moment shows the nearest frame that is finished", () => {
  assert.equal(frameNear([1, 9, 17], 10 / 24, 24, 4), 9);
  assert.equal(frameNear([1, 17], 10 / 24, 24, 4), null);
  assert.equal(frameNear([], 0, 24, 4), null);
});

test("views that are no views yet keep their places", () => {
  const view = { name: "a", at: [0, 1, 2], to: [0, 0, 0] };
  assert.deepEqual(viewsOf({ scene: { views: [{ name: "b" }, { ...view, angle: 30 }, 3] } }), [null, view, null]);
  assert.deepEqual(viewsOf({ scene: { views: 3 } }), []);
});

/** A green disc of radius 8 on grey in 24 x 24, with one green pixel in a corner and one grey one in it. */
function disc(): Pixels {
  const data = new Uint8ClampedArray(4 * 24 * 24);
  for (let i = 0; i < 24 * 24; i++) {
    const [x, y] = [i % 24, Math.floor(i / 24)];
    const green = (Math.hypot(x - 12, y - 12) < 8 && i !== 12 * 24 + 12) || i === 0;
    data.set(green ? [40, 140, 30, 255] : [120, 120, 140, 255], 4 * i);
  }
  return { width: 24, height: 24, data };
}

test("a background is cut away by its colour, and specks and pinholes go", () => {
  const picture = disc();
  const all = new Uint8Array(24 * 24).fill(1);
  const cut = flooded(picture, all, [20, 20], 20, 0);
  assert.deepEqual([cut[0], cut[12 * 24 + 12], cut[1]], [1, 1, 0]);
  const holed = cut.slice();
  holed[12 * 24 + 12] = 0;
  const leaf = largestPiece(holed, 24, 24);
  assert.deepEqual([leaf[0], leaf[12 * 24 + 12], leaf[12 * 24 + 8]], [0, 1, 1]);
  assert.deepEqual(boundsOf(leaf, 24), { low: [5, 5], high: [19, 19] });
  assert.ok(flooded(picture, cut, [20, 20], 20, 1).every((kept) => kept === 1));
  assert.equal(flooded(picture, all, [20, 20], 255, 0).includes(1), false);
});

test("a leaf that lies aslant stands upright, its foot in the middle", () => {
  const mask = new Uint8Array(100 * 100);
  for (let k = 20; k <= 80; k++) mask[k * 100 + k] = 1;
  const { turn, scale, width, height, foot } = upright(mask, 100, [20, 80], [80, 20], 1024);
  assert.ok(Math.abs(turn - Math.PI / 4) < 1e-9);
  assert.equal(scale, 1);
  assert.ok(Math.abs(width / 2 - foot[0]) < 1e-9 && width > 84);
  assert.ok(height >= 16 && foot[1] > 0);
  assert.ok(upright(mask, 100, [20, 80], [80, 20], 40).width <= 41);
});

test("what is said to be grey is grey after it", () => {
  const picture = disc();
  const grey = colorAt(picture, [20, 20]);
  const data = balanced(picture.data, grey);
  const at = 4 * (20 * 24 + 20);
  assert.ok(Math.abs(data[at]! - data[at + 2]!) <= 1 && data[at]! > 120 && data[at]! < 140 && data[at + 3] === 255);
});

test("a new preset is saved as itself, one that is shipped as a copy", () => {
  assert.equal(suggested({ copy: true, disk: null, file: "/mine/untitled.json" }), "/mine/untitled.json");
  assert.equal(suggested({ copy: true, disk: "1f", file: "/frond/presets/reef.json" }), "reef_copy.json");
  assert.equal(suggested({ copy: false, disk: "1f", file: "/mine/reef.json" }), "/mine/reef.json");
});

test("edits that find no branch are told apart from those that do", () => {
  const preset = new Preset('{"organisms": [{"kind": "rock"}, {"kind": "tree", "edits": [{"at": "3", "cut": true}, {"at": "9:0.8", "bend": [0, 1, 0]}, {"at": "40", "cut": 7}]}]}');
  const notes = ["a.json:1:2: /organisms/1/edits/2/at: finds no branch: the stem has 14 branches", "a.json:1:2: /organisms/1/edits/1/at: finds no branch: the stem has 3 branches", "no water here"];
  assert.deepEqual(lostEdits({ preset }, notes).map(({ entry, index, what }) => [entry, index, what]), [[1, 2, "40, cut in year 7"], [1, 1, "9:0.8, bent"]]);
});

test("pictures at rest grow finer, and none takes much longer than one may wait", () => {
  // Machines of several speeds, triangles a ms, and scenes of several sizes.
  for (const speed of [5, 100, 5000]) {
    for (const scene of [1e4, 3e5, 1e8]) {
      const pace = new Pace(2e4, 1.5e6);
      const took: number[] = [];
      do took.push(Math.min(scene, pace.triangles) / speed);
      while (pace.finer(took.at(-1)!, Math.min(scene, pace.triangles), scene <= pace.triangles));
      for (const ms of took.slice(1)) assert.ok(ms <= LONGEST, `${speed} ${scene}: ${took.join()}`);
      assert.ok(pace.triangles >= 2e4 && (pace.triangles / speed <= LONGEST || pace.triangles === 2e4));
      if (scene / speed < LONGEST / 4) assert.ok(pace.triangles >= Math.min(scene, 1.5e6), "there was time for all");
    }
  }
});
