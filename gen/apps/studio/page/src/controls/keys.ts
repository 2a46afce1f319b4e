/** What may change over the film: one value, or keys of a time and a value each. */

import { el, iconButton } from "../dom";
import { keysOf, valueAtTime, withKey } from "../keyframes";
import type { KeyedField, NumberField } from "../schema";
import { controlFor } from "./field";
import { valueOf, type Control, type Place } from "./control";
import { numberBox } from "./number";

const SECONDS: NumberField = { type: "number", doc: "", unit: "s", low: -1e6, high: 1e6, integer: false };

export function keyedControl(place: Place<KeyedField>): Control {
  const { field, binding, label } = place;
  const { store } = binding;
  const host = el("div.keyed");
  let built = "";
  let inner: Control[] = [];

  const animate = (): void => binding.set(withKey(null, store.time, valueOf(place) ?? field.base.default));
  const addKey = (): void => {
    const value = valueOf(place);
    binding.set(withKey(value, store.time, valueAtTime(value, store.time)));
  };
  const removeKey = (index: number): void => {
    const keys = keysOf(valueOf(place)) ?? [];
    binding.set(keys.length > 1 ? keys.toSpliced(index, 1) : keys[0]![1]);
  };
  const moveKey = (index: number, time: number, done: boolean): void => {
    const keys = structuredClone(keysOf(valueOf(place)) ?? []);
    keys[index]![0] = time;
    binding.set(done ? keys.sort((a, b) => a[0] - b[0]) : keys, done);
  };

  const buildConstant = (): void => {
    const control = controlFor({ field: { ...field.base, default: field.base.default ?? field.default }, binding, label });
    const key = iconButton("key", `Animate ${label}: a key at the time shown`, animate, { "data-testid": `animate:${binding.rel.join("/")}` });
    key.classList.add("key-button");
    inner = [control];
    host.replaceChildren(control.element, key);
  };

  const buildKeys = (count: number): void => {
    inner = [];
    const rows = Array.from({ length: count }, (_, i) => {
      const time = numberBox(`${label}, time of key ${i + 1}`, SECONDS, (value, done) => moveKey(i, value, done));
      const keyBinding = binding.item(i).item(1);
      const control = controlFor({ field: field.base, binding: keyBinding, label: `${label}, key ${i + 1}` });
      inner.push(control, { element: time, refresh: () => time.show(keysOf(valueOf(place))?.[i]?.[0] ?? "") });
      const go = el("button.diamond", { type: "button", "aria-label": `Go to key ${i + 1} of ${label}`, click: () => store.setTime(keysOf(valueOf(place))?.[i]?.[0] ?? 0) });
      return el("div.key-row", {}, go, el("span.boxed", {}, time, el("span.unit", {}, "s")), control.element,
        iconButton("remove", `Remove key ${i + 1} of ${label}`, () => removeKey(i)));
    });
    const add = el("button.small", { type: "button", click: addKey }, "Key at the time shown");
    host.replaceChildren(...rows, add);
  };

  return {
    element: host,
    refresh(): void {
      const keys = keysOf(valueOf(place));
      const shape = keys ? `keys ${keys.length}` : "constant";
      host.classList.toggle("with-keys", keys !== null);
      if (shape !== built) {
        built = shape;
        if (keys) buildKeys(keys.length);
        else buildConstant();
      }
      for (const control of inner) control.refresh();
    },
  };
}
