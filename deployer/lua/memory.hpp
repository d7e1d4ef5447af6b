// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Where a Lua state has its memory from.
#ifndef OCL_LUA_MEMORY_HPP
#define OCL_LUA_MEMORY_HPP

#include <cstddef>
#include <vector>

namespace RTT::os::detail {
class MemoryPool;
}

namespace OCL::lua {

class State;

/** Only a thread that has entered the state calls it. */
class Memory {
public:
    virtual ~Memory();
    /** As realloc(); null if there is no room. Never fails for a block that shrinks. */
    virtual void* resize(void* block, std::size_t before, std::size_t after) = 0;

    /** For lua_newstate(), with a Memory as user data. */
    static void* allocate(void* memory, void* block, std::size_t before, std::size_t after);

    State* state = nullptr;  ///< which uses this memory
};

/** The memory of the process. */
class SystemMemory : public Memory {
public:
    void* resize(void* block, std::size_t before, std::size_t after) override;
};

/** Pools of a fixed size: constant time, and nothing from the system once they exist. */
class PoolMemory : public Memory {
public:
    struct Usage {
        std::size_t total, used, most;
    };

    /** Throws std::bad_alloc. */
    explicit PoolMemory(std::size_t size);
    ~PoolMemory() override;
    void* resize(void* block, std::size_t before, std::size_t after) override;

    /** Reserves more. False if the system has no more, or the size makes no sense. Any thread. */
    bool grow(std::size_t size);
    Usage usage() const;

    /** Writes each request to the log while on. */
    bool traced = false;
    /** A warning is logged once when this part of the pools is in use; 0 for never. */
    double warnAt = 0.9;

private:
    struct Area {
        void* start;
        std::size_t size;
    };
    void watch();

    std::vector<Area> areas_;
    RTT::os::detail::MemoryPool* pool_;
    bool warned_ = false;
};

}  // namespace OCL::lua

#endif
