/** Edits of a preset's text that leave comments, order and layout of all the rest as they are. */

import { findNodeAtLocation, parseTree, type Node } from "jsonc-parser";
import type { Path } from "./pointer";

const WIDTH = 118;
const PARSING = { allowTrailingComma: true };

/** A value as a person would write it: on one line where there is room, else one member or item a line. */
function print(value: unknown, indent = ""): string {
  const line = oneLine(value);
  if (indent.length + line.length <= WIDTH || typeof value !== "object" || value === null) return line;
  const inner = indent + "  ";
  if (Array.isArray(value)) return `[\n${value.map((v) => inner + print(v, inner)).join(",\n")}\n${indent}]`;
  const members = Object.entries(value).map(([k, v]) => `${inner}${JSON.stringify(k)}: ${print(v, inner)}`);
  return `{\n${members.join(",\n")}\n${indent}}`;
}

function oneLine(value: unknown): string {
  if (Array.isArray(value)) return `[${value.map(oneLine).join(", ")}]`;
  if (typeof value === "object" && value !== null)
    return `{${Object.entries(value)
      .map(([k, v]) => `${JSON.stringify(k)}: ${oneLine(v)}`)
      .join(", ")}}`;
  return JSON.stringify(value);
}

const endOf = (node: Node): number => node.offset + node.length;
const indentAt = (text: string, offset: number): string => /^[ \t]*/.exec(text.slice(text.lastIndexOf("\n", offset - 1) + 1))![0];
const cut = (text: string, from: number, to: number, put = ""): string => text.slice(0, from) + put + text.slice(to);

/** The children of an object or list: whole members of an object. */
const childrenOf = (node: Node): Node[] => node.children ?? [];

/** Is each child of it on a line of its own (or most of them)? */
function isSpread(text: string, node: Node): boolean {
  const children = childrenOf(node);
  const last = children.at(-1);
  if (!last) return false;
  const before = children.length > 1 ? endOf(children.at(-2)!) : node.offset;
  return text.slice(before, last.offset).includes("\n") || text.slice(node.offset, children[0]!.offset).includes("\n");
}

/** Where the comma after a child stands; -1: there is none. Comments on the way are passed over. */
function commaAfter(text: string, from: number, end: number): number {
  for (let at = from; at < end; at++) {
    if (text.startsWith("//", at)) at = Math.max(at, text.indexOf("\n", at));
    else if (text.startsWith("/*", at)) at = text.indexOf("*/", at) + 1;
    else if (text[at] === ",") return at;
  }
  return -1;
}

/** Puts the text of a child into an object or list, before child `index` or at the end. */
function insertChild(text: string, node: Node, child: string, index: number): string {
  const children = childrenOf(node);
  const spread = isSpread(text, node);
  const next = children[index];
  if (next) return cut(text, next.offset, next.offset, child + (spread ? ",\n" + indentAt(text, next.offset) : ", "));
  const last = children.at(-1);
  if (!last) {
    const blank = !text.slice(node.offset + 1, endOf(node) - 1).trim();
    return cut(text, node.offset + 1, blank ? endOf(node) - 1 : node.offset + 1, child);
  }
  const end = endOf(last);
  const comma = commaAfter(text, end, endOf(node) - 1);
  if (!spread) return comma < 0 ? cut(text, end, end, ", " + child) : cut(text, end, comma + 1, ", " + child);
  // A comment behind the last child stays on its line.
  const lineEnd = text.indexOf("\n", end);
  const tail = /^,?\s*(\/\/.*|\/\*.*\*\/\s*)$/.test(text.slice(end, lineEnd)) ? lineEnd : comma < 0 ? end : comma + 1;
  const put = "\n" + indentAt(text, last.offset) + child;
  const added = cut(text, tail, tail, put);
  return comma < 0 ? cut(added, end, end, ",") : added;
}

function removeChild(text: string, parent: Node, child: Node): string {
  const children = childrenOf(parent);
  const index = children.indexOf(child);
  const next = children[index + 1];
  if (next) {
    const comma = commaAfter(text, endOf(child), next.offset);
    const space = /^\s*/.exec(text.slice(comma + 1))![0].length;
    return cut(text, child.offset, comma + 1 + space);
  }
  const spaceBefore = /\s*$/.exec(text.slice(0, child.offset))![0].length;
  const comma = commaAfter(text, endOf(child), endOf(parent) - 1);
  const end = comma < 0 ? endOf(child) : comma + 1;
  // What goes on behind it must not come to stand in the comment of the line before.
  const goesOn = !/^[ \t]*(\n|$)/.test(text.slice(end));
  const space = text.slice(child.offset - spaceBefore, child.offset);
  let shorter = cut(text, child.offset - spaceBefore, end, goesOn && space.includes("\n") ? space : "");
  if (index > 0) {
    const before = endOf(children[index - 1]!);
    const kept = commaAfter(shorter, before, child.offset - spaceBefore);
    if (kept >= 0) shorter = cut(shorter, kept, kept + 1);
  }
  return shorter;
}

const member = (key: string, value: unknown, indent: string): string => `${JSON.stringify(key)}: ${print(value, indent)}`;

/** `value` inside of what the rest of a path asks for. */
const wrapped = (path: Path, value: unknown): unknown =>
  path.reduceRight<unknown>((inner, key) => (typeof key === "number" ? [inner] : { [key]: inner }), value);

/** The text with that value at that path; what is missing on the way there is made. */
export function setAt(text: string, path: Path, value: unknown): string {
  let node = parseTree(text, [], PARSING);
  if (!node || node.type !== "object") return print(wrapped(path, value)) + "\n";
  for (let depth = 0; depth < path.length; depth++) {
    const key = path[depth]!;
    const next: Node | undefined = findNodeAtLocation(node, [key]);
    if (next) {
      node = next;
      continue;
    }
    const rest = wrapped(path.slice(depth + 1), value);
    const indent = isSpread(text, node) ? indentAt(text, childrenOf(node).at(-1)!.offset) : indentAt(text, node.offset);
    if (node.type === "object") return insertChild(text, node, member(String(key), rest, indent), Infinity);
    if (node.type === "array") return insertChild(text, node, print(rest, indent), Number(key));
    return cut(text, node.offset, endOf(node), print(wrapped(path.slice(depth), value), indent));
  }
  return cut(text, node.offset, endOf(node), print(value, indentAt(text, node.offset)));
}

/** The text with a list longer by an item; `item` may be a value or, as text, what another item reads. */
export function insertAt(text: string, list: Path, index: number, item: unknown, asText = false): string {
  const root = parseTree(text, [], PARSING);
  const node = root && findNodeAtLocation(root, list);
  if (!node || node.type !== "array") return setAt(text, list, [item]);
  const indent = indentAt(text, childrenOf(node).at(-1)?.offset ?? node.offset);
  const child = asText ? String(item) : print(item, indent);
  if (!node.children?.length) return cut(text, node.offset, endOf(node), `[\n${indent}  ${child}\n${indent}]`);
  return insertChild(text, node, child, index);
}

/** The text without what is there. Objects that this leaves empty go as well, but no item of a list. */
export function removeAt(text: string, path: Path): string {
  const root = parseTree(text, [], PARSING);
  const value = root && findNodeAtLocation(root, path);
  if (!value) return text;
  const child = value.parent?.type === "property" ? value.parent : value;
  const parent = child.parent;
  if (!parent) return text;
  if (parent.type === "object" && parent.parent?.type === "property" && childrenOf(parent).length === 1)
    return removeAt(text, path.slice(0, -1));
  return removeChild(text, parent, child);
}

/** The text with another member in the place of one; a `key` of null takes that away. */
export function renameAt(text: string, path: Path, key: string | null, value: unknown): string {
  const root = parseTree(text, [], PARSING);
  const node = root && findNodeAtLocation(root, path)?.parent;
  if (key === null || node?.type !== "property") return removeAt(text, path);
  return cut(text, node.offset, endOf(node), member(key, value, indentAt(text, node.offset)));
}

/** What stands at a path, as it is written there. */
export function sliceAt(text: string, path: Path): string | null {
  const root = parseTree(text, [], PARSING);
  const node = root && findNodeAtLocation(root, path);
  return node ? text.slice(node.offset, endOf(node)) : null;
}

/** Line and column, both from 1, of what stands at a path. */
export function placeOf(text: string, path: Path): { line: number; column: number } | null {
  const root = parseTree(text, [], PARSING);
  const node = root && findNodeAtLocation(root, path);
  if (!node) return null;
  const before = text.slice(0, node.offset);
  return { line: before.split("\n").length, column: node.offset - before.lastIndexOf("\n") };
}
