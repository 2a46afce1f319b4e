/** Light or dark: as the system has it, until the person says otherwise. */

const KEY = "frond.theme";
const system = matchMedia("(prefers-color-scheme: dark)");
const listeners = new Set<(dark: boolean) => void>();

const chosen = (): string | null => localStorage.getItem(KEY);
const isDark = (): boolean => (chosen() ? chosen() === "dark" : system.matches);

function apply(): void {
  document.documentElement.dataset.theme = isDark() ? "dark" : "light";
  for (const tell of listeners) tell(isDark());
}

export function toggleTheme(): void {
  localStorage.setItem(KEY, isDark() ? "light" : "dark");
  apply();
}

export function onTheme(tell: (dark: boolean) => void): void {
  listeners.add(tell);
  tell(isDark());
}

system.addEventListener("change", apply);
apply();
