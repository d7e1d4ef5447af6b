// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Measures the cycles of components while somebody asks.
#ifndef OROFORGE_LIVE_CYCLES_HPP
#define OROFORGE_LIVE_CYCLES_HPP

#include <cstdint>
#include <utility>
#include <vector>

namespace RTT::base {
class TaskCore;
}

namespace OCL::live {

/** What one component did in a while; times in ns. */
struct Cycles {
    std::int64_t count = 0;     ///< calls of updateHook()
    std::int64_t duration = 0;  ///< of all of them
    std::int64_t longest = 0;
    std::int64_t latest = 0;    ///< how much more than the period was between two of them, at most
    std::int64_t overruns = 0;  ///< how often that was a whole period or more
};

/**
 * Measures while it exists; several may at the same time. Hooks then take two readings of the clock and some relaxed
 * atomic operations, without a lock or memory, so they stay real-time safe; otherwise they pay nothing. The longest and
 * the latest cycle are those since the first of several measurements began.
 */
class Measurement {
public:
    /** Components with their periods in ns; 0: not periodic. At most 256 are measured. They may be destroyed. */
    explicit Measurement(const std::vector<std::pair<const RTT::base::TaskCore*, std::int64_t>>& components);
    ~Measurement();
    Measurement(const Measurement&) = delete;
    Measurement& operator=(const Measurement&) = delete;

    /** False if another tool, such as `deployer --rt-check`, watches the hooks: then nothing is measured. */
    bool works() const { return works_; }
    Cycles of(const RTT::base::TaskCore* component) const;

private:
    std::vector<std::pair<const RTT::base::TaskCore*, Cycles>> before_;
    bool works_ = false;
};

}  // namespace OCL::live

#endif
