// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// std::shared_ptr as far as the runtime uses it, with a reference count that the checker understands.
#ifndef OROFORGE_MODEL_SHARED_POINTER_HPP
#define OROFORGE_MODEL_SHARED_POINTER_HPP

#include <model/checker/atomic.hpp>

#include <cstddef>
#include <utility>

namespace model {

template <class T>
class SharedPointer {
    struct Block {
        template <class... A>
        explicit Block(A&&... arguments) : object(std::forward<A>(arguments)...) {}
        Count count;
        T object;
    };

public:
    SharedPointer() = default;
    SharedPointer(std::nullptr_t) {}
    SharedPointer(const SharedPointer& other) : block_(other.block_) {
        if (block_) block_->count.add();
    }
    SharedPointer(SharedPointer&& other) noexcept : block_(std::exchange(other.block_, nullptr)) {}
    ~SharedPointer() {
        if (block_ && block_->count.drop()) delete block_;
    }
    SharedPointer& operator=(SharedPointer other) {
        std::swap(block_, other.block_);
        return *this;
    }
    T* get() const { return block_ ? &block_->object : nullptr; }
    T& operator*() const { return block_->object; }
    T* operator->() const { return &block_->object; }
    explicit operator bool() const { return block_ != nullptr; }
    bool operator!=(std::nullptr_t) const { return block_ != nullptr; }
    void reset() { *this = SharedPointer(); }

    template <class... A>
    static SharedPointer make(A&&... arguments) {
        SharedPointer pointer;
        pointer.block_ = new Block(std::forward<A>(arguments)...);
        return pointer;
    }

private:
    Block* block_ = nullptr;
};

template <class T, class... A>
SharedPointer<T> makeShared(A&&... arguments) {
    return SharedPointer<T>::make(std::forward<A>(arguments)...);
}

}  // namespace model

#endif
