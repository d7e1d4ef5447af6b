// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/flow/sample_box.hpp>

#include <algorithm>

namespace RTT::internal {

namespace {
std::size_t roundUp(std::size_t n, std::size_t to) { return (n + to - 1) / to * to; }
}  // namespace

SampleArray::SampleArray(const types::TypeOps& ops, std::size_t count, const void* first, std::size_t header,
                         std::size_t spacing)
    : ops_(ops) {
    alignment_ = std::max({ops.align, spacing, alignof(std::max_align_t)});
    offset_ = roundUp(header, ops.align);
    stride_ = roundUp(offset_ + ops.size, std::max({ops.align, spacing, header != 0 ? alignof(std::max_align_t) : 1}));
    block_ = static_cast<unsigned char*>(
        ::operator new(std::max<std::size_t>(stride_ * count, 1), std::align_val_t(alignment_)));
    try {
        for (; count_ < count; ++count_) {
            if (first)
                ops.copyConstruct(sample(count_), first);
            else
                ops.construct(sample(count_));
        }
    } catch (...) {
        while (count_ > 0) ops_.destroy(sample(--count_));
        ::operator delete(block_, std::align_val_t(alignment_));
        throw;
    }
}

SampleArray::~SampleArray() {
    if (!ops_.trivial)
        for (std::size_t i = 0; i < count_; ++i) ops_.destroy(sample(i));
    ::operator delete(block_, std::align_val_t(alignment_));
}

}  // namespace RTT::internal
