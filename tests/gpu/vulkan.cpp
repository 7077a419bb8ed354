// SPDX-License-Identifier: Apache-2.0
//
// Asks the first device of Vulkan, which needs no screen, by the shader WELLSTRAT_ANSWER_SPIRV.

#include "asked_device.h"
#include "vulkan_buffer.h"

#include <fstream>
#include <iterator>

namespace gpu_check {
namespace {

constexpr uint32_t kBuffers = 3; // tables, questions, answers
constexpr uint32_t kLocalSize = 64;

std::vector<uint32_t> readShader() {
    std::ifstream file(WELLSTRAT_ANSWER_SPIRV, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    if (bytes.empty()) throw std::runtime_error("cannot read " WELLSTRAT_ANSWER_SPIRV);
    std::vector<uint32_t> words(bytes.size() / 4);
    std::memcpy(words.data(), bytes.data(), 4 * words.size());
    return words;
}

VkInstance makeInstance() {
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.apiVersion = VK_API_VERSION_1_1;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    VkInstance instance = VK_NULL_HANDLE;
    if (vkCreateInstance(&info, nullptr, &instance) != VK_SUCCESS) {
        throw NoDevice("Vulkan finds no driver");
    }
    return instance;
}

/// The first device of an instance, and its first queue that computes.
class VulkanDevice {
public:
    VulkanDevice() : instance_(makeInstance()) {
        uint32_t count = 1;
        vkEnumeratePhysicalDevices(instance_, &count, &physical);
        if (count == 0) throw NoDevice("Vulkan finds no device");
        const uint32_t family = computingFamily();
        const float priority = 1.0f;
        VkDeviceQueueCreateInfo queueInfo{};
        queueInfo.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
        queueInfo.queueFamilyIndex = family;
        queueInfo.queueCount = 1;
        queueInfo.pQueuePriorities = &priority;
        VkDeviceCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
        info.queueCreateInfoCount = 1;
        info.pQueueCreateInfos = &queueInfo;
        require(vkCreateDevice(physical, &info, nullptr, &device), "cannot open the device");
        vkGetDeviceQueue(device, family, 0, &queue);
        VkCommandPoolCreateInfo poolInfo{};
        poolInfo.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
        poolInfo.queueFamilyIndex = family;
        require(vkCreateCommandPool(device, &poolInfo, nullptr, &commands), "no commands");
    }
    ~VulkanDevice() {
        vkDestroyCommandPool(device, commands, nullptr);
        vkDestroyDevice(device, nullptr);
        vkDestroyInstance(instance_, nullptr);
    }
    VulkanDevice(const VulkanDevice&) = delete;
    VulkanDevice& operator=(const VulkanDevice&) = delete;

    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    VkCommandPool commands = VK_NULL_HANDLE;

private:
    uint32_t computingFamily() const {
        uint32_t count = 0;
        vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
        std::vector<VkQueueFamilyProperties> families(count);
        vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
        for (uint32_t i = 0; i < count; ++i) {
            if ((families[i].queueFlags & VK_QUEUE_COMPUTE_BIT) != 0) return i;
        }
        throw NoDevice("the device of Vulkan does not compute");
    }

    VkInstance instance_;
};

/// The shader with room for its three buffers.
class Pipeline {
public:
    explicit Pipeline(VkDevice device) : device_(device) {
        makeLayout();
        const std::vector<uint32_t> code = readShader();
        VkShaderModuleCreateInfo moduleInfo{};
        moduleInfo.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
        moduleInfo.codeSize = 4 * code.size();
        moduleInfo.pCode = code.data();
        VkShaderModule module = VK_NULL_HANDLE;
        require(vkCreateShaderModule(device, &moduleInfo, nullptr, &module), "no shader");
        VkComputePipelineCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
        info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
        info.stage.module = module;
        info.stage.pName = "main";
        info.layout = layout_;
        require(vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_),
                "the driver refuses the shader");
        vkDestroyShaderModule(device, module, nullptr);
        makeSet();
    }
    ~Pipeline() {
        vkDestroyPipeline(device_, pipeline_, nullptr);
        vkDestroyPipelineLayout(device_, layout_, nullptr);
        vkDestroyDescriptorPool(device_, pool_, nullptr);
        vkDestroyDescriptorSetLayout(device_, setLayout_, nullptr);
    }
    Pipeline(const Pipeline&) = delete;
    Pipeline& operator=(const Pipeline&) = delete;

    void setBuffer(uint32_t binding, VkBuffer buffer) const {
        const VkDescriptorBufferInfo whole{buffer, 0, VK_WHOLE_SIZE};
        VkWriteDescriptorSet write{};
        write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        write.dstSet = set_;
        write.dstBinding = binding;
        write.descriptorCount = 1;
        write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        write.pBufferInfo = &whole;
        vkUpdateDescriptorSets(device_, 1, &write, 0, nullptr);
    }

    void record(VkCommandBuffer commands, uint32_t groups) const {
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, 1, &set_, 0,
                                nullptr);
        vkCmdDispatch(commands, groups, 1, 1);
    }

private:
    void makeLayout() {
        VkDescriptorSetLayoutBinding bindings[kBuffers]{};
        for (uint32_t i = 0; i < kBuffers; ++i) {
            bindings[i].binding = i;
            bindings[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
            bindings[i].descriptorCount = 1;
            bindings[i].stageFlags = VK_SHADER_STAGE_COMPUTE_BIT;
        }
        VkDescriptorSetLayoutCreateInfo setInfo{};
        setInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
        setInfo.bindingCount = kBuffers;
        setInfo.pBindings = bindings;
        require(vkCreateDescriptorSetLayout(device_, &setInfo, nullptr, &setLayout_), "no layout");
        VkPipelineLayoutCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
        info.setLayoutCount = 1;
        info.pSetLayouts = &setLayout_;
        require(vkCreatePipelineLayout(device_, &info, nullptr, &layout_), "no layout");
    }
    void makeSet() {
        const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, kBuffers};
        VkDescriptorPoolCreateInfo poolInfo{};
        poolInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
        poolInfo.maxSets = 1;
        poolInfo.poolSizeCount = 1;
        poolInfo.pPoolSizes = &size;
        require(vkCreateDescriptorPool(device_, &poolInfo, nullptr, &pool_), "no descriptors");
        VkDescriptorSetAllocateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
        info.descriptorPool = pool_;
        info.descriptorSetCount = 1;
        info.pSetLayouts = &setLayout_;
        require(vkAllocateDescriptorSets(device_, &info, &set_), "no descriptors");
    }

    VkDevice device_;
    VkDescriptorSetLayout setLayout_ = VK_NULL_HANDLE;
    VkDescriptorPool pool_ = VK_NULL_HANDLE;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
};

class Vulkan final : public AskedDevice {
public:
    Vulkan() : pipeline_(vulkan_.device), tables_(buffer(sizeof(DeviceTables))) {
        wellstrat::copyDeviceTables(tables_.data(), wellstrat::DeviceDraws::all);
    }

    std::string name() const override {
        VkPhysicalDeviceProperties properties;
        vkGetPhysicalDeviceProperties(vulkan_.physical, &properties);
        return properties.deviceName;
    }

    std::vector<Answer> answers(const std::vector<Question>& questions) const override {
        std::vector<Answer> result(questions.size());
        const VulkanBuffer input = buffer(questions.size() * sizeof(Question));
        const VulkanBuffer output = buffer(result.size() * sizeof(Answer));
        std::memcpy(input.data(), questions.data(), questions.size() * sizeof(Question));
        pipeline_.setBuffer(0, tables_.buffer());
        pipeline_.setBuffer(1, input.buffer());
        pipeline_.setBuffer(2, output.buffer());
        run(static_cast<uint32_t>((questions.size() + kLocalSize - 1) / kLocalSize));
        std::memcpy(result.data(), output.data(), result.size() * sizeof(Answer));
        return result;
    }

private:
    VulkanBuffer buffer(std::size_t bytes) const {
        return VulkanBuffer(vulkan_.physical, vulkan_.device, bytes);
    }

    /// Runs groups of threads and waits for them.
    void run(uint32_t groups) const {
        VkCommandBufferAllocateInfo allocation{};
        allocation.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
        allocation.commandPool = vulkan_.commands;
        allocation.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
        allocation.commandBufferCount = 1;
        VkCommandBuffer commands = VK_NULL_HANDLE;
        require(vkAllocateCommandBuffers(vulkan_.device, &allocation, &commands), "no commands");
        VkCommandBufferBeginInfo begin{};
        begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
        begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
        require(vkBeginCommandBuffer(commands, &begin), "cannot record commands");
        pipeline_.record(commands, groups);
        require(vkEndCommandBuffer(commands), "cannot record commands");
        VkSubmitInfo submit{};
        submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
        submit.commandBufferCount = 1;
        submit.pCommandBuffers = &commands;
        require(vkQueueSubmit(vulkan_.queue, 1, &submit, VK_NULL_HANDLE), "cannot run the shader");
        require(vkQueueWaitIdle(vulkan_.queue), "the shader failed");
        vkFreeCommandBuffers(vulkan_.device, vulkan_.commands, 1, &commands);
    }

    VulkanDevice vulkan_;
    Pipeline pipeline_;
    VulkanBuffer tables_;
};

} // namespace

std::unique_ptr<Device> makeChecked() { return std::make_unique<Vulkan>(); }

} // namespace gpu_check
