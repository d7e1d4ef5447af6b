// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_TF_DETAIL_REPORTED_HPP
#define RTT_TF_DETAIL_REPORTED_HPP

#include <atomic>
#include <map>
#include <mutex>
#include <string>

namespace rtt_tf::detail {

/** What was logged already: a failure that repeats with every sample is logged once. Thread-safe. */
class Reported {
public:
    /** True if the subject did not have this reason, a single bit, since it worked last. At most 256 subjects are
        remembered; those that come after them are not new, so that bad data cannot fill the log. */
    bool isNew(const std::string& subject, unsigned reason);
    /** Its next failure is new. */
    void works(const std::string& subject);
    bool isEmpty() const { return isEmpty_.load(std::memory_order_relaxed); }
    void clear();

private:
    std::mutex mutex_;
    std::map<std::string, unsigned> reasons_;
    std::atomic<bool> isEmpty_{true};
};

}  // namespace rtt_tf::detail

#endif
