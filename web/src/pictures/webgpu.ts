// SPDX-License-Identifier: Apache-2.0
//
// Renders by WebGPU.

import wellstrat from "../../../include/wellstrat/shaders/wellstrat.wgsl?raw";
import radiance from "./radiance.wgsl?raw";
import {DeviceLost, sources, Unavailable, type Renderer, type Request} from "./renderer";
import {sceneVectors} from "./scene";

const shader = wellstrat + radiance.replace("SCENE_VECTORS", String(sceneVectors));

async function openDevice(tableBytes: number, evenSlow: boolean): Promise<GPUDevice> {
    const adapter = await navigator.gpu?.requestAdapter();
    if (!adapter) throw new Unavailable("This browser has no WebGPU here.");
    if (adapter.info.isFallbackAdapter && !evenSlow) {
        throw new Unavailable("This browser has no graphics device for WebGPU.");
    }
    if (adapter.limits.maxStorageBufferBindingSize < tableBytes) {
        throw new Unavailable("The tables do not fit into a buffer of this WebGPU device.");
    }
    try {
        return await adapter.requestDevice();
    } catch {
        throw new Unavailable("This browser's WebGPU gives no device.");
    }
}

class WebGpuRenderer implements Renderer {
    readonly name = "WebGPU";
    private lost = false;
    private size = 0;
    private sums?: GPUBuffer;
    private read?: GPUBuffer;
    private readonly request: GPUBuffer;
    private readonly scene: GPUBuffer;

    constructor(
        private readonly device: GPUDevice,
        private readonly pipeline: GPUComputePipeline,
        private readonly tables: GPUBuffer,
    ) {
        const usage = GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST;
        this.request = device.createBuffer({size: 32, usage});
        this.scene = device.createBuffer({size: 16 * sceneVectors, usage});
        void device.lost.then(() => (this.lost = true));
    }

    async render(request: Request): Promise<Float32Array> {
        const {device} = this;
        const {size, first, count, seed} = request;
        const [sums, read] = this.buffersFor(size);
        const words = [size, sources.indexOf(request.source), first, count, seed];
        device.queue.writeBuffer(this.request, 0, new Uint32Array(words));
        device.queue.writeBuffer(this.scene, 0, request.scene as Float32Array<ArrayBuffer>);
        const commands = device.createCommandEncoder();
        const pass = commands.beginComputePass();
        pass.setPipeline(this.pipeline);
        const buffers = [this.tables, this.request, this.scene, sums];
        pass.setBindGroup(
            0,
            device.createBindGroup({
                layout: this.pipeline.getBindGroupLayout(0),
                entries: buffers.map((buffer, binding) => ({binding, resource: {buffer}})),
            }),
        );
        pass.dispatchWorkgroups(Math.ceil(size / 8), Math.ceil(size / 8));
        pass.end();
        commands.copyBufferToBuffer(sums, 0, read, 0, sums.size);
        device.queue.submit([commands.finish()]);
        try {
            await read.mapAsync(GPUMapMode.READ);
        } catch {
            this.lost = true; // nothing else unmaps or destroys it
        }
        if (this.lost) throw new DeviceLost();
        const result = new Float32Array(read.getMappedRange()).slice();
        read.unmap();
        return result;
    }

    close(): void {
        this.device.destroy();
    }

    private buffersFor(size: number): [GPUBuffer, GPUBuffer] {
        if (size !== this.size || !this.sums || !this.read) {
            this.sums?.destroy();
            this.read?.destroy();
            const make = (usage: GPUBufferUsageFlags) =>
                this.device.createBuffer({size: 16 * size * size, usage});
            this.sums = make(GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC);
            this.read = make(GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST);
            this.size = size;
        }
        return [this.sums, this.read];
    }
}

/**
 * `tables` are what 2D draws look up; `evenSlow` takes a device on the processor, too. Throws
 * Unavailable.
 */
export async function openWebGpu(tables: Uint32Array, evenSlow: boolean): Promise<Renderer> {
    const device = await openDevice(tables.byteLength, evenSlow);
    device.pushErrorScope("out-of-memory");
    const buffer = device.createBuffer({
        size: tables.byteLength,
        usage: GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST,
    });
    if (await device.popErrorScope()) {
        throw new Unavailable("The tables do not fit into the memory of this WebGPU device.");
    }
    device.queue.writeBuffer(buffer, 0, tables as Uint32Array<ArrayBuffer>);
    try {
        const module = device.createShaderModule({code: shader});
        const pipeline = await device.createComputePipelineAsync({
            layout: "auto",
            compute: {module, entryPoint: "render"},
        });
        return new WebGpuRenderer(device, pipeline, buffer);
    } catch (error) {
        throw new Unavailable(
            `This browser's WebGPU refuses the shader: ${(error as Error).message}`,
        );
    }
}
