// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "poll_set.hpp"

#include <rtt/os/MutexLock.hpp>
#include <rtt/os/fosi.h>

#include <algorithm>
#include <cerrno>

namespace RTT::extras::detail {

namespace {
// How long it waits before it repeats a call that the system refused.
constexpr nsecs kPause = 100000000;
constexpr std::size_t kUsualNumber = 16;
}  // namespace

PollSet::PollSet() {
    watched_.reserve(kUsualNumber);
    polled_.reserve(kUsualNumber + 1);
    polled_.push_back(pollfd{-1, POLLIN, 0});
}

std::vector<PollSet::Watched>::const_iterator PollSet::find(int fd) const {
    return std::find_if(watched_.begin(), watched_.end(), [fd](const Watched& watched) { return watched.fd == fd; });
}

bool PollSet::add(int fd) {
    os::MutexLock lock(mutex_);
    if (find(fd) != watched_.end()) return false;
    watched_.push_back(Watched{fd, false});
    ++version_;
    return true;
}

bool PollSet::remove(int fd) {
    os::MutexLock lock(mutex_);
    const auto at = find(fd);
    if (at == watched_.end()) return false;
    watched_.erase(at);
    ++version_;
    return true;
}

void PollSet::clear() {
    os::MutexLock lock(mutex_);
    watched_.clear();
    ++version_;
}

bool PollSet::contains(int fd) const {
    os::MutexLock lock(mutex_);
    return find(fd) != watched_.end();
}

bool PollSet::isReady(int fd) const {
    os::MutexLock lock(mutex_);
    const auto at = find(fd);
    return at != watched_.end() && at->ready;
}

void PollSet::forgetReady() {
    os::MutexLock lock(mutex_);
    for (Watched& watched : watched_) watched.ready = false;
}

void PollSet::copyWatched() {
    os::MutexLock lock(mutex_);
    if (polledVersion_ == version_) return;
    polled_.resize(1);
    for (const Watched& watched : watched_) polled_.push_back(pollfd{watched.fd, POLLIN, 0});
    polledVersion_ = version_;
}

// Polls the first `count` of polled_. False, with errno, if the system refuses.
bool PollSet::pollUntil(std::size_t count, nsecs deadline) {
    TIME_SPEC remaining{};
    TIME_SPEC* untilOrForever = nullptr;
    if (deadline != InfiniteNSecs) {
        remaining = ticks2timespec(std::max<nsecs>(deadline - rtos_get_time_ns(), 0));
        untilOrForever = &remaining;
    }
    if (::ppoll(polled_.data(), count, untilOrForever, nullptr) >= 0) return true;
    for (std::size_t i = 0; i < count; ++i) polled_[i].revents = 0;
    return errno == EINTR;
}

PollResult PollSet::wait(int wakeFd, nsecs deadline) {
    PollResult result;
    polled_[0].fd = wakeFd;
    // A pause after a failure, so that a repeated failure does not use up a processor.
    if (failed_ && pollUntil(1, std::min(deadline, rtos_get_time_ns() + kPause)) && polled_[0].revents != 0) {
        result.woken = true;
        return result;
    }
    copyWatched();
    failed_ = !pollUntil(polled_.size(), deadline);
    if (failed_) result.error = errno;
    result.woken = polled_[0].revents != 0;
    noteResults(result);
    return result;
}

// Results for a set that was changed must not be used: a number may belong to another file by now, and the component
// would block when it reads. They are not lost, because the next poll finds them again.
void PollSet::noteResults(PollResult& result) {
    os::MutexLock lock(mutex_);
    result.changed = polledVersion_ != version_;
    if (result.changed) return;
    for (std::size_t i = 0; i < watched_.size(); ++i) {
        const short events = polled_[i + 1].revents;
        watched_[i].ready = (events & (POLLIN | POLLHUP | POLLERR)) != 0;
        result.ready = result.ready || watched_[i].ready;
        if (events & POLLNVAL) result.closed = watched_[i].fd;
    }
    if (result.closed < 0) return;
    watched_.erase(find(result.closed));
    ++version_;
}

}  // namespace RTT::extras::detail
