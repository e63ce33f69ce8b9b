// The camera: a turntable about a target with z upward, in perspective or not, with the same framing.

import { Box3, Camera, Matrix4, Ray, Vector3 } from "three";

export interface Pose {
  target: [number, number, number];
  /** Degrees about z; 0 looks from +x. */
  azimuth: number;
  /** Degrees above the xy-plane. */
  elevation: number;
  /** Height of the picture at the target, in the document's unit. */
  height: number;
}

export type NamedView = "front" | "back" | "left" | "right" | "top" | "bottom" | "isometric";

/** Azimuth and elevation of the named views. The front is seen along +y. */
export const NAMED_VIEWS: Record<NamedView, [number, number]> = {
  front: [-90, 0],
  back: [90, 0],
  left: [180, 0],
  right: [0, 0],
  top: [-90, 90],
  bottom: [-90, -90],
  isometric: [-45, Math.atan(Math.SQRT1_2) * (180 / Math.PI)],
};

const HALF_FIELD = (14 * Math.PI) / 180;
const RADIANS = Math.PI / 180;
/** Space around the model when it is fitted. */
const MARGIN = 1.12;

export class Rig {
  readonly camera = new Camera();
  pose: Pose = { target: [0, 0, 0], azimuth: -52, elevation: 26, height: 10 };
  isOrthographic = false;
  /** Of the picture, in pixels. */
  width = 1;
  private pixels = 1;
  private readonly bounds = new Box3();

  resize(width: number, height: number): void {
    this.width = Math.max(1, width);
    this.pixels = Math.max(1, height);
  }

  /** Says what the near and the far plane must enclose. */
  enclose(bounds: Box3): void {
    this.bounds.copy(bounds);
  }

  /** Length in the document of one pixel at the target. */
  get perPixel(): number {
    return this.pose.height / this.pixels;
  }

  get distance(): number {
    return this.pose.height / (2 * Math.tan(HALF_FIELD));
  }

  /** Right, up and backward (toward the eye). */
  axes(): [Vector3, Vector3, Vector3] {
    const a = this.pose.azimuth * RADIANS;
    const e = this.pose.elevation * RADIANS;
    const back = new Vector3(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e));
    const right = new Vector3(-Math.sin(a), Math.cos(a), 0);
    return [right, new Vector3().crossVectors(back, right), back];
  }

  orbit(dx: number, dy: number): void {
    const { azimuth, elevation } = this.pose;
    this.pose = {
      ...this.pose,
      azimuth: ((((azimuth - dx + 180) % 360) + 360) % 360) - 180,
      elevation: Math.max(-90, Math.min(90, elevation + dy)),
    };
  }

  /** Moves the model by so many pixels. */
  pan(dx: number, dy: number): void {
    const [right, up] = this.axes();
    this.moveTarget(right.multiplyScalar(-dx * this.perPixel).add(up.multiplyScalar(dy * this.perPixel)));
  }

  /** Makes everything `factor` times as large about the pixel (x, y). */
  zoom(factor: number, x: number, y: number): void {
    const [right, up] = this.axes();
    const reach = (1 - 1 / factor) * this.perPixel;
    this.moveTarget(
      right.multiplyScalar((x - this.width / 2) * reach).add(up.multiplyScalar((this.pixels / 2 - y) * reach)),
    );
    this.pose = { ...this.pose, height: this.pose.height / factor };
  }

  /** The pose that shows all of a box from the present direction. */
  fitted(box: Box3, direction?: [number, number]): Pose {
    const [azimuth, elevation] = direction ?? [this.pose.azimuth, this.pose.elevation];
    const kept = this.pose;
    this.pose = { ...kept, azimuth, elevation };
    const [right, up, back] = this.axes();
    this.pose = kept;
    const centre = box.getCenter(new Vector3());
    const aspect = this.width / this.pixels;
    const tangent = Math.tan(HALF_FIELD);
    let height = 0;
    for (let i = 0; i < 8; i++) {
      const corner = new Vector3(
        i & 1 ? box.max.x : box.min.x,
        i & 2 ? box.max.y : box.min.y,
        i & 4 ? box.max.z : box.min.z,
      ).sub(centre);
      const toward = this.isOrthographic ? 0 : 2 * tangent * corner.dot(back);
      height = Math.max(
        height,
        2 * Math.abs(corner.dot(up)) + toward,
        (2 * Math.abs(corner.dot(right))) / aspect + toward,
      );
    }
    if (!(height > 0)) height = this.pose.height > 0 ? this.pose.height : 1;
    return { target: centre.toArray(), azimuth, elevation, height: height * MARGIN };
  }

  /** Brings the matrices up to date with the pose. */
  update(): void {
    const [right, up, back] = this.axes();
    const { camera, distance } = this;
    const target = new Vector3(...this.pose.target);
    const size = this.bounds.isEmpty() ? 0 : this.bounds.max.distanceTo(this.bounds.min);
    const centre = this.bounds.isEmpty() ? target : this.bounds.getCenter(new Vector3());
    const eye = target.clone().addScaledVector(back, distance);
    const depth = eye.clone().sub(centre).dot(back);
    const radius = Math.max(0.5 * size, 1e-9) * 1.3;
    const far = Math.max(depth + radius, distance + 2.5 * this.pose.height);
    const aspect = this.width / this.pixels;
    camera.matrixAutoUpdate = false;
    camera.matrix.makeBasis(right, up, back).setPosition(eye);
    camera.matrixWorld.copy(camera.matrix);
    camera.matrixWorldInverse.copy(camera.matrix).invert();
    const top = this.pose.height / 2;
    if (this.isOrthographic) {
      const near = Math.min(depth - radius, distance - 2.5 * this.pose.height);
      camera.projectionMatrix.copy(orthographic(top * aspect, top, near, far));
    } else {
      // Not nearer than the grid at the lower edge of the picture.
      const near = Math.max(Math.min(depth - radius, 0.2 * distance), Math.min(far, distance) * 0.02);
      camera.projectionMatrix.copy(perspective(top / distance, aspect, near, far));
    }
    camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
  }

  /** The ray through a pixel, and how far apart neighbouring rays are at the target. */
  ray(x: number, y: number): Ray {
    const [right, up, back] = this.axes();
    const place = new Vector3(...this.pose.target)
      .addScaledVector(right, (x - this.width / 2) * this.perPixel)
      .addScaledVector(up, (this.pixels / 2 - y) * this.perPixel);
    if (this.isOrthographic) {
      const reach = this.bounds.isEmpty() ? 1 : this.bounds.max.distanceTo(this.bounds.min);
      return new Ray(place.addScaledVector(back, this.distance + 2 * reach), back.negate());
    }
    const eye = new Vector3(...this.pose.target).addScaledVector(back, this.distance);
    return new Ray(eye, place.sub(eye).normalize());
  }

  /** Pixel of a point, with its depth from -1 to 1. */
  project(point: Vector3): Vector3 {
    const p = point.clone().applyMatrix4(this.camera.matrixWorldInverse).applyMatrix4(this.camera.projectionMatrix);
    return new Vector3(((p.x + 1) / 2) * this.width, ((1 - p.y) / 2) * this.pixels, p.z);
  }

  private moveTarget(by: Vector3): void {
    const [x, y, z] = this.pose.target;
    this.pose = { ...this.pose, target: [x + by.x, y + by.y, z + by.z] };
  }
}

function perspective(tangent: number, aspect: number, near: number, far: number): Matrix4 {
  const depth = far - near;
  return new Matrix4().set(
    1 / (tangent * aspect), 0, 0, 0,
    0, 1 / tangent, 0, 0,
    0, 0, -(far + near) / depth, (-2 * far * near) / depth,
    0, 0, -1, 0,
  );
}

function orthographic(right: number, top: number, near: number, far: number): Matrix4 {
  const depth = far - near;
  return new Matrix4().set(
    1 / right, 0, 0, 0,
    0, 1 / top, 0, 0,
    0, 0, -2 / depth, -(far + near) / depth,
    0, 0, 0, 1,
  );
}
