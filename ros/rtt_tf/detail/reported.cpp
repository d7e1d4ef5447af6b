// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_tf/detail/reported.hpp>

namespace rtt_tf::detail {

namespace {

constexpr std::size_t kMost = 256;

}  // namespace

bool Reported::isNew(const std::string& subject, unsigned reason) {
    const std::lock_guard<std::mutex> lock(mutex_);
    auto found = reasons_.find(subject);
    if (found == reasons_.end()) {
        if (reasons_.size() == kMost) return false;
        found = reasons_.emplace(subject, 0).first;
        isEmpty_ = false;
    }
    const bool isNew = (found->second & reason) == 0;
    found->second |= reason;
    return isNew;
}

void Reported::works(const std::string& subject) {
    const std::lock_guard<std::mutex> lock(mutex_);
    reasons_.erase(subject);
    isEmpty_ = reasons_.empty();
}

void Reported::clear() {
    const std::lock_guard<std::mutex> lock(mutex_);
    reasons_.clear();
    isEmpty_ = true;
}

}  // namespace rtt_tf::detail
