// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "memory.hpp"

#include "state.hpp"

#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/os/memory_pool.hpp>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>
#include <sys/mman.h>

namespace OCL::lua {

using RTT::os::detail::MemoryPool;

namespace {

/** Null if the system has none. The pages are there when this returns, so that their first use is not slow. */
void* reserve(std::size_t size) {
    void* const start = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_POPULATE, -1, 0);
    return start == MAP_FAILED ? nullptr : start;
}

}  // namespace

Memory::~Memory() = default;

void* Memory::allocate(void* memory, void* block, std::size_t before, std::size_t after) {
    return static_cast<Memory*>(memory)->resize(block, before, after);
}

void* SystemMemory::resize(void* block, std::size_t, std::size_t after) {
    if (after == 0) {
        std::free(block);
        return nullptr;
    }
    return std::realloc(block, after);
}

PoolMemory::PoolMemory(std::size_t size) : pool_(nullptr) {
    void* const start = reserve(size);
    if (start) areas_.push_back({start, size});
    pool_ = start ? MemoryPool::create(start, size) : nullptr;
    if (pool_) return;
    if (start) munmap(start, size);
    throw std::bad_alloc();
}

PoolMemory::~PoolMemory() {
    pool_->~MemoryPool();
    for (const Area& area : areas_) munmap(area.start, area.size);
}

void* PoolMemory::resize(void* block, std::size_t before, std::size_t after) {
    if (after == 0) {
        pool_->release(block);
        return nullptr;
    }
    void* const made = block ? pool_->resize(block, after) : pool_->allocate(after);
    // A smaller block fits into the old one, whatever the pool says.
    if (!made && block && after <= before) return block;
    if (traced)
        RTT::log(RTT::Debug) << "Lua asks for " << after << " bytes instead of " << (block ? before : 0)
                             << (made ? "" : ": no room") << RTT::endlog();
    if (!made) state->refused();
    if (!block || after > before) watch();
    return made;
}

void PoolMemory::watch() {
    if (!(warnAt > 0)) return;
    const MemoryPool::Usage now = pool_->usage();
    const bool above = static_cast<double>(now.used) > warnAt * static_cast<double>(now.total);
    if (above && !warned_)
        RTT::log(RTT::Warning) << "component '" << state->owner().getName() << "': " << now.used << " of " << now.total
                               << " bytes of Lua's pool are in use; tlsf_incmem(size) adds memory" << RTT::endlog();
    warned_ = above;
}

bool PoolMemory::grow(std::size_t size) {
    constexpr std::size_t kMost = std::size_t(1) << 40;
    void* const start = size > 0 && size < kMost ? reserve(size) : nullptr;
    if (!start) return false;
    if (pool_->addArea(start, size) == 0) {
        munmap(start, size);
        return false;
    }
    areas_.push_back({start, size});
    return true;
}

PoolMemory::Usage PoolMemory::usage() const {
    const MemoryPool::Usage now = pool_->usage();
    return {now.total, now.used, now.maxUsed};
}

}  // namespace OCL::lua
