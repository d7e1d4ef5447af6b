// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TYPES_TEMPORARY_HPP
#define ORO_TYPES_TEMPORARY_HPP

#include "TypeOps.hpp"

#include <cstddef>
#include <new>

namespace RTT {
namespace types {

/** A value of an erased type that has a default one. On the stack if it is small; otherwise allocates. */
class Temporary {
public:
    explicit Temporary(const TypeOps& ops)
        : ops_(ops), at_(isSmall() ? small_ : ::operator new(ops.size, std::align_val_t(ops.align))) {
        try {
            ops_.construct(at_);
        } catch (...) {
            release();
            throw;
        }
    }
    ~Temporary() {
        ops_.destroy(at_);
        release();
    }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;

    void* at() const { return at_; }

private:
    bool isSmall() const { return ops_.size <= sizeof small_ && ops_.align <= alignof(std::max_align_t); }
    void release() {
        if (at_ != small_) ::operator delete(at_, std::align_val_t(ops_.align));
    }

    alignas(std::max_align_t) unsigned char small_[256];
    const TypeOps& ops_;
    void* const at_;
};

}  // namespace types
}  // namespace RTT

#endif
