// SPDX-License-Identifier: Apache-2.0
//
// Memory of the current CUDA device, and errors of CUDA as exceptions.

#pragma once

#include <cuda_runtime.h>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace gpu_check {

/// Throws std::runtime_error if `status` is an error.
inline void require(cudaError_t status, const char* what) {
    if (status == cudaSuccess) return;
    throw std::runtime_error(std::string(what) + ": " + cudaGetErrorString(status));
}

/// Waits for the kernels that were started, and throws if one failed.
inline void finish() {
    require(cudaGetLastError(), "cannot start a kernel");
    require(cudaDeviceSynchronize(), "a kernel failed");
}

/// An array on the device, not initialized.
template <typename T>
class DeviceArray {
public:
    explicit DeviceArray(std::size_t size) : size_(size) {
        void* memory = nullptr;
        require(cudaMalloc(&memory, size * sizeof(T)), "no memory on the device");
        data_ = static_cast<T*>(memory);
    }
    ~DeviceArray() { cudaFree(data_); }
    DeviceArray(const DeviceArray&) = delete;
    DeviceArray& operator=(const DeviceArray&) = delete;

    T* data() const { return data_; }
    std::size_t size() const { return size_; }

    void copyFrom(const T* host) {
        require(cudaMemcpy(data_, host, size_ * sizeof(T), cudaMemcpyHostToDevice),
                "cannot copy to the device");
    }
    void copyTo(T* host) const {
        require(cudaMemcpy(host, data_, size_ * sizeof(T), cudaMemcpyDeviceToHost),
                "cannot copy from the device");
    }

private:
    T* data_;
    std::size_t size_;
};

} // namespace gpu_check
