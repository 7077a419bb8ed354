// SPDX-License-Identifier: Apache-2.0
//
// Memory that a Vulkan device and the host share, and errors of Vulkan as exceptions.

#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

namespace gpu_check {

/// Throws std::runtime_error if `result` is an error.
inline void require(VkResult result, const char* what) {
    if (result == VK_SUCCESS) return;
    throw std::runtime_error(std::string(what) + ": Vulkan says " + std::to_string(result));
}

/// A storage buffer that stays mapped.
class VulkanBuffer {
public:
    VulkanBuffer(VkPhysicalDevice physical, VkDevice device, std::size_t bytes) : device_(device) {
        VkBufferCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
        info.size = bytes;
        info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
        require(vkCreateBuffer(device, &info, nullptr, &buffer_), "no buffer");
        VkMemoryRequirements needs;
        vkGetBufferMemoryRequirements(device, buffer_, &needs);
        VkMemoryAllocateInfo allocation{};
        allocation.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
        allocation.allocationSize = needs.size;
        allocation.memoryTypeIndex = sharedMemory(physical, needs.memoryTypeBits);
        require(vkAllocateMemory(device, &allocation, nullptr, &memory_), "no memory");
        require(vkBindBufferMemory(device, buffer_, memory_, 0), "cannot bind memory");
        require(vkMapMemory(device, memory_, 0, VK_WHOLE_SIZE, 0, &data_), "cannot map memory");
    }
    ~VulkanBuffer() {
        vkDestroyBuffer(device_, buffer_, nullptr);
        vkFreeMemory(device_, memory_, nullptr);
    }
    VulkanBuffer(const VulkanBuffer&) = delete;
    VulkanBuffer& operator=(const VulkanBuffer&) = delete;

    VkBuffer buffer() const { return buffer_; }
    void* data() const { return data_; }

private:
    static uint32_t sharedMemory(VkPhysicalDevice physical, uint32_t allowed) {
        constexpr VkMemoryPropertyFlags kShared =
            VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
        VkPhysicalDeviceMemoryProperties memory;
        vkGetPhysicalDeviceMemoryProperties(physical, &memory);
        for (uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
            const bool shared = (memory.memoryTypes[i].propertyFlags & kShared) == kShared;
            if (shared && (allowed >> i & 1u) != 0) return i;
        }
        throw std::runtime_error("the device shares no memory with the host");
    }

    VkDevice device_;
    VkBuffer buffer_ = VK_NULL_HANDLE;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
    void* data_ = nullptr;
};

} // namespace gpu_check
