// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/expected_channel.hpp>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <unistd.h>
#include <utility>
#include <vector>

namespace RTT::corba::detail {

namespace {

struct Expected {
    std::mutex mutex;  // guards all
    std::vector<const ExpectedChannel*> all;
    std::condition_variable left;
};

Expected& expected() {
    static auto* const expected = new Expected();  // never destroyed: threads of the ORB use it
    return *expected;
}

/** Another computer may have a process of the same number, but it gets the names of this one only for its own ports. */
std::string newName() {
    static std::atomic<unsigned> made{0};
    return "expected." + std::to_string(++made) + '@' + std::to_string(getpid());
}

}  // namespace

ExpectedChannel::ExpectedChannel(const base::PortInterface& input, const internal::ConnID& id,
                                 LostConnections::Ended ended, bool isStream)
    : input_(input),
      known_{std::shared_ptr<const internal::ConnID>(id.clone()), std::move(ended)},
      name_(isStream ? std::string() : newName()) {
    std::unique_lock<std::mutex> lock(expected().mutex);
    expected().left.wait(lock, [&] { return !isStream || !find(input, name_); });
    expected().all.push_back(this);
}

ExpectedChannel::~ExpectedChannel() {
    {
        const std::lock_guard<std::mutex> lock(expected().mutex);
        expected().all.erase(std::find(expected().all.begin(), expected().all.end(), this));
    }
    expected().left.notify_all();
}

const ExpectedChannel* ExpectedChannel::find(const base::PortInterface& input, const std::string& name) {
    for (const ExpectedChannel* const one : expected().all)
        if (&one->input_ == &input && one->name_ == name) return one;
    return nullptr;
}

ExpectedChannel::Known ExpectedChannel::of(const base::PortInterface& input, const std::string& name, bool isStream) {
    const std::lock_guard<std::mutex> lock(expected().mutex);
    const ExpectedChannel* const found = find(input, isStream ? std::string() : name);
    return found ? found->known_ : Known();
}

}  // namespace RTT::corba::detail
