/** The dialog that makes a leaf or bark of somebody's photograph. */

import * as api from "../api";
import type { Binding } from "../controls/binding";
import { el } from "../dom";
import { removeAt } from "../edits";
import { dialog } from "../panels/dialogs";
import { Photograph, type Balance, type Half } from "./photograph";

type Tool = "cut" | "back" | "foot" | "tip" | "grey" | "from" | "to";
const TOOLS: { leaf: [Tool, string, string][]; bark: [Tool, string, string][] } = {
  leaf: [
    ["cut", "Cut away", "Cuts away what has about the colour there, as far as it is connected"],
    ["back", "Put back", "Puts back what was cut away there"],
    ["foot", "Foot", "Where the stalk ends; it comes to the bottom"],
    ["tip", "Tip", "Where the leaf ends; it comes to the top"],
    ["grey", "Grey", "Something that is grey or white, from which the colours are balanced"],
  ],
  bark: [
    ["from", "First corner", "One corner of the piece of bark"],
    ["to", "Second corner", "The opposite corner"],
    ["grey", "Grey", "Something that is grey or white, from which the colours are balanced"],
  ],
};

/** Opens it for a property that names a PNG file, which it writes and sets. */
export async function usePhotograph(binding: Binding): Promise<void> {
  const what = binding.rel.includes("coat") ? "bark" : "leaf";
  const panel = new Panel(what);
  await dialog(what === "leaf" ? "A leaf from a photograph" : "Bark from a photograph", (close) => {
    const use = async (): Promise<void> => {
      try {
        await write(binding, what, await panel.photo!.png(), panel.ownColors.checked);
        close("use");
      } catch (error) {
        panel.say((error as Error).message);
      }
    };
    panel.use.addEventListener("click", () => void use());
    return [panel.element, el("div.answers", {}, el("button", { type: "button", "data-testid": "answer:cancel", click: () => close(null) }, "Cancel"), panel.use)];
  }, "photograph");
}

async function write(binding: Binding, what: string, png: Blob, ownColors: boolean): Promise<void> {
  const { store, entry, path } = binding;
  const name = store.nameOfWritten(await api.painted(`${entry === null ? "all" : store.preset.nameOf(entry)}-${what}.png`, png, store.file));
  const colors = [...path.slice(0, -1), "colors"];
  store.batch((text) => {
    const set = store.edited(text, path, name);
    return what === "leaf" && ownColors ? removeAt(set, colors) : set;
  });
}

class Panel {
  photo: Photograph | null = null;
  readonly element: HTMLElement;
  readonly use = el<HTMLButtonElement>("button.primary", { type: "button", disabled: true, "data-testid": "answer:use" }, "Use it");
  readonly ownColors = el<HTMLInputElement>("input", { type: "checkbox", checked: true, "data-testid": "photo-colors" });
  private tool: Tool;
  private cross: [number, number] = [0, 0];
  private canvas = el<HTMLCanvasElement>("canvas.photograph", { tabIndex: 0, "aria-label": "The photograph: arrow keys move the cross, Enter does what a click does", "data-testid": "photo" });
  private result = el<HTMLCanvasElement>("canvas.checkered", { "aria-label": "What the preset gets", role: "img", "data-testid": "photo-result" });
  private told = el("p.hint", { role: "status", "data-testid": "photo-said" }, "Choose a photograph, or drop one here.");
  private file = el<HTMLInputElement>("input", { type: "file", accept: "image/png,image/jpeg", "aria-label": "Photograph", "data-testid": "photo-file", change: () => void this.open(this.file.files?.[0]) });
  private x = this.coordinate("x", 0);
  private y = this.coordinate("y", 1);
  private tolerance = el<HTMLInputElement>("input.slider", { type: "range", min: "1", max: "150", value: "40", "data-testid": "photo-tolerance" });
  private half = this.choice("photo-half", [["both", "Both halves as they are"], ["left", "The left half twice"], ["right", "The right half twice"]], (value) => (this.photo!.half = value as Half));
  private balance = this.choice("photo-balance", [["none", "Colours as they are"], ["background", "What was cut away is grey"], ["point", "Grey where I click"]], (value) => (this.photo!.balance = value as Balance));
  private tools: HTMLButtonElement[];

  constructor(private what: "leaf" | "bark") {
    const tools = TOOLS[what];
    this.tool = tools[0]![0];
    this.tools = tools.map(([name, label, tip]) =>
      el<HTMLButtonElement>("button.small", { type: "button", "aria-pressed": String(name === this.tool), "data-tip": tip, "data-testid": `photo:${name}`, click: () => this.choose(name) }, label));
    if (what === "bark") this.balance.options[1]!.remove();
    const leaf = what === "leaf";
    this.element = el(
      "div.photographs", { dragover: stop, drop: (event: DragEvent) => (stop(event), void this.open(event.dataTransfer?.files[0])) },
      this.file, this.told,
      el("div.cluster", { role: "group", "aria-label": "What a click does" }, ...this.tools, el("button.small", { type: "button", "data-testid": "photo-undo", click: () => this.undo() }, "Undo")),
      el("div.pair", {}, this.canvas, this.result),
      el("div.cluster", {}, el("label", {}, "x ", this.x), el("label", {}, "y ", this.y), el("button.small", { type: "button", "data-testid": "photo-act", click: () => this.act() }, "Do it there"),
        leaf && el("label", {}, "Tolerance ", this.tolerance)),
      el("div.cluster", {}, leaf && this.half, this.balance, leaf && el("label", {}, this.ownColors, " Its own colours instead of those of the preset")),
    );
    this.canvas.addEventListener("click", (event) => {
      const box = this.canvas.getBoundingClientRect();
      this.cross = [((event.clientX - box.x) / box.width) * this.canvas.width, ((event.clientY - box.y) / box.height) * this.canvas.height].map(Math.floor) as [number, number];
      this.act();
    });
    this.canvas.addEventListener("keydown", (event) => this.key(event));
  }

  say(text: string): void {
    this.told.textContent = text;
  }

  private coordinate(label: string, axis: 0 | 1): HTMLInputElement {
    return el<HTMLInputElement>("input.text.short", { type: "number", min: "0", value: "0", "aria-label": `Column or row of the cross, ${label}`, "data-testid": `photo-${label}`, input: (event: Event) => {
      this.cross[axis] = Math.max(0, Math.round(Number((event.target as HTMLInputElement).value) || 0));
      this.show();
    } });
  }

  private choice(testid: string, options: [string, string][], set: (value: string) => void): HTMLSelectElement {
    const select = el<HTMLSelectElement>("select", { "aria-label": testid === "photo-half" ? "Halves" : "Balance of colours", "data-testid": testid, change: () => {
      if (!this.photo) return;
      set(select.value);
      this.show();
    } }, ...options.map(([value, text]) => el("option", { value }, text)));
    return select;
  }

  private choose(tool: Tool): void {
    this.tool = tool;
    this.tools.forEach((b) => b.setAttribute("aria-pressed", String(b.dataset.testid === `photo:${tool}`)));
    this.say(TOOLS[this.what].find(([name]) => name === tool)![2] + ".");
  }

  private async open(file: File | undefined): Promise<void> {
    if (!file) return;
    try {
      this.photo = new Photograph(await createImageBitmap(file), this.what);
    } catch {
      return this.say(`${file.name} is no picture that can be read; choose a JPG or PNG.`);
    }
    this.half.value = "both";
    this.balance.value = "none";
    [this.canvas.width, this.canvas.height] = [this.photo.width, this.photo.height];
    this.cross = [this.photo.width >> 1, this.photo.height >> 1];
    this.say(this.what === "leaf" ? "Click on the background until only the leaf is left." : "Click two corners of a piece of bark.");
    this.show();
    this.canvas.focus();
  }

  private act(): void {
    const { photo, tool } = this;
    if (!photo) return;
    const at = photo.inside(this.cross);
    if (tool === "cut" || tool === "back") photo.flood(at, Number(this.tolerance.value), tool === "back");
    else photo.put(tool, at);
    if (tool === "grey") this.balance.value = "point";
    this.show();
  }

  private undo(): void {
    this.photo?.undo();
    if (this.photo) this.balance.value = this.photo.balance;
    this.show();
  }

  private key(event: KeyboardEvent): void {
    const step = event.shiftKey ? 10 : 1;
    const by = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step] }[event.key];
    if (by) {
      this.cross = [this.cross[0] + by[0]!, this.cross[1] + by[1]!];
      this.show(false);
    } else if (event.key === "Enter") this.act();
    else if (event.key === "z" && (event.ctrlKey || event.metaKey)) this.undo();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private show(anew = true): void {
    const { photo } = this;
    if (!photo) return;
    this.cross = photo.inside(this.cross);
    [this.x.value, this.y.value] = this.cross.map(String) as [string, string];
    photo.draw(this.canvas, this.cross);
    if (!anew) return;
    this.use.disabled = !photo.result(this.result);
    if (this.use.disabled) this.say("Nothing of it is left.");
  }
}

const stop = (event: Event): void => {
  event.preventDefault();
  event.stopPropagation();
};
