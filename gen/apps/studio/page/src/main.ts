/**
 * The studio's page.
 *
 * Marks (data-testid) that tests in a browser may rely on:
 *   top bar      to-gallery file unsaved undo redo save save-as-button export seed variations render help theme side more-acts
 *   outline      part:preset part:scene part:all organisms organism:N solo:N hide:N more:N add-organism
 *   properties   search group:PATH row:PATH (of organisms row:organism/PATH) scope:PATH animate:PATH seed-dice open-grammar species make-own
 *   help         help keys doc:NAME
 *   tools        tool:NAME draw-what draw-width draw-pull draw-finish placed place-snap place-brush place:NAME branch branch-address cut-year
 *                branch:NAME painted paint-what brush-size brush-value brush-strength brush-erase paint:NAME measured
 *   view         views two-views second-view second-views second:SIDE keep-a keep-wipe back-to-a
 *                view scene-status refining look-through set-camera view:NAME growing stop-growing grow-on estimate time play time-key:SECONDS
 *   drawer       tab:problems tab:grammar tab:text tab:library tab:film tab:renders; problems text
 *   library      library library:organisms library:materials library-search library:NAME swatch on-plant
 *   grammar      grammar-panel axiom rules:rules rules:interpretation rules:decomposition derive-steps derive-figures word
 *                turtle-svg derivation-tree
 *   film         film-size film-quality film-first film-last film-rough film-farm film-start storyboard moment:N films film:ID
 *                film-state:ID pause-film:ID resume-film:ID save-film:ID remove-film:ID film-player film-video film-watch close-film add-view
 *                key-view go-view:N view-name:N remove-view:N
 *   renders      render-size render-quality render-start compare renders render-picture render-state cancel-render go-back
 *                wipe close-picture
 *   variations   wall wall-grid variation:VALUE
 *   gallery      gallery gallery-search new-preset card:NAME own:NAME
 *   species      choose-species species:NAME
 *   dialogs      add add:KIND add-from add-which save-as save-name save-wrong save-conflict long leave left answer:VALUE
 *   elsewhere    banner changed
 * `window.frond` has what the view gives (`mask()`, a picture of the organisms alone; `settled()`), `shown()`, which resolves
 * when the view shows what the text says, and `took()`, the seconds from the last request to its picture on the screen.
 */

import "./styles/base.css";
import "./styles/layout.css";
import "./styles/controls.css";
import "./styles/editors.css";
import "./styles/panels.css";
import "./styles/pictures.css";
import "./styles/gallery.css";
import "./styles/film.css";
import "./styles/phone.css";
import * as api from "./api";
import { anySeed } from "./controls/number";
import { Section } from "./controls/group";
import { el } from "./dom";
import { nameTab } from "./drafts";
import { addOrganism, takeDrops } from "./panels/add_organism";
import { ask, say } from "./panels/dialogs";
import { curvesPanel } from "./panels/curves";
import { drawer } from "./panels/drawer";
import { exportMenu } from "./panels/exports";
import { filmPanel } from "./panels/film";
import { gallery } from "./panels/gallery";
import { grammarPanel } from "./panels/grammar_panel";
import { showHelp } from "./panels/help";
import { inspector } from "./panels/inspector";
import { offerLeft } from "./panels/left";
import { library } from "./panels/library";
import { linkBanner } from "./panels/link";
import { outliner } from "./panels/outliner";
import { picturePane } from "./panels/picture";
import { problems, selectPointer } from "./panels/problems";
import { renders } from "./panels/renders";
import { save, saveAs } from "./panels/saving";
import { swatch } from "./panels/swatch";
import { stage } from "./panels/stage";
import { textPanel } from "./panels/text_panel";
import { toggleTheme } from "./panels/theme";
import { timeBar } from "./panels/time_bar";
import { mountTips } from "./panels/tips";
import { topBar } from "./panels/top_bar";
import { wall } from "./panels/wall";
import { watchFile } from "./panels/watch";
import { listenToKeys } from "./shortcuts";
import { Store } from "./store";

/** Windows of so few pixels have no room for view and properties side by side (layout.css says the same). */
const NARROW = 640;

const store = new Store();
let refused = false;
api.takeToken();
// A page that was not let in begins anew; one in which somebody works goes on as it is.
api.onNewToken(() => refused || store.link !== "up", () => refused && location.reload());
void begin();

async function begin(): Promise<void> {
  mountTips();
  try {
    const [start] = await Promise.all([api.start(), nameTab().catch(() => undefined)]);
    api.tellToken();
    store.begin(start);
    document.getElementById("starting")?.remove();
    build();
    if (store.restore()) return;
    if (start.preset) store.open(start.preset);
    await offerLeft(store).catch(() => undefined);
  } catch (error) {
    refused = error instanceof api.ApiError && error.status === 403;
    const said = refused ? "Open the address that frond studio printed: it holds the key to this page." : (error as Error).message;
    document.getElementById("starting")?.remove();
    document.body.append(el("main.refused", {}, el("h1", {}, "Frond"), el("p", { role: "alert", "data-testid": "banner" }, said)));
    if (!refused) setTimeout(() => location.reload(), 2000);
  }
}

function build(): void {
  const scene = stage(store);
  const time = timeBar(store, scene.loop);
  const variations = wall(store);
  const made = renders(store, () => pane);
  const pane = picturePane({ goBack: (id) => void made.goBack(id), cancel: made.cancel });
  const shelf = library(store, scene.view, scene.element);
  const film = filmPanel(store, scene.view);
  const text = textPanel(store);
  const grammar = grammarPanel(store);
  const faults = problems(store, {
    goToLine(line, column) {
      below.open("text");
      text.goTo(line, column);
    },
    showControl,
  });
  const curves = curvesPanel(store);
  const below = drawer(
    [
      { name: "problems", label: "Problems", element: faults.element },
      { name: "grammar", label: "Grammar", element: grammar.element, opened: grammar.opened, closed: grammar.closed },
      { name: "text", label: "Text", element: text.element, opened: text.opened, closed: text.closed },
      { name: "curves", label: "Curves", element: curves.element, opened: curves.opened, closed: curves.closed },
      { name: "library", label: "Library", element: shelf.element, opened: shelf.opened, closed: shelf.closed },
      { name: "film", label: "Film", element: film.element, opened: film.opened, closed: film.closed },
      { name: "renders", label: "Renders", element: made.element, opened: () => void made.reload().catch(() => undefined) },
    ],
    () => innerWidth <= NARROW && workshop.classList.add("no-side"), // one sheet at a time
  );
  const properties = inspector(store, {
    vary: variations.vary,
    showInText(path) {
      below.open("text");
      text.goToPath(path);
    },
    openGrammar: () => below.open("grammar"),
  });
  const begin = gallery(store);
  const side = el("aside.side", { "aria-label": "Preset" }, outliner(store, () => void addOrganism(store)), swatch(store, scene.view), properties);
  const center = el("div.center", {}, el("div.pictures-row", {}, scene.element, scene.beside, pane.element, film.player, variations.element), time.element, below.element);
  const workshop = el("div.workshop", { hidden: true }, center, side);
  // A small window shows the view first.
  workshop.classList.toggle("no-side", innerWidth <= NARROW);
  const toggleSide = (): void => {
    const hidden = workshop.classList.toggle("no-side");
    if (!hidden && innerWidth <= NARROW && below.current()) below.close();
  };
  const bar = topBar(store, {
    gallery: () => void leave(),
    save: () => void save(store),
    saveAs: () => void saveAs(store),
    wall: variations.seeds,
    render: () => {
      below.open("renders");
      void made.start();
    },
    exports: (from) => exportMenu(store, scene.view, from),
    seed: () => store.set(["seed"], anySeed()),
    side: toggleSide,
    theme: toggleTheme,
    help: () => void showHelp(),
  });
  const banner = linkBanner(store, () => {
    scene.loop.want();
    void made.reload().catch(() => undefined);
  });
  document.body.append(bar, el("main", {}, banner, watchFile(store), begin.element, workshop));

  const showOpen = (): void => {
    workshop.hidden = !store.isOpen;
    begin.element.hidden = store.isOpen;
    if (!store.isOpen) begin.show();
    // What had the focus is out of sight.
    if (document.activeElement === document.body || begin.element.contains(document.activeElement)) (store.isOpen ? scene.view : begin).focus();
    pane.close();
    film.close();
    variations.close();
  };
  store.on("opened", showOpen);
  store.on(["text", "scene"], () => below.badge("problems", faults.count() ? String(faults.count()) : store.scene.notes.length ? String(store.scene.notes.length) : "", faults.count() > 0));
  showOpen();

  /** Selects what a pointer names, opens the groups on the way, and puts the focus there. */
  function showControl(pointer: string): void {
    const groups = selectPointer(store, pointer);
    const kind = typeof store.selected === "number" ? store.preset.kindOf(store.selected) : store.selected;
    for (const group of groups) Section.openGroup(kind, group);
    workshop.classList.remove("no-side");
    // Built anew, with those groups open.
    store.emit("opened-groups");
    const names = [...groups].reverse().map((g) => `[data-testid="row:${typeof store.selected === "number" ? "organism/" : ""}${g}"] .control :is(input, select, button)`);
    const found = names.map((n) => properties.querySelector<HTMLElement>(n)).find(Boolean);
    found?.scrollIntoView({ block: "center" });
    found?.focus();
  }

  takeDrops(store, (x, y) => scene.view.groundAt(x, y));
  listenToKeys({
    undo: () => store.undo(),
    redo: () => store.redo(),
    save: () => void save(store),
    saveAs: () => store.isOpen && void saveAs(store),
    play: time.toggle,
    camera: scene.toggleCamera,
    ...scene.looks,
    tool: (name) => store.isOpen && scene.tools.choose(name),
    help: () => void showHelp(),
    search: () => document.querySelector<HTMLElement>(store.isOpen ? "[data-testid=search]" : "[data-testid=gallery-search]")?.focus(),
  });
  addEventListener("pagehide", () => store.keepDraft());
  addEventListener("beforeunload", (event) => store.unsaved && event.preventDefault());
  const { frond } = window as { frond?: object };
  Object.assign(window, { frond: { ...frond, view: scene.view, shown: () => scene.loop.settled(), took: () => store.scene.took } });
}

/** To the gallery; what is unsaved is asked for first. */
async function leave(): Promise<void> {
  if (!store.isOpen) return;
  if (store.unsaved) {
    const answer = await ask("Leave this preset?", "What you changed is not saved.", [{ value: "stay", label: "Stay" }, { value: "leave", label: "Leave without saving" }, { value: "save", label: "Save", primary: true }], "leave");
    if (answer === "save") await save(store);
    if (answer !== "leave" && store.unsaved) return;
  }
  store.close();
  say("Choose another preset.");
}
