/** Yes or no, one of a few, and text. */

import { el } from "../dom";
import type { EnumField, PlainField } from "../schema";
import { spelled } from "../schema";
import { isTyping, valueOf, type Control, type Place } from "./control";

export function booleanControl(place: Place<PlainField>): Control {
  const box = el<HTMLInputElement>("input", { type: "checkbox", "aria-label": place.label, change: () => place.binding.set(box.checked) });
  return { element: el("span.check", {}, box), refresh: () => void (box.checked = valueOf(place) === true) };
}

/** Few short options stand side by side, more in a list. */
export function enumControl(place: Place<EnumField>): Control {
  const { options } = place.field;
  const room = options.reduce((sum, o) => sum + o.value.length + 3, 0);
  return options.length <= 4 && room <= 24 ? segments(place) : list(place);
}

function segments(place: Place<EnumField>): Control {
  const buttons = place.field.options.map(({ value, doc }) =>
    el<HTMLButtonElement>("button", { type: "button", "data-tip": doc || null, click: () => place.binding.set(value) }, spelled(value)),
  );
  return {
    element: el("span.segments", { role: "group", "aria-label": place.label }, ...buttons),
    refresh(): void {
      const now = valueOf(place);
      buttons.forEach((b, i) => b.setAttribute("aria-pressed", String(place.field.options[i]!.value === now)));
    },
  };
}

function list(place: Place<EnumField>): Control {
  const options = place.field.options.map(({ value }) => el<HTMLOptionElement>("option", { value }, spelled(value)));
  const select = el<HTMLSelectElement>("select", { "aria-label": place.label, change: () => place.binding.set(select.value) }, ...options);
  return {
    element: select,
    refresh(): void {
      select.value = String(valueOf(place) ?? "");
      const doc = place.field.options.find((o) => o.value === select.value)?.doc;
      if (doc) select.dataset.tip = doc;
    },
  };
}

export function textControl(place: Place<PlainField>): Control {
  const box = el<HTMLInputElement>("input.text", { type: "text", "aria-label": place.label, spellcheck: false, autocomplete: "off" });
  box.addEventListener("input", () => {
    box.dataset.touched = "yes";
    place.binding.set(box.value, false);
  });
  box.addEventListener("change", () => {
    delete box.dataset.touched;
    place.binding.store.endGesture();
  });
  return {
    element: box,
    refresh(): void {
      if (!isTyping(box)) box.value = String(valueOf(place) ?? "");
    },
  };
}

/** Anything else is typed as JSON. */
export function jsonControl(place: Place<PlainField>): Control {
  const box = el<HTMLInputElement>("input.text.code", { type: "text", "aria-label": `${place.label}, as JSON`, spellcheck: false, autocomplete: "off" });
  box.addEventListener("input", () => (box.dataset.touched = "yes"));
  box.addEventListener("change", () => {
    delete box.dataset.touched;
    try {
      place.binding.set(JSON.parse(box.value));
      box.removeAttribute("aria-invalid");
    } catch {
      box.setAttribute("aria-invalid", "true");
    }
  });
  return {
    element: box,
    refresh(): void {
      const value = valueOf(place);
      if (!isTyping(box) && !box.hasAttribute("aria-invalid")) box.value = value === undefined ? "" : JSON.stringify(value);
    },
  };
}
