/** Films: how the next is rendered, those there are, and the storyboard above them. */

import * as api from "../api";
import { el, sleep } from "../dom";
import type { Store } from "../store";
import type { View } from "../view/view";
import { ask, say } from "./dialogs";
import { filmPlayer, nameOf } from "./film_player";
import { sizeAndQuality } from "./size_quality";
import { storyboard } from "./storyboard";
import { viewsPanel } from "./views";

const SOON = 500; // ms between questions how far it is
const LATE = 5000; // the same, of a farm

export interface FilmPanel {
  element: HTMLElement;
  player: HTMLElement;
  opened(): void;
  closed(): void;
  close(): void;
}

const atWork = (film: api.FilmState): boolean => film.state === "waiting" || film.state === "rendering" || film.state === "farm";

/** How far it is, in words. */
export function progressOf(film: api.FilmState): string {
  const frames = `${film.done} of ${film.of} frames`;
  switch (film.state) {
    case "waiting":
      return "waits for another film";
    case "rendering":
      return film.phase === "rough" ? `a rough film first: ${film.said}` : `${frames}; ${film.said}`;
    case "farm":
      return `on the farm, ${frames}`;
    case "paused":
      return `paused, ${frames}`;
    case "failed":
      return `failed: ${film.message}`;
    case "done":
      return `done, ${film.of} frames`;
  }
}

export function filmPanel(store: Store, view: View): FilmPanel {
  const form = sizeAndQuality(store, "film");
  const box = (label: string, name: string): HTMLInputElement => el<HTMLInputElement>("input", { type: "number", min: "1", "aria-label": label, "data-testid": name });
  const [first, last] = [box("First frame", "film-first"), box("Last frame", "film-last")];
  const rough = el<HTMLInputElement>("input", { type: "checkbox", checked: true, "data-testid": "film-rough" });
  const farm = el<HTMLInputElement>("input", { type: "checkbox", "data-testid": "film-farm" });
  const begin = el("button.primary", { type: "button", "data-testid": "film-start", click: () => void start() }, "Render the film");
  const list = el("ul.films", { "aria-label": "Films", "data-testid": "films" });
  const board = storyboard(store);
  const player = filmPlayer();
  const element = el("div.film-panel", {}, board.element,
    el("div.renders-panel", {},
      el("div.render-form", {}, ...form.fields,
        el("div.frames-field", {}, el("span", {}, "Frames"), first, el("span", {}, "to"), last),
        el("label.check", {}, rough, el("span", {}, "A rough film first")),
        store.farm && el("label.check", {}, farm, el("span", {}, "On the farm")), begin),
      viewsPanel(store, view), list));
  let films: api.FilmState[] = [];
  let following = false;

  const range = (): string => {
    const frames = Math.round(store.preset.end * store.preset.fps) + 1;
    return first.value || last.value ? `${first.value || 1}-${last.value || frames}` : "";
  };
  async function start(): Promise<void> {
    form.keep();
    const order = { size: form.size(), quality: form.quality(), range: range(), rough: rough.checked, farm: farm.checked };
    await tried(async () => {
      const answer = await api.film(store.doc, order);
      if (Array.isArray(answer)) return say(answer[0]?.text ?? "This preset cannot be rendered", true);
      await reload();
      choose(answer.id);
    });
  }
  const tried = (act: () => Promise<unknown>): Promise<void> => act().then(() => undefined, (error: Error) => say(error.message, true));
  const choose = (id: string): void => {
    const film = films.find((f) => f.id === id);
    if (film) player.show(film);
    show();
  };
  async function reload(): Promise<void> {
    films = await api.films();
    show();
    void follow();
  }
  /** Asks how far they are, as long as one is at work. */
  async function follow(): Promise<void> {
    if (following) return;
    following = true;
    while (films.some(atWork)) {
      await sleep(films.some((f) => f.state === "waiting" || f.state === "rendering") ? SOON : LATE);
      const now = await api.films().catch(() => null);
      if (!now) {
        await sleep(LATE); // it may answer again
        continue;
      }
      films = now;
      show();
      const shown = films.find((f) => f.id === player.shown());
      if (shown) player.show(shown);
    }
    following = false;
  }
  async function remove(film: api.FilmState): Promise<void> {
    const answer = await ask("Remove this film?", `Its folder goes with all frames: ${film.folder}`, [{ value: "keep", label: "Keep it" }, { value: "remove", label: "Remove it", primary: true }], "remove-film");
    if (answer !== "remove") return;
    if (player.shown() === film.id) player.close();
    await tried(() => api.removeFilm(film.id).then(reload));
  }

  /** Rows stay as long as their films do, so that nothing that has the focus goes. */
  const rows = new Map<string, { element: HTMLElement; show(film: api.FilmState): void }>();
  function row(id: string): { element: HTMLElement; show(film: api.FilmState): void } {
    let film: api.FilmState;
    const name = el("button.film-name", { type: "button", "data-testid": `film:${id}`, click: () => choose(id) });
    const state = el("span.film-state", { "data-testid": `film-state:${id}` });
    const bar = el<HTMLProgressElement>("progress", { max: 1, value: 0, "aria-label": "Frames that are finished" });
    const button = (label: string, testid: string, act: () => Promise<unknown>): HTMLButtonElement => el<HTMLButtonElement>("button.small", { type: "button", "data-testid": `${testid}:${id}`, click: () => void tried(() => act().then(reload)) }, label);
    const pause = button("Pause", "pause-film", () => api.pauseFilm(id));
    const resume = button("Resume", "resume-film", () => api.resumeFilm(id));
    const save = el<HTMLAnchorElement>("a.button.small", { "data-testid": `save-film:${id}` }, "Save the file");
    const gone = el("button.small", { type: "button", "data-testid": `remove-film:${id}`, click: () => void remove(film) }, "Remove");
    const place = el("small", {});
    return {
      element: el("li.film", {}, name, bar, state, el("div.acts", {}, pause, resume, save, gone), place),
      show(now): void {
        film = now;
        name.textContent = nameOf(film);
        name.setAttribute("aria-pressed", String(player.shown() === id));
        state.textContent = progressOf(film);
        state.classList.toggle("wrong", film.state === "failed");
        bar.value = film.of ? film.done / film.of : 0;
        pause.hidden = !atWork(film);
        resume.hidden = film.state !== "paused" && film.state !== "failed";
        save.hidden = !film.film;
        save.href = api.filmFile(id, film.film);
        save.download = film.film.replace(/^film/, id);
        place.textContent = film.folder;
      },
    };
  }
  function show(): void {
    for (const film of films) {
      if (!rows.has(film.id)) rows.set(film.id, row(film.id));
      rows.get(film.id)!.show(film);
    }
    for (const id of [...rows.keys()]) if (!films.some((f) => f.id === id)) rows.delete(id);
    const wanted = films.map((f) => rows.get(f.id)!.element);
    if (!wanted.length) list.replaceChildren(el("li.hint", {}, "Films are kept in out/films beside the preset; one that is paused can be resumed later."));
    else if (wanted.some((e, i) => list.children[i] !== e) || list.children.length !== wanted.length) list.replaceChildren(...wanted);
    board.showFrames(films.find((f) => f.id === player.shown()) ?? films.find(atWork) ?? null);
  }
  return {
    element,
    player: player.element,
    opened(): void {
      board.show(true);
      void reload().catch(() => undefined);
    },
    closed: () => board.show(false),
    close: player.close,
  };
}
