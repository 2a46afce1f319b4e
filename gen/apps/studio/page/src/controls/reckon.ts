/** Numbers as people type them: "1,5", "1.234,5", "2*0.7", "(1+2)/3", "50cm". */

/** What a unit is of the one that it is a part or a multiple of. */
const UNITS: Record<string, Record<string, number>> = {
  m: { m: 1, cm: 0.01, mm: 0.001, km: 1000, um: 1e-6, µm: 1e-6 },
  "°": { "°": 1, deg: 1, degrees: 1, rad: 180 / Math.PI },
  s: { s: 1, ms: 0.001, min: 60 },
  h: { h: 1, min: 1 / 60 },
  years: { years: 1, year: 1, a: 1 },
  px: { px: 1, pixels: 1 },
};

export type Reckoned = { value: number } | { wrong: string };

class Wrong extends Error {}

/** The value of a number's digits: of a comma and a point the last parts the decimals, and one alone does so. */
function digits(text: string): number {
  const last = Math.max(text.lastIndexOf(","), text.lastIndexOf("."));
  const mark = text[last];
  const whole = text.slice(0, Math.max(last, 0));
  const groups = whole.split(/[.,]/);
  const grouped = groups.length > 1;
  if (last < 0) return Number(text);
  if (grouped && (whole.includes(mark!) || !groups.slice(1).every((g) => g.length === 3))) {
    // 1.234.567: the same mark more than once groups thousands.
    const all = text.split(mark!);
    if (/[.,]/.test(all.join("")) || !all.slice(1).every((g) => g.length === 3)) throw new Wrong(`“${text}” is no number`);
    return Number(all.join(""));
  }
  return Number(`${groups.join("") || "0"}.${text.slice(last + 1) || "0"}`);
}

/** Reads a sum of products, with brackets, of numbers that may have units. */
class Reader {
  private at = 0;
  constructor(
    private text: string,
    private unit: string,
  ) {}

  all(): number {
    const value = this.sum();
    if (this.at < this.text.length) throw new Wrong(`“${this.text.slice(this.at)}” is not understood`);
    return value;
  }

  private take(pattern: RegExp): string | null {
    const found = pattern.exec(this.text.slice(this.at));
    if (!found) return null;
    this.at += found[0].length;
    return found[0].trim();
  }

  private sum(): number {
    let value = this.product();
    for (let sign; (sign = this.take(/^\s*[+\-−–]\s*/)); ) value += (sign === "+" ? 1 : -1) * this.product();
    return value;
  }

  private product(): number {
    let value = this.factor();
    for (let sign; (sign = this.take(/^\s*[*×·/:]\s*/)); ) value = "/:".includes(sign) ? value / this.factor() : value * this.factor();
    return value;
  }

  private factor(): number {
    const sign = this.take(/^\s*[+\-−–]\s*/);
    if (sign) return (sign === "+" ? 1 : -1) * this.factor();
    if (this.take(/^\s*\(\s*/)) {
      const value = this.sum();
      if (!this.take(/^\s*\)\s*/)) throw new Wrong("a bracket is not closed");
      return value * this.measure();
    }
    const number = this.take(/^\s*(?:\d[\d.,]*|[.,]\d+)(?:e[+-]?\d+)?/i);
    if (number === null) throw new Wrong(this.at < this.text.length ? `“${this.text.slice(this.at)}” is no number` : "a number is missing");
    const [mantissa, exponent = "0"] = number.split(/e/i) as [string, string?];
    return digits(mantissa) * 10 ** Number(exponent) * this.measure();
  }

  /** The unit that follows, as a factor. */
  private measure(): number {
    const name = this.take(/^\s*(?:[a-zµ]+|°|%)\s*/i);
    if (name === null) return 1;
    if (name === "%") return 0.01;
    const factor = UNITS[this.unit]?.[name] ?? (name === this.unit ? 1 : undefined);
    if (factor !== undefined) return factor;
    throw new Wrong(this.unit ? `“${name}” is no unit of ${this.unit}` : `this has no unit, so “${name}” means nothing`);
  }
}

/** What a text comes to in a unit; or what is wrong with it. */
export function reckon(text: string, unit = ""): Reckoned {
  if (!text.trim()) return { wrong: "a number is missing" };
  try {
    const value = new Reader(text.trim(), unit).all();
    if (!Number.isFinite(value)) return { wrong: "that is no finite number" };
    // 3 * 0.1 is 0.3 to a person.
    return { value: Number(value.toPrecision(12)) };
  } catch (error) {
    if (error instanceof Wrong) return { wrong: error.message };
    throw error;
  }
}
