// A word by the library lindenmayer of npm: node lindenmayer.mjs FOLDER OUT STEPS RULES, the rules as its productions in JSON.
import { createRequire } from "node:module";
import fs from "node:fs";

const [folder, out, steps, rules] = process.argv.slice(2);
const LSystem = createRequire(`${folder}/`)("lindenmayer");

const start = process.cpuUsage();
const word = new LSystem({ axiom: "A", productions: JSON.parse(rules) }).iterate(Number(steps));
fs.writeFileSync(out, `${word}\n`);
const { user, system } = process.cpuUsage(start);
console.log("measured", (user + system) / 1e6, word.length);
