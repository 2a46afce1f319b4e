declare module "frond-engine" {
  const source: string;
  export default source;
}
