/** The pane beside the view: a picture that POV-Ray makes or made, or two of them with a slider that wipes. */

import * as api from "../api";
import { el, iconButton, spoken } from "../dom";

export interface PicturePane {
  element: HTMLElement;
  show(render: api.PastRender, state: api.RenderState | null): void;
  compare(a: api.PastRender, b: api.PastRender): void;
  close(): void;
  /** The render it shows, if it is one alone. */
  shown(): string | null;
}

export const describe = (r: api.PastRender): string => `${r.time.toFixed(2)} s, seed ${r.seed}, ${r.size.join("×")}, ${r.quality}`;

export function picturePane(acts: { goBack(id: string): void; cancel(id: string): void }): PicturePane {
  const title = el("h2");
  const image = el<HTMLImageElement>("img", { hidden: true, "data-testid": "render-picture" });
  const second = el<HTMLImageElement>("img.second", { hidden: true });
  const wipe = el<HTMLInputElement>("input.wipe", { type: "range", min: "0", max: "100", value: "50", "aria-label": "Where one picture ends and the other begins", hidden: true, "data-testid": "wipe" });
  const bar = el<HTMLProgressElement>("progress", { max: 1, value: 0, "aria-label": "Progress of the picture" });
  const state = el("p.state", { role: "status", "data-testid": "render-state" });
  const back = el("button.small", { type: "button", "data-testid": "go-back", click: () => current && acts.goBack(current.id) }, "Go back to its preset");
  const stop = el("button.small", { type: "button", "data-testid": "cancel-render", click: () => current && acts.cancel(current.id) }, "Stop");
  const frame = el("div.frame", {}, image, second, wipe);
  const element = el("section.picture-pane", { "aria-label": "Rendered picture", hidden: true },
    el("div.pane-head", {}, title, back, stop, iconButton("close", "Close the picture", () => close(), { "data-testid": "close-picture" })), frame, bar, state);
  let current: api.PastRender | null = null;
  let loaded = "";

  const open = (): void => {
    if (!element.hidden) return;
    element.hidden = false;
  };
  const close = (): void => {
    element.hidden = true;
    current = null;
  };
  const load = (render: api.PastRender, version: string): void => {
    if (loaded === `${render.id} ${version}`) return;
    loaded = `${render.id} ${version}`;
    image.src = `${api.renderPicture(render.id)}&v=${encodeURIComponent(version)}`;
    image.alt = `${render.title || "The preset"}: ${describe(render)}`;
    image.hidden = false;
  };
  const setWipe = (): void => second.style.setProperty("--wipe", `${wipe.value}%`);
  wipe.addEventListener("input", setWipe);

  return {
    element,
    close,
    shown: () => (element.hidden ? null : (current?.id ?? null)),
    show(render, now): void {
      open();
      if (current?.id !== render.id) image.hidden = true;
      current = render;
      second.hidden = wipe.hidden = true;
      title.textContent = describe(render);
      const running = now?.state === "growing" || now?.state === "rendering";
      bar.hidden = stop.hidden = !running;
      back.hidden = running;
      bar.value = now?.progress ?? 1;
      if (render.state === "done") load(render, "whole");
      else if (now?.preview) load(render, `preview ${Math.floor((now.progress ?? 0) * 100)}`);
      state.textContent = stateText(render, now);
      state.classList.toggle("wrong", render.state === "failed");
    },
    compare(a, b): void {
      open();
      current = null;
      load(a, "whole");
      second.src = api.renderPicture(b.id);
      second.alt = `${b.title || "The preset"}: ${describe(b)}`;
      second.hidden = wipe.hidden = false;
      setWipe();
      bar.hidden = stop.hidden = back.hidden = true;
      title.textContent = "Two pictures";
      state.classList.remove("wrong");
      state.textContent = `Left: ${describe(a)}. Right: ${describe(b)}.`;
    },
  };
}

function stateText(render: api.PastRender, now: api.RenderState | null): string {
  if (!now) return render.state === "done" ? `Rendered in ${spoken(render.seconds)}.` : render.state;
  if (now.state === "growing") return `Growing … ${spoken(now.seconds)}`;
  if (now.state === "rendering") return `${Math.round(100 * now.progress)} %, ${spoken(now.seconds)}${now.left === null ? "" : `, about ${spoken(now.left)} left`}`;
  if (now.state === "done") return `Rendered in ${spoken(now.seconds)}.`;
  return now.message || now.state;
}
