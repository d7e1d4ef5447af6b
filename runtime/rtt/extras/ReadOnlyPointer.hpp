// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXTRAS_READ_ONLY_POINTER_HPP
#define ORO_EXTRAS_READ_ONLY_POINTER_HPP

#include <atomic>
#include <memory>
#include <utility>

namespace RTT {
namespace extras {

/**
 * Shares a large value, such as an image, between components without copying it. All pointers to it may read it. To
 * write, call write_access(), which returns the value itself if there is no other pointer to it, and otherwise a copy.
 *
 * Different threads may use different pointers to one value, but not the same pointer at once. The last pointer deletes
 * the value, in its thread.
 */
template <class T>
class ReadOnlyPointer {
public:
    /** Takes ownership of the value, which must come from new. */
    ReadOnlyPointer(T* value = nullptr) { reset(value); }
    ReadOnlyPointer(const ReadOnlyPointer& other) noexcept : shared_(other.shared_) {
        if (shared_) shared_->owners.fetch_add(1, std::memory_order_relaxed);
    }
    ReadOnlyPointer& operator=(const ReadOnlyPointer& other) noexcept {
        ReadOnlyPointer(other).swap(*this);
        return *this;
    }
    ~ReadOnlyPointer() { drop(); }

    bool valid() const { return shared_ != nullptr; }
    /** Null if there is no value. */
    const T* get() const { return shared_ ? shared_->value.get() : nullptr; }
    const T& operator*() const { return *get(); }
    const T* operator->() const { return get(); }

    /** Takes ownership of another value, or of none. */
    void reset(T* value) {
        std::unique_ptr<T> owned(value);
        Shared* shared = owned ? new Shared{std::move(owned)} : nullptr;
        drop();
        shared_ = shared;
    }
    /** Shares the value of `other`. */
    void reset(ReadOnlyPointer& other) { *this = other; }
    void swap(ReadOnlyPointer& other) noexcept { std::swap(shared_, other.shared_); }

    /**
     * The value, or a copy of it if other pointers read it. The caller owns it and gives it back by reset(); meanwhile
     * this pointer has no value. Null if there is no value.
     */
    T* write_access() {
        if (T* value = try_write_access()) return value;
        if (!shared_) return nullptr;
        std::unique_ptr<T> copy(new T(*get()));
        drop();
        return copy.release();
    }
    /** Like write_access(), but if other pointers read the value, returns null and leaves this pointer unchanged. */
    T* try_write_access() {
        // No thread can copy this pointer meanwhile, so a single owner stays the only one.
        if (!shared_ || shared_->owners.load(std::memory_order_acquire) != 1) return nullptr;
        T* value = shared_->value.release();
        drop();
        return value;
    }

private:
    struct Shared {
        explicit Shared(std::unique_ptr<T> owned) : value(std::move(owned)) {}
        std::unique_ptr<T> value;
        std::atomic<unsigned int> owners{1};
    };
    void drop() noexcept {
        if (shared_ && shared_->owners.fetch_sub(1, std::memory_order_acq_rel) == 1) delete shared_;
        shared_ = nullptr;
    }
    Shared* shared_ = nullptr;
};

}  // namespace extras
}  // namespace RTT

#endif
