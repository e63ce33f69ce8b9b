// Puts a scene onto the canvas: smoothly, or quickly where the renderer is slow and the picture will change again.
//
// Smooth edges take a buffer of their own, and not the canvas's, which could not be drawn without them.

import { type Camera, LinearSRGBColorSpace, type Scene, WebGLRenderer, WebGLRenderTarget } from "three";

import { shared } from "./paint";

/** Places of each pixel at which a smooth frame is drawn. */
const SAMPLES = 4;
/** Milliseconds that a frame may take: one that takes longer waits until nothing changes. */
const LONG = 40;
/** What is so much faster than it need be may be finer. */
const MARGIN = 5;
/** Share of the canvas's width that a quick frame has where one of the whole width is slow. */
const COARSE = 0.5;
/** How many times as long as a smooth frame takes nothing changes before one is drawn: it would come between others. */
const REST = 5;
/** Milliseconds between two looks whether a frame has been drawn. */
const LOOK = 4;
/** Renderers without a graphics processor. */
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;

/** Where a frame is drawn before it comes onto the canvas. */
interface Buffer {
  framebuffer: WebGLFramebuffer;
  parts: WebGLRenderbuffer[];
  target: WebGLRenderTarget;
}

export class Painter {
  /** Whether smooth frames take long. */
  isSlow: boolean;
  private readonly renderer: WebGLRenderer;
  private readonly gl: WebGL2RenderingContext;
  private readonly buffers = new Map<string, Buffer>();
  private share = 1;
  private isMeasuring = false;
  /** Milliseconds that the last smooth frame took. */
  private smoothTime = LONG;

  constructor(private readonly canvas: HTMLCanvasElement) {
    const renderer = new WebGLRenderer({ canvas, antialias: false, alpha: true, stencil: true, powerPreference: "high-performance" });
    this.renderer = renderer;
    this.gl = renderer.getContext() as WebGL2RenderingContext;
    renderer.localClippingEnabled = true;
    // Asking whether a program was made waits until it is.
    renderer.debug.checkShaderErrors = false;
    // The shaders write what is shown; so a program fits the canvas and buffers.
    renderer.outputColorSpace = LinearSRGBColorSpace;
    renderer.setClearColor(0, 0);
    const names = this.gl.getExtension("WEBGL_debug_renderer_info");
    this.isSlow = SOFTWARE.test(String(this.gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : this.gl.RENDERER)));
  }

  get pixelRatio(): number {
    return this.renderer.getPixelRatio();
  }

  /** Milliseconds for which nothing changes before a smooth frame follows a quick one. */
  get rest(): number {
    return REST * this.smoothTime;
  }

  resize(width: number, height: number): void {
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    for (const name of [...this.buffers.keys()]) this.drop(name);
  }

  /** Draws a frame, a quick one where it need not be smooth. */
  draw(scene: Scene, camera: Camera, isQuick: boolean): void {
    const start = performance.now();
    const share = isQuick ? this.share : 1;
    shared.dots.value = share;
    if (isQuick && share === 1) {
      this.renderer.render(scene, camera);
    } else {
      const { target, framebuffer } = isQuick ? this.buffer("coarse", share, 0) : this.buffer("smooth", 1, SAMPLES);
      this.renderer.setRenderTarget(target);
      this.renderer.render(scene, camera);
      this.renderer.setRenderTarget(null);
      this.show(framebuffer, target, share);
    }
    this.measure(start, isQuick);
  }

  /** A pixel of the frame that was drawn this moment; waits until it is there. */
  read(x: number, y: number): number[] {
    const { gl } = this;
    const bytes = new Uint8Array(4);
    gl.readPixels(x, y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return [...bytes];
  }

  /** Copies a buffer onto the canvas. */
  private show(framebuffer: WebGLFramebuffer, { width, height }: WebGLRenderTarget, share: number): void {
    const { gl, canvas } = this;
    const { state } = this.renderer;
    state.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer);
    state.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
    gl.blitFramebuffer(0, 0, width, height, 0, 0, canvas.width, canvas.height, gl.COLOR_BUFFER_BIT, share === 1 ? gl.NEAREST : gl.LINEAR);
    state.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
  }

  private buffer(name: string, share: number, samples: number): Buffer {
    const known = this.buffers.get(name);
    if (known) return known;
    const { gl, canvas } = this;
    const [width, height] = [canvas.width, canvas.height].map((length) => Math.max(1, Math.round(share * length)));
    const framebuffer = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    const part = (format: number, place: number): WebGLRenderbuffer => {
      const made = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, made);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, width, height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, made);
      return made;
    };
    const parts = [part(gl.RGBA8, gl.COLOR_ATTACHMENT0), part(gl.DEPTH24_STENCIL8, gl.DEPTH_STENCIL_ATTACHMENT)];
    gl.bindRenderbuffer(gl.RENDERBUFFER, null);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    this.renderer.state.reset();
    const target = new WebGLRenderTarget(width, height);
    (this.renderer as unknown as { setRenderTargetFramebuffer(target: WebGLRenderTarget, framebuffer: WebGLFramebuffer): void }).setRenderTargetFramebuffer(target, framebuffer);
    const buffer = { framebuffer, parts, target };
    this.buffers.set(name, buffer);
    return buffer;
  }

  private drop(name: string): void {
    const buffer = this.buffers.get(name);
    if (!buffer) return;
    this.buffers.delete(name);
    this.gl.deleteFramebuffer(buffer.framebuffer);
    for (const part of buffer.parts) this.gl.deleteRenderbuffer(part);
  }

  /** Learns, without waiting for it, how long a frame takes that was handed over this moment. */
  private measure(start: number, isQuick: boolean): void {
    if (this.isMeasuring) return;
    const { gl } = this;
    const drawn = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!drawn) return;
    this.isMeasuring = true;
    gl.flush();
    const look = (): void => {
      if (gl.getSyncParameter(drawn, gl.SYNC_STATUS) !== gl.SIGNALED && !gl.isContextLost()) return void setTimeout(look, LOOK);
      gl.deleteSync(drawn);
      this.isMeasuring = false;
      this.learn(performance.now() - start, isQuick);
    };
    setTimeout(look, LOOK);
  }

  private learn(time: number, isQuick: boolean): void {
    if (!isQuick) {
      this.smoothTime = time;
      this.isSlow = time > (this.isSlow ? LONG / MARGIN : LONG);
    } else if (this.share === 1 && time > LONG) this.share = COARSE;
    else if (this.share < 1 && time < LONG / MARGIN) this.share = 1;
  }
}
