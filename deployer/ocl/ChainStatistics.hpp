// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a chain measures. All times in seconds.
#ifndef ORO_OCL_CHAIN_STATISTICS_HPP
#define ORO_OCL_CHAIN_STATISTICS_HPP

#include <boost/serialization/nvp.hpp>

#include <string>
#include <vector>

namespace OCL {

/** A series of times, all 0 before the first one. */
struct ChainTimes {
    unsigned count = 0;
    double last = 0, min = 0, mean = 0, max = 0;
    double p999 = 0;       ///< 99.9 % of them are not above it; within 4 %
    double deviation = 0;  ///< the standard deviation

    template <class Archive>
    void serialize(Archive& archive, unsigned) {
        using boost::serialization::make_nvp;
        archive& make_nvp("count", count);
        archive& make_nvp("last", last);
        archive& make_nvp("min", min);
        archive& make_nvp("mean", mean);
        archive& make_nvp("max", max);
        archive& make_nvp("p999", p999);
        archive& make_nvp("deviation", deviation);
    }
};

/** A member, from the start or the last resetStats() of its chain on. */
struct ChainMember {
    std::string name;
    ChainTimes times;       ///< of its cycles: messages, callbacks and hooks
    unsigned overruns = 0;  ///< cycles that took longer than its budget
    unsigned failures = 0;  ///< cycles that could not be executed, or ended in an exception
    unsigned left_out = 0;  ///< cycles in which it did not run, because it was stopped, gone or behind a failure

    template <class Archive>
    void serialize(Archive& archive, unsigned) {
        using boost::serialization::make_nvp;
        archive& make_nvp("name", name);
        archive& make_nvp("times", times);
        archive& make_nvp("overruns", overruns);
        archive& make_nvp("failures", failures);
        archive& make_nvp("left_out", left_out);
    }
};

struct ChainStatistics {
    unsigned iteration = 0;  ///< cycles since the start
    ChainTimes cycle;        ///< durations of the cycles
    ChainTimes jitter;       ///< how far the time between two begins was from the period; none if not periodic
    double utilisation = 0;  ///< mean duration of a cycle divided by the period; 0 if not periodic
    unsigned overruns = 0;   ///< cycles that took longer than the budget of the chain
    unsigned failures = 0;   ///< of all members
    std::vector<ChainMember> members;  ///< in their order

    template <class Archive>
    void serialize(Archive& archive, unsigned) {
        using boost::serialization::make_nvp;
        archive& make_nvp("iteration", iteration);
        archive& make_nvp("cycle", cycle);
        archive& make_nvp("jitter", jitter);
        archive& make_nvp("utilisation", utilisation);
        archive& make_nvp("overruns", overruns);
        archive& make_nvp("failures", failures);
        archive& make_nvp("members", members);
    }
};

}  // namespace OCL

#endif
