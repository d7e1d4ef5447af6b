// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Samples that show if they were torn, and what the stress tests share.
#ifndef OROFORGE_TESTS_FLOW_SAMPLES_HPP
#define OROFORGE_TESTS_FLOW_SAMPLES_HPP

#include <cstdint>
#include <string>
#include <vector>

namespace flow_test {

/** 64 bytes, plain: stored in atomic words where the storage can. */
struct Plain {
    std::uint64_t writer = 0, serial = 0, filler[5] = {}, sum = 0;
};

/** Not plain: stored by assignment. */
struct Deep {
    std::uint64_t writer = 0, serial = 0;
    std::vector<std::uint64_t> filler = std::vector<std::uint64_t>(5);
    std::uint64_t sum = 0;
};

template <class S>
void fill(S& sample, std::uint64_t writer, std::uint64_t serial) {
    sample.writer = writer;
    sample.serial = serial;
    sample.sum = writer * 31 + serial;
    for (std::size_t i = 0; i < 5; ++i) {
        sample.filler[i] = serial * (i + 7) ^ writer;
        sample.sum += sample.filler[i];
    }
}

template <class S>
bool intact(const S& sample) {
    std::uint64_t sum = sample.writer * 31 + sample.serial;
    for (std::size_t i = 0; i < 5; ++i) sum += sample.filler[i];
    return sum == sample.sum;
}

/** How many operations a stress test makes; more in ./dev stress. */
std::uint64_t stressCount(std::uint64_t normally);

}  // namespace flow_test

#endif
