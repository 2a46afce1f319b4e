/** The calls of the server. */

export interface Doc {
  text: string;
  file: string;
}
export interface Fault {
  text: string;
  where: string;
  /** From 1; 0: unknown. */
  line: number;
  column: number;
  pointer: string;
}
export interface Listed {
  file: string;
  /** Its path below the folder of presets, as "forest/autumn". */
  name: string;
  title: string;
  picture: string | null;
}
export interface Loaded {
  file: string;
  text: string;
  disk: string | null;
  copy?: boolean;
}
export interface Start {
  machine: { cores: number; farm: boolean };
  schema: Record<string, unknown>;
  symbols: { symbol: string; doc: string }[];
  preset: Loaded | null;
  presets: Listed[];
  /** The properties of which there are pictures, as "tree-habit-droop"; not told by an older server. */
  strips?: string[];
}
export interface CostEstimate {
  nodes: number;
  seconds: number;
  memory: number;
}
export type SceneAnswer =
  | { is: "picture"; bytes: ArrayBuffer }
  | { is: "stale" }
  | { is: "wrong"; errors: Fault[]; notes: string[] }
  | { is: "long"; estimate: CostEstimate };
export interface Derived {
  word: string;
  length: number;
  counts: Record<string, number>;
  steps: number;
  tree: string | null;
  svg: string | null;
  predicted: { modules: number; segments: number } | null;
}
export type Quality = "draft" | "good" | "best";
export interface RenderState {
  state: "growing" | "rendering" | "done" | "failed" | "cancelled";
  progress: number;
  seconds: number;
  left: number | null;
  message: string;
  preview: boolean;
}
export interface PastRender {
  id: string;
  state: RenderState["state"];
  seconds: number;
  title: string;
  seed: number;
  time: number;
  size: [number, number];
  quality: Quality;
}
/** How a film is to be rendered. */
export interface FilmOrder {
  size: [number, number];
  quality: Quality;
  /** "A-B"; "": all frames. */
  range: string;
  /** A small draft of a few frames over the whole film comes first. */
  rough: boolean;
  /** Slurm renders it. */
  farm: boolean;
}
export interface FilmState {
  id: string;
  folder: string;
  state: "waiting" | "rendering" | "farm" | "paused" | "failed" | "done";
  phase: "" | "rough" | "frames";
  message: string;
  /** What the renderer has said last. */
  said: string;
  done: number;
  of: number;
  /** The numbers of the frames that are finished. */
  there: number[];
  /** The name of the finished film, and of the file that browsers play: that one, or a rough one; empty: none. */
  film: string;
  plays: string;
  /** Whether its pictures have opacity; not told of old ones. */
  transparent?: boolean;
  watch: boolean;
  order: FilmOrder;
  title: string;
  seed: number;
  fps: number;
  frames: number;
}
export type SaveAnswer =
  | { is: "saved"; file: string; disk: string; text: string }
  | { is: "conflict"; error: string; disk: string }
  | { is: "wrong"; errors: Fault[] };

/** The server said no; `status` 0: it did not answer at all. */
export class ApiError extends Error {
  constructor(
    readonly status: number,
    message: string,
  ) {
    super(message);
  }
}

const TOKEN = "frond.token";

/** Takes the token off the address, where `frond studio` printed it, and keeps it for this tab. True where there was one. */
export function takeToken(): boolean {
  const found = /token=([0-9a-fA-F]+)/.exec(location.hash);
  if (!found) return false;
  sessionStorage.setItem(TOKEN, found[1]!);
  const rest = location.hash.replace(/[#&]?token=[0-9a-fA-F]+/, "").replace(/^&/, "#");
  history.replaceState(null, "", location.pathname + location.search + rest);
  return true;
}

const token = (): string => sessionStorage.getItem(TOKEN) ?? "";
let channel: BroadcastChannel | undefined;  // not before somebody listens: it would keep a program without a page running
const tabs = (): BroadcastChannel => (channel ??= new BroadcastChannel(TOKEN));

/** Tells the other tabs the token that the server knows this one by. */
export const tellToken = (): void => tabs().postMessage(token());

/**
 * Calls `act` when this tab has another token: its address was changed to the one that was printed, or it was `wanted` and
 * another tab has one that the server knows.
 */
export function onNewToken(wanted: () => boolean, act: () => void): void {
  addEventListener("hashchange", () => takeToken() && act());
  tabs().addEventListener("message", (event: MessageEvent<unknown>) => {
    if (!wanted() || typeof event.data !== "string" || !/^[0-9a-fA-F]+$/.test(event.data) || event.data === token()) return;
    sessionStorage.setItem(TOKEN, event.data);
    act();
  });
}

async function call(method: string, path: string, body?: BodyInit | object, signal?: AbortSignal): Promise<Response> {
  const plain = typeof body === "string" || body instanceof Blob || body instanceof FormData || body === undefined;
  try {
    return await fetch(path, {
      method,
      headers: { "X-Frond-Token": token(), ...(plain ? {} : { "Content-Type": "application/json" }) },
      body: plain ? (body as BodyInit | undefined) : JSON.stringify(body),
      signal,
      cache: "no-store",
    });
  } catch (error) {
    if ((error as Error).name === "AbortError") throw error;
    throw new ApiError(0, "The server does not answer");
  }
}

async function refuse(answer: Response): Promise<never> {
  const said = (await answer.json().catch(() => ({}))) as { error?: string; errors?: Fault[] };
  throw new ApiError(answer.status, said.error ?? said.errors?.[0]?.text ?? `The server answers ${answer.status}`);
}

async function json<T>(method: string, path: string, body?: BodyInit | object): Promise<T> {
  const answer = await call(method, path, body);
  if (!answer.ok) await refuse(answer);
  return (await answer.json()) as T;
}

const withToken = (path: string): string => `${path}?token=${encodeURIComponent(token())}`;

export const start = (): Promise<Start> => json("GET", "/api/start");
export const ping = (): Promise<{ ok: boolean; started: string }> => json("GET", "/api/ping");
export const preset = (file: string): Promise<Loaded> => json("GET", `/api/preset?file=${encodeURIComponent(file)}`);
/** What stands for a file as it is on the disk now; "" where it is not there. */
export const disk = async (file: string): Promise<string> => (await json<{ disk: string }>("GET", `/api/disk?file=${encodeURIComponent(file)}`)).disk;
/** The presets in the folders that may be written, those first that were written last. */
export const files = (): Promise<Listed[]> => json("GET", "/api/files");
/** A small picture of a preset that has none in the gallery; null where it takes long to grow. */
export async function look(file: string, signal: AbortSignal): Promise<Blob | null> {
  const answer = await call("GET", `/api/look?file=${encodeURIComponent(file)}`, undefined, signal);
  return answer.status === 200 ? answer.blob() : null;
}
/** What an organism is made of, on a ball; null where it is of no material of its own. */
export async function ball(doc: Doc, entry: number, signal?: AbortSignal): Promise<Blob | null> {
  const answer = await call("POST", "/api/ball", { doc, entry }, signal);
  return answer.status === 200 ? answer.blob() : null;
}
/** What a property does: three pictures in a row. */
export const strip = (name: string): string => withToken(`/api/strip/${encodeURIComponent(name)}.jpg`);
/** A page of the documentation, as text. */
export const docs = (name: string): string => withToken(`/api/docs/${encodeURIComponent(name)}`);
export const galleryPicture = (name: string): string => withToken(`/api/gallery/${encodeURIComponent(name)}`);

export interface SceneRequest {
  doc: Doc;
  time: number;
  have: string[];
  solo: number[] | null;
  hide: number[];
  /** Ask the person where it would take longer than so many seconds, or be more nodes; null: never. */
  ask: number | null;
  most?: number;
  /** Of what is not grown yet, just these organisms: the others are `missing` in the answer. */
  only?: number[];
  /** These roughly, in about this share of the time, 0..1. */
  share?: number;
}

/** How many organisms have grown of those that a session waits for. */
export const sceneProgress = (session: string): Promise<{ done: number; of: number }> => json("GET", `/api/scene?session=${session}`);
/** Nobody waits for that answer any more. */
export const leaveScene = (session: string, seq: number): Promise<unknown> => json("DELETE", `/api/scene?session=${session}&seq=${seq}`);

/** The model at a time. Of each session the newest `seq` counts. */
export async function scene(session: string, seq: number, request: SceneRequest, signal?: AbortSignal): Promise<SceneAnswer> {
  const answer = await call("POST", `/api/scene?session=${session}&seq=${seq}`, request, signal);
  if (answer.status === 200) return { is: "picture", bytes: await answer.arrayBuffer() };
  if (answer.status === 202) {
    const said = (await answer.json()) as { estimate: CostEstimate } | { stale: true };
    return "estimate" in said ? { is: "long", ...said } : { is: "stale" };
  }
  if (answer.status === 422) {
    const said = (await answer.json()) as { errors: Fault[]; notes?: string[] };
    return { is: "wrong", errors: said.errors, notes: said.notes ?? [] };
  }
  return refuse(answer);
}

/** What a grammar comes to, or what is wrong with it. */
export async function derive(doc: Doc, entry: number, steps: number | null): Promise<Derived | Fault[]> {
  const answer = await call("POST", "/api/derive", { doc, entry, steps });
  if (answer.status === 422) return ((await answer.json()) as { errors: Fault[] }).errors;
  if (!answer.ok) await refuse(answer);
  return (await answer.json()) as Derived;
}

/** The files that a grammar stands in, as seen from its folder, and of a model of cpfg its word. */
export interface GrammarFiles {
  /** Null: what is no text. */
  files: { name: string; text: string | null }[];
  steps: number;
  /** How many the model makes by itself. */
  of: number;
  word: string | null;
  length: number | null;
  counts: Record<string, number>;
  /** What a model's turtle draws; null where that is much, and not told by an older server. */
  svg?: string | null;
  notes: string[];
  errors: Fault[];
}
export const grammarFiles = (file: string, steps: number | null): Promise<GrammarFiles> => json("POST", "/api/grammar", { file, steps });
/** Writes the grammar anew, with another text of one of its files, beside the presets; what is wrong with it where it cannot be read so. */
export async function changeGrammar(file: string, name: string, text: string, of: string): Promise<{ file: string; path: string } | Fault[]> {
  const answer = await call("POST", "/api/grammar/change", { file, name, text, of });
  if (answer.status === 422) return ((await answer.json()) as { errors: Fault[] }).errors;
  if (!answer.ok) await refuse(answer);
  return (await answer.json()) as { file: string; path: string };
}

/** A branch of an organism as it stands at a time, with the address of the place on it that was meant. */
export interface Picked {
  entry: number;
  /** Which planting of its entry it is. */
  plant: number;
  /** "3/1:0.4": its axis, and the share of its length. */
  at: string;
  point: [number, number, number];
  radius: number;
  /** How the plant's own axes are turned (x y z w), and how many times as large it stands. */
  frame: [number, number, number, number];
  size: number;
  /** x y z r of both ends of the segments beyond that place, and of the nodes of the axis from its foot on. */
  hangs: number[];
  beam: number[];
  /** The age of a tree in years. */
  year: number | null;
}
/** The first branch that a ray meets, or the one of an address; null: none. */
export const pick = (doc: Doc, time: number, where: { from: number[]; to: number[] } | { entry: number; plant: number; at: string }): Promise<Picked | null> =>
  json("POST", "/api/pick", { doc, time, ...where });

export interface Hit {
  at: [number, number, number];
  normal: [number, number, number];
  /** -1: the ground. */
  entry: number;
}
/** Where rays (x y z and the direction) first meet the ground or those organisms. */
export const trace = async (doc: Doc, time: number, rays: number[][], on?: number[]): Promise<(Hit | null)[]> =>
  (await json<{ hits: (Hit | null)[] }>("POST", "/api/trace", { doc, time, rays, on })).hits;

export async function render(doc: Doc, time: number, size: [number, number], quality: Quality): Promise<{ id: string } | Fault[]> {
  const answer = await call("POST", "/api/render", { doc, time, size, quality });
  if (answer.status === 422) return ((await answer.json()) as { errors: Fault[] }).errors;
  if (!answer.ok) await refuse(answer);
  return (await answer.json()) as { id: string };
}
/** How a scene is exported: by default as it is at the time. */
export interface ExportOrder {
  /** An extension, as ".glb". */
  type: string;
  /** Triangles of one organism, about. */
  detail?: number;
  /** Of detail. */
  levels?: number;
  /** How it sways and grows over the film comes with it. */
  wind?: boolean;
}
/** How large what would be written is, about; `triangles`: of each level; `sown`: plants that are not counted. */
export interface ExportSize {
  triangles: number[];
  vertices: number;
  bytes: number;
  sown: number;
}
export const exportSize = (doc: Doc, time: number, order: ExportOrder): Promise<ExportSize> => json("POST", "/api/export/size", { doc, time, ...order });
/** Writes the scene as it is at a time into a file; where that is. */
export async function exported(doc: Doc, time: number, order: ExportOrder): Promise<{ file: string } | Fault[]> {
  const answer = await call("POST", "/api/export", { doc, time, ...order });
  if (answer.status === 422) return ((await answer.json()) as { errors: Fault[] }).errors;
  if (!answer.ok) await refuse(answer);
  return (await answer.json()) as { file: string };
}
export const renderState = (id: string): Promise<RenderState> => json("GET", `/api/render/${id}`);
export const renderDoc = (id: string): Promise<Doc> => json("GET", `/api/render/${id}/doc`);
export const renderPicture = (id: string): string => withToken(`/api/render/${id}/picture`);
export const renders = (): Promise<PastRender[]> => json("GET", "/api/renders");
export async function cancelRender(id: string): Promise<void> {
  await call("DELETE", `/api/render/${id}`);
}

export const films = (): Promise<FilmState[]> => json("GET", "/api/films");
export async function film(doc: Doc, order: FilmOrder): Promise<{ id: string } | Fault[]> {
  const answer = await call("POST", "/api/film", { doc, ...order });
  if (answer.status === 422) return ((await answer.json()) as { errors: Fault[] }).errors;
  if (!answer.ok) await refuse(answer);
  return (await answer.json()) as { id: string };
}
export const pauseFilm = (id: string): Promise<unknown> => json("POST", `/api/film/${id}/pause`, {});
export const resumeFilm = (id: string): Promise<unknown> => json("POST", `/api/film/${id}/resume`, {});
export const removeFilm = (id: string): Promise<unknown> => json("DELETE", `/api/film/${id}`);
/** Of a file of a film: "film.mp4", "film.mov", "rough.mp4", "watch.png", or the number of a frame. */
export const filmFile = (id: string, name: string | number): string => withToken(`/api/film/${id}/${name}`);
/** A small quick look at a time; null where the scene has not been grown. */
export async function moment(doc: Doc, time: number): Promise<Blob | null> {
  const answer = await call("POST", "/api/moment", { doc, time });
  return answer.status === 200 ? answer.blob() : null;
}

/** `doc` is the text and where it comes from: files that it names go along to another folder, and `text` is what was written. */
export async function save(file: string, doc: Doc, disk: string | null, overwrite: boolean, force: boolean): Promise<SaveAnswer> {
  const answer = await call("POST", "/api/save", { file, doc, disk, overwrite, force });
  if (answer.status === 409) return { is: "conflict", ...((await answer.json()) as { error: string; disk: string }) };
  if (answer.status === 422) return { is: "wrong", ...((await answer.json()) as { errors: Fault[] }) };
  if (!answer.ok) await refuse(answer);
  return { is: "saved", ...((await answer.json()) as { file: string; disk: string; text: string }) };
}

/** Puts a mesh beside the presets, with those of the other files that it names; answers the name to write into an organism of kind "mesh". */
export function mesh(file: File, beside: File[], of: string): Promise<{ file: string }> {
  const form = new FormData();
  form.append("mesh", file);
  for (const one of beside) form.append("beside", one);
  return json("POST", `/api/mesh?of=${encodeURIComponent(of)}`, form);
}

/** Puts a PNG beside the presets; answers the name to write into a property that names one. */
export const painted = (name: string, file: Blob, of: string): Promise<{ file: string; path: string }> => json("POST", `/api/painted?name=${encodeURIComponent(name)}&of=${encodeURIComponent(of)}`, file);
/** That of a picture that a preset names. */
export const paintedAddress = (file: string): string => `${withToken("/api/painted")}&file=${encodeURIComponent(file)}`;

export const pictureAddress = (id: string): string => withToken(`/api/picture/${encodeURIComponent(id)}`);
