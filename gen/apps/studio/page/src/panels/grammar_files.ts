/** A grammar that stands in files of its own: its texts, which are edited with the picture following. */

import * as api from "../api";
import { codeArea, type CodeArea } from "../controls/code_area";
import { el, quiet } from "../dom";
import type { Path } from "../pointer";
import type { Store } from "../store";

/** So long nothing is typed before a file is written, ms. */
const CALM = 900;

export interface GrammarFilesPane {
  element: HTMLElement;
  /** Shows the files of a grammar, which the preset names at `path`; answers what comes of it after so many steps. */
  show(file: string, path: Path, steps: number | null): Promise<api.GrammarFiles>;
}

export function grammarFiles(store: Store): GrammarFilesPane {
  const hint = el("p.hint", {}, "These rules stand in files of their own. What is changed is written to new files beside the preset, so that undo brings the former back; those that the preset does not name go when it is saved.");
  const host = el("div.grammar-files");
  const said = el("pre.fault", { role: "status", "data-testid": "grammar-fault" });
  const others = el("p.hint");
  const element = el("div", { "data-testid": "grammar-files" }, hint, host, said, others);
  const areas = new Map<string, CodeArea>();
  /** Texts that are typed and not written yet. */
  const typed = new Map<string, string>();
  let shown = "";
  let at: Path = [];
  let writing: Promise<void> | null = null;

  const write = quiet(CALM, () => void (writing ??= writeAll().finally(() => (writing = null))));

  /** One file after the other, as each makes another grammar. */
  async function writeAll(): Promise<void> {
    for (let next = typed.entries().next(); !next.done; next = typed.entries().next()) {
      const [name, text] = next.value;
      const [file, path] = [shown, at];
      try {
        const answer = await api.changeGrammar(file, name, text, store.file);
        if (file !== shown) return;
        if (typed.get(name) !== text) continue; // more was typed meanwhile
        typed.delete(name);
        if (Array.isArray(answer)) return mark(answer);
        mark([]);
        shown = answer.path;
        store.set(path, store.nameOfWritten(answer));
      } catch (error) {
        said.textContent = (error as Error).message;
        return;
      }
    }
  }

  function mark(faults: readonly api.Fault[]): void {
    for (const [name, area] of areas) area.mark(new Map(faults.filter((f) => f.where.startsWith(name) && f.line).map((f) => [f.line, f.text])));
    said.textContent = faults.map((f) => [f.where, f.text].filter(Boolean).join(": ")).join("\n");
  }

  function lay(files: api.GrammarFiles["files"]): void {
    const names = files.filter((f) => f.text !== null).map((f) => f.name);
    if (names.join() !== [...areas.keys()].join()) {
      areas.clear();
      host.replaceChildren(...names.map((name, i) => {
        const area = codeArea(name, (text) => {
          typed.set(name, text);
          write();
        }, { "data-testid": `grammar-file:${name}` });
        areas.set(name, area);
        const group = el("details.rules", {}, el("summary", {}, name), area.element) as HTMLDetailsElement;
        group.open = i === 0;
        return group;
      }));
    }
    for (const { name, text } of files) {
      const area = areas.get(name);
      if (!area || text === null || typed.has(name)) continue;
      area.show(text);
      area.box.rows = Math.min(40, text.split("\n").length + 1);
    }
    const rest = files.filter((f) => f.text === null).map((f) => f.name);
    others.textContent = rest.length ? `Also read, and no text: ${rest.join(", ")}.` : "";
  }

  return {
    element,
    async show(file, path, steps): Promise<api.GrammarFiles> {
      if (file !== shown) typed.clear();
      shown = file;
      at = path;
      const answer = await api.grammarFiles(file, steps);
      if (file !== shown) return answer;
      lay(answer.files);
      if (!typed.size) mark(answer.errors);
      return answer;
    },
  };
}
