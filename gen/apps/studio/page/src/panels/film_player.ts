/** The pane beside the view in which a film plays, and shows the frame in work while it is rendered. */

import * as api from "../api";
import { el, iconButton } from "../dom";

export interface FilmPlayer {
  element: HTMLElement;
  show(film: api.FilmState): void;
  close(): void;
  /** The film it shows. */
  shown(): string | null;
}

export function filmPlayer(): FilmPlayer {
  const title = el("h2");
  const video = el<HTMLVideoElement>("video", { controls: true, loop: true, muted: true, playsInline: true, "data-testid": "film-video" });
  const watch = el<HTMLImageElement>("img", { alt: "The frame in work, as far as it is traced", "data-testid": "film-watch" });
  const work = el("figure", { hidden: true }, watch, el("figcaption", {}, "The frame in work"));
  const said = el("p.state");
  const element = el("section.film-player", { "aria-label": "Film", hidden: true, "data-testid": "film-player" },
    el("div.pane-head", {}, title, iconButton("close", "Close the film", () => close(), { "data-testid": "close-film" })),
    el("div.screens", {}, video, work), said);
  let current: string | null = null;
  let playing = "";
  let version = 0;

  const close = (): void => {
    element.hidden = true;
    current = null;
    playing = "";
    video.removeAttribute("src");
    video.load();
  };
  return {
    element,
    close,
    shown: () => current,
    show(film): void {
      element.hidden = false;
      current = film.id;
      title.textContent = nameOf(film);
      const file = film.plays;
      const whole = file !== "" && file === film.film.replace(/mov$/, "webm");
      video.hidden = !file;
      video.classList.toggle("clear", film.transparent === true);
      if (file && playing !== `${film.id} ${file}`) {
        playing = `${film.id} ${file}`;
        video.src = api.filmFile(film.id, file);
        video.setAttribute("aria-label", whole ? "The film" : "A rough film of a few frames");
        void video.play().catch(() => undefined);  // where it may not begin by itself its button does
      }
      work.hidden = !film.watch;
      // A picture that is being written anew shows itself once it has come, so that nothing flickers.
      if (film.watch) watch.src = `${api.filmFile(film.id, "watch.png")}&v=${++version}`;
      said.textContent = whole ? "" : film.film ? `${film.film} is finished, but browsers cannot play it: save the file, or look at its frames in the storyboard.` : file ? "A rough film of a few frames, until the whole one is there." : "Nothing of it is there to play yet.";
    },
  };
}

export const nameOf = (film: api.FilmState): string => `${film.title || film.id}, ${film.order.size.join("×")}, ${film.order.quality}`;
