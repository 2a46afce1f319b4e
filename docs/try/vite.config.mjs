// One classic script and one style sheet: unlike modules, they work from the disk, too.
import fs from "node:fs";

const build = process.env.FROND_TRY_BUILD;
/** The corals that the engine grows, see engine/alone.cpp. */
const KINDS = ["coral", "massive", "columnar", "foliose", "table", "tube", "fan"];

/** Of the schema of presets what sliders of corals need to know. */
function coralSchema() {
  const { organisms } = JSON.parse(fs.readFileSync(new URL("../preset.schema.json", import.meta.url), "utf8")).properties;
  const rules = organisms.items.allOf.map((rule) => [rule.if.properties.kind.const, rule.then]).filter(([kind]) => KINDS.includes(kind));
  return Object.fromEntries(rules.map(([kind, { properties, leading }]) => {
    const own = Object.entries(properties).filter(([name, schema]) => schema !== true && name !== "grammar");
    return [kind, { properties: Object.fromEntries(own), leading }];
  }));
}

export default {
  publicDir: "public",
  resolve: { alias: { "frond-engine": `${build}/engine.js?raw` } },
  plugins: [{
    name: "coral-schema",
    resolveId: (name) => (name === "coral-schema" ? "\0coral-schema" : null),
    load: (name) => (name === "\0coral-schema" ? `export default ${JSON.stringify(coralSchema())}` : null),
  }],
  build: {
    outDir: `${build}/page`,
    emptyOutDir: true,
    target: "es2022",
    lib: { entry: "page/main.ts", formats: ["iife"], name: "frondTry", fileName: () => "page.js", cssFileName: "page" },
    chunkSizeWarningLimit: 3000,
  },
};
