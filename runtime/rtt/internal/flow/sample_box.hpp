// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Owned samples of a type that is known only by its TypeOps.
#ifndef ORO_INTERNAL_SAMPLE_BOX_HPP
#define ORO_INTERNAL_SAMPLE_BOX_HPP

#include <rtt/rtt-config.h>
#include <rtt/types/TypeOps.hpp>

#include <cstddef>
#include <cstring>

namespace RTT {
namespace internal {

/** Assigns one sample to another. The branches save the indirect call for plain types. */
inline void assignSample(const types::TypeOps& ops, void* to, const void* from) {
    if (!ops.trivial)
        ops.assign(to, from);
    else if (ops.size == sizeof(double))
        std::memcpy(to, from, sizeof(double));
    else
        std::memcpy(to, from, ops.size);
}

/** A fixed number of samples in one block, each with room for a header. Not thread-safe by itself. */
class RTT_API SampleArray {
public:
    /** Constructs all samples as copies of `first`, or as default values if that is null (then ops.construct must
        exist). Leaves `header` unconstructed bytes in front of each sample. Slots begin at multiples of `spacing`
        bytes, a power of two, and of the type's own alignment. */
    SampleArray(const types::TypeOps& ops, std::size_t count, const void* first, std::size_t header = 0,
                std::size_t spacing = 1);
    ~SampleArray();
    SampleArray(const SampleArray&) = delete;
    SampleArray& operator=(const SampleArray&) = delete;

    const types::TypeOps& ops() const { return ops_; }
    std::size_t count() const { return count_; }
    void* sample(std::size_t i) const { return block_ + i * stride_ + offset_; }
    void* header(std::size_t i) const { return block_ + i * stride_; }

private:
    const types::TypeOps& ops_;
    std::size_t count_ = 0, stride_, offset_, alignment_;
    unsigned char* block_;
};

/** One sample, constant after construction. */
class SampleBox {
public:
    SampleBox(const types::TypeOps& ops, const void* from) : samples_(ops, 1, from) {}
    const void* get() const { return samples_.sample(0); }
    const types::TypeOps& ops() const { return samples_.ops(); }

private:
    SampleArray samples_;
};

}  // namespace internal
}  // namespace RTT

#endif
