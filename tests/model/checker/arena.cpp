// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Memory of scenarios. It comes from one block that is taken back as a whole when a run ends, so a run can be abandoned
// anywhere; within a run nothing is used twice, so that every use of freed memory is seen.
#include <model/checker/internal.hpp>

#include <cstdlib>
#include <cstring>
#include <new>

namespace model {

bool inScenario = false;

namespace {

constexpr std::size_t kSize = std::size_t(1) << 20, kGrain = 16;
constexpr unsigned char kLive = 1, kFreed = 2;
alignas(64) unsigned char arena[kSize];
unsigned char state[kSize / kGrain];  // of each grain
std::size_t used = 0, live = 0;

struct Head {
    std::size_t size;
    bool freed;
};
static_assert(sizeof(Head) == kGrain, "stands in front of each block");

std::size_t grainOf(const void* at) { return (static_cast<const unsigned char*>(at) - arena) / kGrain; }
bool inArena(const void* at) { return at >= arena && at < arena + kSize; }

void* take(std::size_t size, std::size_t align) {
    const std::size_t begin = (used + sizeof(Head) + align - 1) / align * align;
    const std::size_t rounded = (std::max<std::size_t>(size, 1) + kGrain - 1) / kGrain * kGrain;
    if (begin + rounded > kSize) {
        const Outside outside;
        fail("the scenario needs too much memory");
    }
    new (arena + begin - sizeof(Head)) Head{rounded, false};
    std::memset(state + begin / kGrain, kLive, rounded / kGrain);
    used = begin + rounded;
    ++live;
    return arena + begin;
}

void give(void* block) {
    Head& head = *reinterpret_cast<Head*>(static_cast<unsigned char*>(block) - sizeof(Head));
    if (head.freed) {
        if (!inScenario) return;
        const Outside outside;
        fail("memory is freed twice");
    }
    head.freed = true;
    std::memset(state + grainOf(block), kFreed, head.size / kGrain);
    --live;
}

void* allocate(std::size_t size, std::size_t align) {
    if (inScenario) return take(size, std::max(align, kGrain));
    void* block = std::aligned_alloc(align, (std::max<std::size_t>(size, 1) + align - 1) / align * align);
    if (!block) throw std::bad_alloc();
    return block;
}

void release(void* block) noexcept {
    if (block && inArena(block))
        give(block);
    else
        std::free(block);
}

}  // namespace

void resetArena() {
    std::memset(state, 0, used / kGrain + 1);
    used = live = 0;
}

bool isLive(const void* at) { return !inArena(at) || state[grainOf(at)] == kLive; }

std::size_t liveBlocks() { return live; }

}  // namespace model

void* operator new(std::size_t size) { return model::allocate(size, 16); }
void* operator new[](std::size_t size) { return model::allocate(size, 16); }
void* operator new(std::size_t size, std::align_val_t align) {
    return model::allocate(size, static_cast<std::size_t>(align));
}
void* operator new[](std::size_t size, std::align_val_t align) {
    return model::allocate(size, static_cast<std::size_t>(align));
}
void operator delete(void* block) noexcept { model::release(block); }
void operator delete[](void* block) noexcept { model::release(block); }
void operator delete(void* block, std::size_t) noexcept { model::release(block); }
void operator delete[](void* block, std::size_t) noexcept { model::release(block); }
void operator delete(void* block, std::align_val_t) noexcept { model::release(block); }
void operator delete[](void* block, std::align_val_t) noexcept { model::release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { model::release(block); }
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept { model::release(block); }
