import { Color, Matrix4, Vector3, Vector4, type IUniform, type Texture } from "three";

type Uniforms = Record<string, IUniform>;

/** How many stops the server sends at most. */
export const BACKDROP_STOPS = 6;

/** What all shaders are told: set in one place before each pass, held by every material. */
export const shared = (): Uniforms & ReturnType<typeof all> => all();

function all() {
  return {
    eye: { value: new Vector4(0, 0, 0, 1) },
    pixel: { value: 0.001 },
    thin: { value: 0 },
    grain: { value: 0 },
    mask: { value: 0 },
    sun: { value: new Vector3(0, 1, 0) },
    sun_light: { value: new Color() },
    from_above: { value: new Color() },
    from_aside: { value: new Color() },
    from_below: { value: new Color() },
    from_eye: { value: new Color() },
    haze: { value: new Vector4() },
    sky: { value: null as Texture | null },
    backdrop: { value: Array.from({ length: BACKDROP_STOPS }, () => new Vector4()) },
    to_shade: { value: new Matrix4() },
    shade: { value: null as Texture | null },
    shade_texel: { value: 0 },
    painted: { value: null as Texture | null },
    to_painted: { value: new Matrix4() },
  };
}

export type Shared = ReturnType<typeof shared>;
