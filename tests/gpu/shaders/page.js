// SPDX-License-Identifier: Apache-2.0
//
// Asks shaders in a browser, and tells the server of test_browser.py what they answered.

const WIDTH = 1024; // questions in a row

async function words(name) {
    return new Uint32Array(await (await fetch(name)).arrayBuffer());
}
async function text(name) {
    return (await fetch(name)).text();
}

function webgl(questions, tables, source) {
    const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
    if (!gl) return null;
    const program = gl.createProgram();
    const vertex = `#version 300 es
        void main() { gl_Position = vec4(ivec2(gl_VertexID & 1, gl_VertexID >> 1) * 4 - 1, 0, 1); }`;
    for (const [kind, code] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, source]]) {
        const shader = gl.createShader(kind);
        gl.shaderSource(shader, code);
        gl.compileShader(shader);
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) {
            throw new Error(gl.getShaderInfoLog(shader));
        }
        gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
        throw new Error(gl.getProgramInfoLog(program));
    }
    gl.useProgram(program);

    const texture = (unit, internal, format, width, height, data) => {
        gl.activeTexture(gl.TEXTURE0 + unit);
        const result = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, result);
        gl.texStorage2D(gl.TEXTURE_2D, 1, internal, width, height);
        if (data) {
            gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, format, gl.UNSIGNED_INT, data);
        }
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
        return result;
    };
    const padded = (data, size) => {
        const result = new Uint32Array(size);
        result.set(data);
        return result;
    };
    const height = Math.ceil(questions.length / 8 / WIDTH), rows = Math.ceil(tables.length / 2048);
    texture(0, gl.R32UI, gl.RED_INTEGER, 2048, rows, padded(tables, 2048 * rows));
    texture(1, gl.RGBA32UI, gl.RGBA_INTEGER, 2 * WIDTH, height,
            padded(questions, 8 * WIDTH * height));
    const answers = texture(2, gl.RGBA32UI, gl.RGBA_INTEGER, WIDTH, height, null);
    gl.uniform1i(gl.getUniformLocation(program, "tables"), 0);
    gl.uniform1i(gl.getUniformLocation(program, "questions"), 1);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, answers, 0);
    gl.viewport(0, 0, WIDTH, height);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const result = new Uint32Array(4 * WIDTH * height);
    gl.readPixels(0, 0, WIDTH, height, gl.RGBA_INTEGER, gl.UNSIGNED_INT, result);
    if (gl.getError() !== gl.NO_ERROR) throw new Error("WebGL failed");
    return result.subarray(0, questions.length / 2);
}

async function webgpu(questions, tables, source) {
    const adapter = navigator.gpu && await navigator.gpu.requestAdapter();
    if (!adapter) return null;
    const device = await adapter.requestDevice();
    const module = device.createShaderModule({code: source});
    for (const message of (await module.getCompilationInfo()).messages) {
        throw new Error(`${message.lineNum}: ${message.message}`);
    }
    const pipeline = await device.createComputePipelineAsync(
        {layout: "auto", compute: {module, entryPoint: "answerAll"}});
    const buffer = (size, usage) => device.createBuffer({size, usage});
    const uploaded = data => {
        const result = buffer(data.byteLength, GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST);
        device.queue.writeBuffer(result, 0, data);
        return result;
    };
    const bytes = 2 * questions.length;
    const answers = buffer(bytes, GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC);
    const read = buffer(bytes, GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST);
    const buffers = [uploaded(tables), uploaded(questions), answers];
    const commands = device.createCommandEncoder();
    const pass = commands.beginComputePass();
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, device.createBindGroup({
        layout: pipeline.getBindGroupLayout(0),
        entries: buffers.map((each, binding) => ({binding, resource: {buffer: each}})),
    }));
    pass.dispatchWorkgroups(Math.ceil(questions.length / 8 / 64));
    pass.end();
    commands.copyBufferToBuffer(answers, 0, read, 0, bytes);
    device.queue.submit([commands.finish()]);
    await read.mapAsync(GPUMapMode.READ);
    return new Uint32Array(read.getMappedRange());
}

async function check(ask, source) {
    const file = await words("questions"), count = file.length / 12;
    const questions = file.subarray(0, 8 * count), expected = file.subarray(8 * count);
    const answers = await ask(questions, await words("tables"), await text(source));
    if (!answers) return "no device";
    for (let i = 0; i < count; ++i) {
        const [got, wanted] = [answers, expected].map(a => a.slice(4 * i, 4 * i + 3).join());
        if (got !== wanted) {
            return `${questions.slice(8 * i, 8 * i + 6)} gives ${got}, not ${wanted}`;
        }
    }
    return `${count} agree`;
}

const how = {webgl: () => check(webgl, "answer.frag"), webgpu: () => check(webgpu, "answer.wgsl")};
how[location.hash.slice(1)]()
    .catch(error => `failed: ${error.message}`)
    .then(result => fetch("result", {method: "POST", body: result}));
