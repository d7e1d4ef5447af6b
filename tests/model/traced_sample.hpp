// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A sample type whose copies the checker sees. To be included after checker/substitute.hpp.
#ifndef OROFORGE_MODEL_TRACED_SAMPLE_HPP
#define OROFORGE_MODEL_TRACED_SAMPLE_HPP

#include <model/checker/atomic.hpp>

#include <rtt/types/TypeOps.hpp>

namespace model {

struct TracedSample {
    TracedSample(int v = 0) : value(v) {}
    int get() const { return value; }
    Plain<int> value;
};

}  // namespace model

namespace RTT {
namespace types {

template <>
struct SampleExtent<model::TracedSample> {
    static std::size_t of(const model::TracedSample&) { return 0; }
};

}  // namespace types
}  // namespace RTT

#endif
