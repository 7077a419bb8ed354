// SPDX-License-Identifier: Apache-2.0
//
// Renders by WebGL2.

import wellstrat from "../../../include/wellstrat/shaders/wellstrat.glsl?raw";
import radiance from "./radiance.glsl?raw";
import {DeviceLost, sources, Unavailable, type Renderer, type Request} from "./renderer";
import {sceneVectors} from "./scene";

const tableWidth = 2048; // the least of what WebGL2's textures have at most

const vertexShader = `#version 300 es
void main() { gl_Position = vec4(ivec2(gl_VertexID & 1, gl_VertexID >> 1) * 4 - 1, 0, 1); }`;

const fragmentShader = `#version 300 es
precision highp float;
precision highp usampler2D;
uniform usampler2D tables;
#define WELLSTRAT_WORD(i) texelFetch(tables, ivec2(int((i) & 2047u), int((i) >> 11)), 0).x
#define SCENE_VECTORS ${sceneVectors}
${wellstrat}
${radiance}`;

function compiled(gl: WebGL2RenderingContext): WebGLProgram {
    const program = gl.createProgram();
    for (const [kind, text] of [
        [gl.VERTEX_SHADER, vertexShader],
        [gl.FRAGMENT_SHADER, fragmentShader],
    ] as const) {
        const shader = gl.createShader(kind)!;
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
        const said = [gl.getProgramInfoLog(program)];
        for (const shader of gl.getAttachedShaders(program) ?? []) {
            said.push(gl.getShaderInfoLog(shader));
        }
        throw new Unavailable(`This browser's WebGL2 refuses the shader: ${said.join(" ").trim()}`);
    }
    return program;
}

/** Whether the device is a program: what failIfMajorPerformanceCaveat finds, and more. */
function isOnProcessor(gl: WebGL2RenderingContext): boolean {
    const names = gl.getExtension("WEBGL_debug_renderer_info");
    const device = names ? String(gl.getParameter(names.UNMASKED_RENDERER_WEBGL)) : "";
    return /SwiftShader|llvmpipe|softpipe|Basic Render/.test(device);
}

function makeTexture(gl: WebGL2RenderingContext, format: number, width: number, height: number) {
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    return texture;
}

class WebGl2Renderer implements Renderer {
    readonly name = "WebGL2";
    private size = 0;
    private target: WebGLTexture | null = null;

    constructor(
        private readonly gl: WebGL2RenderingContext,
        private readonly program: WebGLProgram,
        private readonly tables: WebGLTexture,
    ) {
        gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    }

    async render({scene, size, source, first, count, seed}: Request): Promise<Float32Array> {
        const {gl, program} = this;
        if (size !== this.size) this.resize(size);
        gl.bindTexture(gl.TEXTURE_2D, this.tables);
        gl.useProgram(program);
        const numbers = {size, source: sources.indexOf(source), first, count, seed};
        for (const [name, value] of Object.entries(numbers)) {
            gl.uniform1ui(gl.getUniformLocation(program, name), value);
        }
        gl.uniform4fv(gl.getUniformLocation(program, "scene"), scene);
        gl.viewport(0, 0, size, size);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        const sums = new Uint32Array(4 * size * size);
        gl.readPixels(0, 0, size, size, gl.RGBA_INTEGER, gl.UNSIGNED_INT, sums);
        if (gl.isContextLost()) throw new DeviceLost();
        return new Float32Array(sums.buffer);
    }

    close(): void {
        this.gl.getExtension("WEBGL_lose_context")?.loseContext();
    }

    private resize(size: number): void {
        const {gl} = this;
        gl.deleteTexture(this.target);
        this.target = makeTexture(gl, gl.RGBA32UI, size, size);
        gl.framebufferTexture2D(
            gl.FRAMEBUFFER,
            gl.COLOR_ATTACHMENT0,
            gl.TEXTURE_2D,
            this.target,
            0,
        );
        this.size = size;
    }
}

/** As openWebGpu. */
export async function openWebGl2(tables: Uint32Array, evenSlow: boolean): Promise<Renderer> {
    const gl = document
        .createElement("canvas")
        .getContext("webgl2", {failIfMajorPerformanceCaveat: !evenSlow});
    if (!gl || (!evenSlow && isOnProcessor(gl))) {
        const what = evenSlow ? "WebGL2 here" : "graphics device for WebGL2";
        throw new Unavailable(`This browser has no ${what}.`);
    }
    const program = compiled(gl);
    const rows = Math.ceil(tables.length / tableWidth);
    const texture = makeTexture(gl, gl.R32UI, tableWidth, rows);
    const padded = new Uint32Array(tableWidth * rows);
    padded.set(tables);
    const [format, type] = [gl.RED_INTEGER, gl.UNSIGNED_INT];
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, tableWidth, rows, format, type, padded);
    if (gl.getError() !== gl.NO_ERROR) {
        throw new Unavailable("The tables do not fit into the memory of this WebGL2 device.");
    }
    return new WebGl2Renderer(gl, program, texture);
}
