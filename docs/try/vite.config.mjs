// One classic script and one style sheet: unlike modules, they work from the disk, too.
const build = process.env.FROND_TRY_BUILD;

export default {
  publicDir: "public",
  resolve: { alias: { "frond-engine": `${build}/engine.js?raw` } },
  build: {
    outDir: `${build}/page`,
    emptyOutDir: true,
    target: "es2022",
    lib: { entry: "page/main.ts", formats: ["iife"], name: "frondTry", fileName: () => "page.js", cssFileName: "page" },
    chunkSizeWarningLimit: 2000,
  },
};
