/** A text box with numbered lines, some of which are marked as wrong. */

import { el } from "../dom";

export interface CodeArea {
  element: HTMLElement;
  box: HTMLTextAreaElement;
  /** Shows a text, unless it is what stands there. */
  show(text: string): void;
  /** From line (1 is the first) to what is wrong there. */
  mark(lines: Map<number, string>): void;
  goTo(line: number, column?: number): void;
}

export function codeArea(label: string, changed: (text: string) => void, attributes: Record<string, unknown> = {}): CodeArea {
  const numbers = el("div.numbers", { "aria-hidden": "true" });
  const backs = el("div.backs", { "aria-hidden": "true" });
  const box = el<HTMLTextAreaElement>("textarea", { "aria-label": label, spellcheck: false, autocomplete: "off", wrap: "off", ...attributes });
  const element = el("div.code-area", {}, el("div.gutter", {}, numbers), el("div.sheet", {}, backs, box));
  let marks = new Map<number, string>();
  let count = 0;

  const number = (): void => {
    const lines = box.value.split("\n").length;
    if (lines !== count) numbers.replaceChildren(...Array.from({ length: lines }, (_, i) => el("span", {}, String(i + 1))));
    count = lines;
    [...numbers.children].forEach((line, i) => line.classList.toggle("wrong", marks.has(i + 1)));
    backs.replaceChildren(...[...marks].map(([line, text]) => {
      const back = el("i", {}, text);
      back.style.top = `calc(${line - 1} * var(--code-line))`;
      return back;
    }));
    box.setAttribute("aria-invalid", String(marks.size > 0));
  };
  const scroll = (): void => {
    numbers.style.transform = `translateY(${-box.scrollTop}px)`;
    backs.style.transform = `translate(0, ${-box.scrollTop}px)`;
  };
  box.addEventListener("input", () => {
    number();
    changed(box.value);
  });
  box.addEventListener("scroll", scroll);
  return {
    element,
    box,
    show(text): void {
      if (box.value === text) return;
      const { selectionStart, selectionEnd, scrollTop } = box;
      box.value = text;
      box.setSelectionRange(selectionStart, selectionEnd);
      box.scrollTop = scrollTop;
      number();
    },
    mark(lines): void {
      marks = lines;
      number();
    },
    goTo(line, column = 1): void {
      const lines = box.value.split("\n");
      const offset = lines.slice(0, line - 1).reduce((sum, l) => sum + l.length + 1, 0) + column - 1;
      box.focus();
      box.setSelectionRange(offset, offset);
      const height = parseFloat(getComputedStyle(box).lineHeight);
      box.scrollTop = Math.max(0, (line - 4) * height);
    },
  };
}
