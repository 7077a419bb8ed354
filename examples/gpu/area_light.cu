// SPDX-License-Identifier: Apache-2.0
//
// area_light FILE.ppm [SAMPLES]: renders the picture of ../area_light on the first GPU, 256 x 256
// pixels, and writes it. Then it renders it on the CPU by the same function, and says how many
// numbers of 8 bits differ. The samples are the same bits. What is computed of them by floats is
// not quite: CUDA has sines and cosines of its own, and nvcc fuses multiplications and additions.
// So some numbers are rounded to a neighbor, and now and then a ray just misses what it hit.
//
// Exit code 0, 1 if more than one number in 1000 differs, 2 if it cannot be tried. With HIP, the
// calls begin with hip instead of cuda.

#include "../area_light/srgb.h"
#include "pixel.h"
#include "wellstrat/device_tables.h"

#include <cuda_runtime.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using wellstrat::DeviceDraws;
using wellstrat::DeviceTables;

constexpr unsigned kSize = 256;
constexpr DeviceDraws kDraws = DeviceDraws::draws2D; // all that renderPixel draws

using Image = std::vector<RtFloat3>;

__global__ void renderRow(const DeviceTables* tables, unsigned samples, RtFloat3* image) {
    const unsigned x = threadIdx.x, y = blockIdx.x;
    image[y * kSize + x] = area_light::renderPixel(tables->words, kSize, x, y, samples);
}

void require(cudaError_t status) {
    if (status != cudaSuccess) throw std::runtime_error(cudaGetErrorString(status));
}

/// Copies what draws look up to the GPU, once for a program.
const DeviceTables* uploadTables() {
    const std::size_t size = wellstrat::deviceTableBytes(kDraws);
    std::vector<unsigned char> block(size);
    wellstrat::copyDeviceTables(block.data(), kDraws);
    void* memory = nullptr;
    require(cudaMalloc(&memory, size));
    require(cudaMemcpy(memory, block.data(), size, cudaMemcpyHostToDevice));
    return static_cast<const DeviceTables*>(memory);
}

Image renderOnGpu(unsigned samples) {
    const DeviceTables* const tables = uploadTables();
    Image image(kSize * kSize);
    RtFloat3* pixels = nullptr;
    require(cudaMalloc(&pixels, image.size() * sizeof(RtFloat3)));
    renderRow<<<kSize, kSize>>>(tables, samples, pixels);
    require(cudaGetLastError());
    require(
        cudaMemcpy(image.data(), pixels, image.size() * sizeof(RtFloat3), cudaMemcpyDeviceToHost));
    return image;
}

Image renderOnCpu(unsigned samples) {
    Image image;
    for (unsigned y = 0; y < kSize; ++y) {
        for (unsigned x = 0; x < kSize; ++x) {
            image.push_back(area_light::renderPixel(wellstrat::tables(), kSize, x, y, samples));
        }
    }
    return image;
}

std::vector<unsigned char> bytesOf(const Image& image) {
    std::vector<unsigned char> bytes;
    for (const RtFloat3& pixel : image) {
        for (const float channel : {pixel.x, pixel.y, pixel.z}) {
            bytes.push_back(area_light::encodeSrgb(channel));
        }
    }
    return bytes;
}

void writePpm(const std::string& path, const std::vector<unsigned char>& bytes) {
    std::FILE* const file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) throw std::runtime_error("cannot write '" + path + "'");
    std::fprintf(file, "P6\n%u %u\n255\n", kSize, kSize);
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    if (std::fclose(file) != 0 || !written) throw std::runtime_error("cannot write '" + path + "'");
}

int run(const std::string& path, unsigned samples) {
    const std::vector<unsigned char> gpu = bytesOf(renderOnGpu(samples));
    const std::vector<unsigned char> cpu = bytesOf(renderOnCpu(samples));
    writePpm(path, gpu);
    unsigned differing = 0;
    int most = 0;
    for (std::size_t i = 0; i < gpu.size(); ++i) {
        const int difference = std::abs(int{gpu[i]} - int{cpu[i]});
        differing += difference != 0;
        most = std::max(most, difference);
    }
    std::printf("%u of %zu numbers of 8 bits differ from the CPU's, by %d at most\n", differing,
                gpu.size(), most);
    return differing <= gpu.size() / 1000 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    const int samples = argc > 2 ? std::atoi(argv[2]) : 16;
    if (argc < 2 || argc > 3 || samples < 1 || samples > 4096) {
        std::fprintf(stderr, "usage: area_light FILE.ppm [SAMPLES], 1 to 4096\n");
        return 2;
    }
    try {
        return run(argv[1], static_cast<unsigned>(samples));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "area_light: %s\n", error.what());
        return 2;
    }
}
