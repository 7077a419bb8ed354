// SPDX-License-Identifier: Apache-2.0
//
// Asks the first device of OpenCL, by the kernel in shaders/answer.cl.

#define CL_TARGET_OPENCL_VERSION 120

#include "asked_device.h"

#include <CL/cl.h>

#include <type_traits>

namespace gpu_check {
namespace {

constexpr const char* kOptions =
    "-Werror -I" WELLSTRAT_SOURCES "/include -I" WELLSTRAT_SOURCES "/tests/gpu/shaders";
constexpr const char* kSource = "#include \"answer.cl\"\n";

/// Throws std::runtime_error if `status` is an error.
void require(cl_int status, const char* what) {
    if (status == CL_SUCCESS) return;
    throw std::runtime_error(std::string(what) + ": OpenCL says " + std::to_string(status));
}

template <typename Handle, cl_int (*release)(Handle)>
struct Releaser {
    void operator()(Handle handle) const { release(handle); }
};
/// Owns an object of OpenCL.
template <typename Handle, cl_int (*release)(Handle)>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Releaser<Handle, release>>;
using Context = Owned<cl_context, clReleaseContext>;
using Queue = Owned<cl_command_queue, clReleaseCommandQueue>;
using Buffer = Owned<cl_mem, clReleaseMemObject>;
using Program = Owned<cl_program, clReleaseProgram>;
using Kernel = Owned<cl_kernel, clReleaseKernel>;

cl_device_id firstDevice() {
    cl_platform_id platform = nullptr;
    cl_uint count = 0;
    if (clGetPlatformIDs(1, &platform, &count) != CL_SUCCESS || count == 0) {
        throw NoDevice("OpenCL finds no driver");
    }
    cl_device_id device = nullptr;
    if (clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 1, &device, nullptr) != CL_SUCCESS) {
        throw NoDevice("OpenCL finds no device");
    }
    return device;
}

class OpenCl final : public AskedDevice {
public:
    OpenCl() : device_(firstDevice()) {
        cl_int status = CL_SUCCESS;
        context_.reset(clCreateContext(nullptr, 1, &device_, nullptr, nullptr, &status));
        require(status, "cannot open the device");
        queue_.reset(clCreateCommandQueue(context_.get(), device_, 0, &status));
        require(status, "no queue");
        build();
        const auto tables = std::make_unique<DeviceTables>();
        wellstrat::copyDeviceTables(tables.get(), wellstrat::DeviceDraws::all);
        tables_ = buffer(sizeof(DeviceTables), tables.get());
    }

    std::string name() const override {
        char name[256] = {};
        clGetDeviceInfo(device_, CL_DEVICE_NAME, sizeof name - 1, name, nullptr);
        return name;
    }

    std::vector<Answer> answers(const std::vector<Question>& questions) const override {
        std::vector<Answer> result(questions.size());
        const Buffer input = buffer(questions.size() * sizeof(Question), questions.data());
        const Buffer output = buffer(result.size() * sizeof(Answer), result.data());
        cl_mem arguments[] = {tables_.get(), input.get(), output.get()};
        for (cl_uint i = 0; i < 3; ++i) {
            require(clSetKernelArg(kernel_.get(), i, sizeof arguments[i], &arguments[i]),
                    "wrong argument");
        }
        const std::size_t count = questions.size();
        require(clEnqueueNDRangeKernel(queue_.get(), kernel_.get(), 1, nullptr, &count, nullptr, 0,
                                       nullptr, nullptr),
                "cannot run the kernel");
        require(clEnqueueReadBuffer(queue_.get(), output.get(), CL_TRUE, 0,
                                    result.size() * sizeof(Answer), result.data(), 0, nullptr,
                                    nullptr),
                "the kernel failed");
        return result;
    }

private:
    void build() {
        cl_int status = CL_SUCCESS;
        const char* source = kSource;
        program_.reset(clCreateProgramWithSource(context_.get(), 1, &source, nullptr, &status));
        require(status, "no program");
        status = clBuildProgram(program_.get(), 1, &device_, kOptions, nullptr, nullptr);
        if (status != CL_SUCCESS) {
            std::string log(1 << 16, '\0');
            clGetProgramBuildInfo(program_.get(), device_, CL_PROGRAM_BUILD_LOG, log.size(),
                                  log.data(), nullptr);
            throw std::runtime_error("the driver refuses the kernel:\n" + log);
        }
        kernel_.reset(clCreateKernel(program_.get(), "answerAll", &status));
        require(status, "no kernel");
    }

    /// A buffer that begins as a copy of the host's data.
    Buffer buffer(std::size_t bytes, const void* data) const {
        cl_int status = CL_SUCCESS;
        Buffer result(clCreateBuffer(context_.get(), CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR,
                                     bytes, const_cast<void*>(data), &status));
        require(status, "no memory on the device");
        return result;
    }

    cl_device_id device_;
    Context context_;
    Queue queue_;
    Program program_;
    Kernel kernel_;
    Buffer tables_;
};

} // namespace

std::unique_ptr<Device> makeChecked() { return std::make_unique<OpenCl>(); }

} // namespace gpu_check
