import { Box3, DepthTexture, LessEqualCompare, Matrix4, OrthographicCamera, UnsignedIntType, Vector3, WebGLRenderTarget, type Scene, type WebGLRenderer } from "three";
import type { Shared } from "./shared";

/** The sun's picture of the scene: what is behind what it sees is in shadow. */
export class Shadow {
  private target: WebGLRenderTarget;
  private camera = new OrthographicCamera();
  private box = new Box3();
  private corner = new Vector3();
  private toSun = new Matrix4();

  constructor(
    private renderer: WebGLRenderer,
    size: number,
  ) {
    this.target = new WebGLRenderTarget(size, size, { generateMipmaps: false });
    this.target.depthTexture = new DepthTexture(size, size, UnsignedIntType);
    this.target.depthTexture.compareFunction = LessEqualCompare;
    this.renderer.initRenderTarget(this.target);
  }

  get texture(): DepthTexture {
    return this.target.depthTexture!;
  }

  /** Draws `world`, whose things are set to be drawn flat, as the sun sees what lies in `bounds`. */
  draw(world: Scene, bounds: Box3, shared: Shared): void {
    const { camera, box, corner } = this;
    const sun = shared.sun.value;
    bounds.getCenter(camera.position);
    this.toSun.lookAt(sun, corner.set(0, 0, 0), camera.up.set(0, 1, Math.abs(sun.y) > 0.99 ? 1 : 0));
    camera.quaternion.setFromRotationMatrix(this.toSun);
    camera.updateMatrixWorld();
    box.makeEmpty();
    for (let i = 0; i < 8; ++i) {
      corner.set(i & 1 ? bounds.max.x : bounds.min.x, i & 2 ? bounds.max.y : bounds.min.y, i & 4 ? bounds.max.z : bounds.min.z);
      box.expandByPoint(corner.applyMatrix4(camera.matrixWorldInverse));
    }
    camera.left = box.min.x;
    camera.right = box.max.x;
    camera.bottom = box.min.y;
    camera.top = box.max.y;
    camera.near = -box.max.z - 0.1;
    camera.far = -box.min.z + 0.1;
    camera.updateProjectionMatrix();
    const texel = Math.max(box.max.x - box.min.x, box.max.y - box.min.y) / this.target.width;

    shared.eye.value.set(sun.x, sun.y, sun.z, 0);
    shared.pixel.value = texel;
    shared.thin.value = 0.5;
    this.renderer.setRenderTarget(this.target);
    this.renderer.clear();
    this.renderer.render(world, camera);
    this.renderer.setRenderTarget(null);
    shared.to_shade.value.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    shared.shade_texel.value = texel;
  }

  dispose(): void {
    this.target.depthTexture?.dispose();
    this.target.dispose();
  }
}
