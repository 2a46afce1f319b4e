// An oak by ez-tree of npm as an OBJ: node ez_tree.mjs FOLDER OUT.obj FACTOR, by which each stem has more children than in the preset.
import { pathToFileURL } from "node:url";
import fs from "node:fs";

const [folder, out, factor] = process.argv.slice(2);
const module = (path) => import(pathToFileURL(`${folder}/node_modules/${path}`));
// It loads its pictures as it is imported, which needs a page; a mesh needs none.
globalThis.document = { createElementNS: () => ({ addEventListener() {}, removeEventListener() {} }) };
const { Tree } = await module("@dgreenheck/ez-tree/build/ez-tree.es.js");
const { OBJExporter } = await module("three/examples/jsm/exporters/OBJExporter.js");

const start = process.cpuUsage();
const preset = JSON.parse(fs.readFileSync(`${folder}/node_modules/@dgreenheck/ez-tree/src/lib/presets/oak_medium.json`));
for (const level in preset.branch.children) preset.branch.children[level] = Math.round(preset.branch.children[level] * Number(factor));
const tree = new Tree();
tree.options.copy(preset);
tree.generate();
fs.writeFileSync(out, new OBJExporter().parse(tree));
const { user, system } = process.cpuUsage(start);
console.log("measured", (user + system) / 1e6, tree.leaves.indices.length / 12); // two crossed quads a leaf
