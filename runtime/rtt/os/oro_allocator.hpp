// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_ALLOCATOR_HPP
#define ORO_OS_ALLOCATOR_HPP

#include <rtt/os/oro_malloc.h>

#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>

namespace RTT {
namespace os {

/**
 * Lets standard containers keep their elements in real-time memory: `std::vector<int, RTT::os::rt_allocator<int>>`.
 * Any thread; real-time safe as <rtt/os/oro_malloc.h> says. Throws std::bad_alloc when the memory is used up.
 */
template <class T>
class rt_allocator {
public:
    typedef T value_type;
    typedef T* pointer;
    typedef const T* const_pointer;
    // void can be rebound to a type that has objects.
    typedef std::add_lvalue_reference_t<T> reference;
    typedef std::add_lvalue_reference_t<const T> const_reference;
    typedef std::size_t size_type;
    typedef std::ptrdiff_t difference_type;
    typedef std::true_type is_always_equal;
    typedef std::true_type propagate_on_container_move_assignment;
    template <class U>
    struct rebind {
        typedef rt_allocator<U> other;
    };

    rt_allocator() noexcept = default;
    template <class U>
    rt_allocator(const rt_allocator<U>&) noexcept {}

    T* allocate(std::size_t count, const void* = nullptr) {
        if (count > max_size()) throw std::bad_alloc();
        void* memory = nullptr;
        if constexpr (kOverAligned)
            memory = allocateAligned(count * sizeof(T));
        else
            memory = oro_rt_malloc(count * sizeof(T));
        if (!memory) throw std::bad_alloc();
        return static_cast<T*>(memory);
    }

    void deallocate(T* memory, std::size_t) noexcept {
        if constexpr (kOverAligned)
            oro_rt_free(memory ? reinterpret_cast<void**>(memory)[-1] : nullptr);
        else
            oro_rt_free(memory);
    }

    std::size_t max_size() const noexcept { return (PTRDIFF_MAX - 2 * alignof(T)) / sizeof(T); }

private:
    static constexpr bool kOverAligned = alignof(T) > 16;

    /** Stores the address of the block in the word before the objects. */
    static void* allocateAligned(std::size_t size) noexcept {
        void* const block = oro_rt_malloc(size + alignof(T));
        if (!block) return nullptr;
        // Blocks are aligned to 16 bytes, so there is room for the word whenever the next boundary is taken.
        const auto address = reinterpret_cast<std::uintptr_t>(block);
        void** const start = reinterpret_cast<void**>(address - address % alignof(T) + alignof(T));
        start[-1] = block;
        return start;
    }
};

template <class T, class U>
bool operator==(const rt_allocator<T>&, const rt_allocator<U>&) noexcept {
    return true;
}
template <class T, class U>
bool operator!=(const rt_allocator<T>&, const rt_allocator<U>&) noexcept {
    return false;
}

}  // namespace os
}  // namespace RTT
#endif
