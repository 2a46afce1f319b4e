/** Time: a slider over the film, and play. */

import { el, icon } from "../dom";
import type { SceneLoop } from "../scene_loop";
import type { Store } from "../store";
import { timeKeys } from "./time_keys";

export function timeBar(store: Store, loop: SceneLoop): { element: HTMLElement; toggle(): void } {
  const play = el<HTMLButtonElement>("button.icon-button", { type: "button", "data-testid": "play", click: () => toggle() });
  const slider = el<HTMLInputElement>("input.slider.time", { type: "range", min: "0", step: "any", "aria-label": "Time of the film", "data-testid": "time" });
  const clock = el("output.clock", {});
  const element = el("section.time-bar", { "aria-label": "Time" }, play, el("div.track", {}, slider, timeKeys(store)), clock);
  let playing = false;

  const film = (): { seconds: number; fps: number } => ({ fps: store.preset.fps, seconds: store.preset.end });
  const refresh = (): void => {
    const { seconds } = film();
    const still = seconds === 0;
    slider.max = String(still ? 1 : seconds);
    slider.value = String(store.time);
    slider.disabled = play.disabled = still;
    slider.style.setProperty("--fill", still ? "0%" : `${(100 * store.time) / seconds}%`);
    slider.setAttribute("aria-valuetext", `${store.time.toFixed(2)} of ${seconds.toFixed(2)} seconds`);
    clock.textContent = still ? "a still" : `${store.time.toFixed(2)} / ${seconds.toFixed(2)} s`;
    const name = playing ? "Pause" : "Play";
    play.setAttribute("aria-label", name);
    play.dataset.tip = `${name} (space)`;
    play.replaceChildren(icon(playing ? "pause" : "play"));
  };
  /** As fast as the clock, or as fast as the model can be shown. */
  async function run(): Promise<void> {
    let last = performance.now();
    while (playing && store.isOpen) {
      await new Promise(requestAnimationFrame);
      const now = performance.now();
      const { seconds } = film();
      store.setTime(seconds > 0 ? (store.time + (now - last) / 1000) % seconds : 0);
      last = now;
      await loop.settled();
    }
  }
  function toggle(): void {
    if (play.disabled) return;
    playing = !playing;
    refresh();
    if (playing) void run();
  }

  slider.addEventListener("input", () => store.setTime(Number(slider.value)));
  slider.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const { fps, seconds } = film();
    store.setTime(Math.min(seconds, Math.max(0, store.time + (step * (event.shiftKey ? 10 : 1)) / fps)));
  });
  store.on(["time", "scene", "opened", "text"], refresh);
  store.on("opened", () => {
    playing = false;
    refresh();
  });
  refresh();
  return { element, toggle };
}
