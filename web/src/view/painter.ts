// Puts a scene onto the canvas: smoothly, or quickly where the renderer is slow and the picture will change again.

import { type Camera, LinearSRGBColorSpace, type Object3D, type Scene, WebGLRenderer, WebGLRenderTarget } from "three";

import { DRAWING } from "../begun";
import { shared } from "./paint";
import { writeOutCorners } from "./segments";

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
/** Milliseconds after which one is drawn at the latest. */
const MOST_REST = 1500;
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
  /** Whether the last frame is a smooth one. */
  isSmooth = false;
  private readonly renderer: WebGLRenderer;
  private readonly gl: WebGL2RenderingContext;
  private smoothBuffer: Buffer | null = null;
  /** The size of the canvas on the page, and how many pixels a smooth frame has for one of the page. */
  private size = [1, 1];
  private ratio = 1;
  private share: number;
  private isMeasuring = false;
  /** How often the browser has taken what was made for drawing. */
  private n_losses = 0;
  /** Milliseconds that the last smooth frame took. */
  private smoothTime = LONG;

  constructor(private readonly canvas: HTMLCanvasElement) {
    const renderer = new WebGLRenderer({ canvas, ...DRAWING });
    this.renderer = renderer;
    this.gl = renderer.getContext() as WebGL2RenderingContext;
    renderer.localClippingEnabled = true;
    // Asking whether a program was made waits until it is.
    renderer.debug.checkShaderErrors = false;
    // The shaders write what is shown; so a program fits the canvas and buffers.
    renderer.outputColorSpace = LinearSRGBColorSpace;
    renderer.setClearColor(0, 0);
    canvas.addEventListener("webglcontextlost", () => {
      // Buffers and fences are gone with it.
      this.smoothBuffer = null;
      this.isMeasuring = false;
      this.n_losses++;
    });
    const names = this.gl.getExtension("WEBGL_debug_renderer_info");
    const isSoftware = SOFTWARE.test(String(this.gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : this.gl.RENDERER)));
    this.isSlow = isSoftware;
    writeOutCorners(isSoftware);
    this.share = this.isSlow ? COARSE : 1;
  }

  /** Pixels of a smooth frame for one of the page. */
  get pixelRatio(): number {
    return this.ratio;
  }

  /** Milliseconds for which nothing changes before a smooth frame follows a quick one. */
  get rest(): number {
    return Math.min(REST * this.smoothTime, MOST_REST);
  }

  /** Begins to make the programs of these, which are made while other things are done. */
  prepare(scene: Object3D, camera: Camera): void {
    this.renderer.compile(scene, camera);
  }

  resize(width: number, height: number): void {
    this.size = [width, height];
    this.ratio = Math.min(devicePixelRatio, 2);
    this.drop();
    // The next frame is a quick one where smooth ones take long.
    this.take(this.isSlow ? this.share : 1);
  }

  /** Gives the canvas a share of the pixels along each side, unless it has it: to take another size waits for the renderer. */
  private take(share: number): void {
    const [width, height] = this.size;
    const wanted = share * this.ratio;
    const isIt = ([length, now]: number[]): boolean => Math.floor(length * wanted) === now;
    if (this.renderer.getPixelRatio() === wanted && [[width, this.canvas.width], [height, this.canvas.height]].every(isIt)) return;
    this.renderer.setDrawingBufferSize(width, height, wanted);
  }

  /** Draws a frame, a quick one where it need not be smooth. */
  draw(scene: Scene, camera: Camera, isQuick: boolean): void {
    if (this.gl.isContextLost()) return;
    const start = performance.now();
    const n_programs = this.renderer.info.programs?.length;
    const share = isQuick ? this.share : 1;
    shared.dots.value = share;
    this.take(share);
    this.isSmooth = !isQuick;
    if (isQuick) {
      this.renderer.render(scene, camera);
    } else {
      const buffer = (this.smoothBuffer ??= this.buffer());
      this.renderer.setRenderTarget(buffer.target);
      this.renderer.render(scene, camera);
      this.renderer.setRenderTarget(null);
      this.show(buffer);
    }
    // A frame for which programs are made takes longer than others.
    if (n_programs === this.renderer.info.programs?.length) this.measure(start, isQuick);
  }

  /** A pixel of the frame that was drawn this moment; waits until it is there. */
  read(x: number, y: number): number[] {
    const { gl } = this;
    const bytes = new Uint8Array(4);
    gl.readPixels(x, y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return [...bytes];
  }

  /** Copies a buffer onto the canvas, which is as large. */
  private show({ framebuffer, target: { width, height } }: Buffer): void {
    const { gl } = this;
    const { state } = this.renderer;
    state.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer);
    state.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    state.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
  }

  private buffer(): Buffer {
    const { gl } = this;
    const { width, height } = this.canvas;
    const framebuffer = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    const part = (format: number, place: number): WebGLRenderbuffer => {
      const made = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, made);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, SAMPLES, format, width, height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, made);
      return made;
    };
    const parts = [part(gl.RGBA8, gl.COLOR_ATTACHMENT0), part(gl.DEPTH24_STENCIL8, gl.DEPTH_STENCIL_ATTACHMENT)];
    gl.bindRenderbuffer(gl.RENDERBUFFER, null);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    this.renderer.state.reset();
    const target = new WebGLRenderTarget(width, height);
    (this.renderer as unknown as { setRenderTargetFramebuffer(target: WebGLRenderTarget, framebuffer: WebGLFramebuffer): void }).setRenderTargetFramebuffer(target, framebuffer);
    return { framebuffer, parts, target };
  }

  private drop(): void {
    if (!this.smoothBuffer) return;
    this.gl.deleteFramebuffer(this.smoothBuffer.framebuffer);
    for (const part of this.smoothBuffer.parts) this.gl.deleteRenderbuffer(part);
    this.smoothBuffer = null;
  }

  /** Learns, without waiting for it, how long a frame takes that was handed over this moment. */
  private measure(start: number, isQuick: boolean): void {
    if (this.isMeasuring) return;
    const { gl } = this;
    const drawn = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!drawn) return;
    this.isMeasuring = true;
    gl.flush();
    const { n_losses } = this;
    const look = (): void => {
      if (n_losses !== this.n_losses) return;
      if (gl.getSyncParameter(drawn, gl.SYNC_STATUS) !== gl.SIGNALED) return void setTimeout(look, LOOK);
      gl.deleteSync(drawn);
      this.isMeasuring = false;
      this.learn(performance.now() - start, isQuick);
    };
    setTimeout(look, LOOK);
  }

  private learn(time: number, isQuick: boolean): void {
    if (!isQuick) {
      this.smoothTime = time;
      this.isSlow = time > (this.isSlow ? LONG / 2 : LONG);
    } else if (this.share === 1 && time > LONG) this.share = COARSE;
    else if (this.share < 1 && time < LONG / MARGIN) this.share = 1;
  }
}
