/** A menu below a button; by keys, too. */

import { el } from "../dom";

export interface MenuItem {
  label: string;
  act: () => void;
  disabled?: boolean;
  /** One of several, of which one counts; or, with `toggles`, something that is on or off. */
  checked?: boolean;
  toggles?: boolean;
  /** The key that does the same. */
  key?: string;
  testid?: string;
  tip?: string;
}

let open: { menu: HTMLElement; from: HTMLElement } | null = null;

function closeMenu(refocus = true): void {
  if (!open) return;
  const { menu, from } = open;
  open = null;
  menu.remove();
  from.setAttribute("aria-expanded", "false");
  if (refocus) from.focus();
}

export function openMenu(from: HTMLElement, items: MenuItem[]): void {
  const again = open?.from === from;
  closeMenu(false);
  if (again) return;
  const buttons = items.map(({ label, act, disabled, checked, toggles, key, testid, tip }) =>
    el<HTMLButtonElement>(
      "button",
      {
        type: "button",
        role: checked === undefined ? "menuitem" : toggles ? "menuitemcheckbox" : "menuitemradio",
        "data-testid": testid,
        "data-tip": tip,
        "aria-checked": checked === undefined ? null : String(checked),
        disabled,
        click: () => {
          closeMenu();
          act();
        },
      },
      label,
      key && el("kbd", { "aria-hidden": "true" }, key),
    ),
  );
  const menu = el("div.menu", { role: "menu", "aria-label": from.textContent || from.getAttribute("aria-label") }, ...buttons);
  const usable = buttons.filter((b) => !b.disabled);
  menu.addEventListener("keydown", (event) => {
    const at = usable.indexOf(document.activeElement as HTMLButtonElement);
    if (event.key === "ArrowDown") usable[(at + 1) % usable.length]?.focus();
    else if (event.key === "ArrowUp") usable[(at - 1 + usable.length) % usable.length]?.focus();
    else if (event.key === "Escape" || event.key === "Tab") closeMenu();
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  // In a dialog it must be part of that, or it could not be reached.
  (from.closest("dialog") ?? document.querySelector("main") ?? document.body).append(menu);
  const box = from.getBoundingClientRect();
  const size = menu.getBoundingClientRect();
  menu.style.left = `${Math.max(4, Math.min(box.left, innerWidth - size.width - 4))}px`;
  menu.style.top = `${box.bottom + size.height + 6 > innerHeight ? Math.max(4, box.top - size.height - 2) : box.bottom + 2}px`;
  from.setAttribute("aria-expanded", "true");
  open = { menu, from };
  usable[0]?.focus();
}

addEventListener("pointerdown", (event) => {
  if (open && !open.menu.contains(event.target as Node) && !open.from.contains(event.target as Node)) closeMenu(false);
});
