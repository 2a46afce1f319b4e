import { defineConfig } from "vite";

// The frond binary holds what is built: few files, names that change with what is in them.
// `npm run dev` serves the page from the sources; FROND_STUDIO then names a running `frond studio`.
const studio = process.env.FROND_STUDIO ?? "http://127.0.0.1:8740";

export default defineConfig({
  base: "./",
  build: {
    outDir: "dist",
    emptyOutDir: true,
    sourcemap: false,
    target: "es2022",
    modulePreload: { polyfill: false },
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 1200,
  },
  server: { proxy: { "/api": { target: studio, changeOrigin: true, headers: { Origin: studio } } } },
});
