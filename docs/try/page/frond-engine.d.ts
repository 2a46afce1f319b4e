declare module "frond-engine" {
  const source: string;
  export default source;
}

declare module "coral-schema" {
  /** Of each kind of coral its own properties as JSON Schema, and which of them shape it most. */
  const kinds: Record<string, { properties: Record<string, unknown>; leading: string[] }>;
  export default kinds;
}
