// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_OS_DETAIL_POOL_REGISTRY_HPP
#define RTT_OS_DETAIL_POOL_REGISTRY_HPP

#include <rtt/os/memory_pool.hpp>

#include <atomic>

namespace RTT {
namespace os {
namespace detail {

/**
 * The pools of the process: from which one to allocate, and to which one a block belongs. A look-up does not block; the
 * number of areas is bounded. It is a constant-initialised static that is never destroyed, because static strings may
 * allocate before main() and free after it.
 */
class PoolRegistry {
public:
    static PoolRegistry& instance() noexcept;

    /** The pool from which to allocate; made of kDefaultSize bytes if there is none. Null if that is impossible. */
    MemoryPool* current() noexcept;
    /** The pool that was made of this memory, or null. */
    MemoryPool* madeOf(const void* memory) const noexcept;
    /** Releases a block of any pool. */
    void release(void* block) noexcept;
    /** The pool of a block; null if it was destroyed. Ends the process if there never was one. */
    MemoryPool* ownerOf(const void* block) const noexcept;

    std::size_t create(void* memory, std::size_t size) noexcept;
    std::size_t extend(void* memory, void* area, std::size_t size) noexcept;
    void destroy(void* memory) noexcept;

private:
    static constexpr std::size_t kDefaultSize = 512 * 1024;
    static constexpr unsigned kMaxAreas = 64;

    struct Area {
        std::atomic<const char*> begin{nullptr};
        std::atomic<const char*> end{nullptr};
        std::atomic<MemoryPool*> pool{nullptr};  // null: destroyed
        std::atomic<bool> first{false};          // the area that the pool was made of
    };
    bool hasRoom(const void* memory) const noexcept;
    void enter(MemoryPool* pool, const void* memory, std::size_t size, bool first) noexcept;
    MemoryPool* makeDefault() noexcept;

    pthread_mutex_t changes_ = PTHREAD_MUTEX_INITIALIZER;  // held for changes
    std::atomic<MemoryPool*> current_{nullptr};
    MemoryPool* default_ = nullptr;
    std::atomic<unsigned> count_{0};
    Area areas_[kMaxAreas];
};

}  // namespace detail
}  // namespace os
}  // namespace RTT
#endif
