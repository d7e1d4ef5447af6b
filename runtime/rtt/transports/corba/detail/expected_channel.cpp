// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/expected_channel.hpp>

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

namespace RTT::corba::detail {

namespace {

std::mutex mutex;  // guards what expected() returns

std::vector<const ExpectedChannel*>& expected() {
    static auto* const all = new std::vector<const ExpectedChannel*>();  // never destroyed: threads of the ORB use it
    return *all;
}

}  // namespace

ExpectedChannel::ExpectedChannel(const base::PortInterface& input, const internal::ConnID& id,
                                 LostConnections::Ended ended)
    : input_(input), known_{std::shared_ptr<const internal::ConnID>(id.clone()), std::move(ended)} {
    const std::lock_guard<std::mutex> lock(mutex);
    expected().push_back(this);
}

ExpectedChannel::~ExpectedChannel() {
    const std::lock_guard<std::mutex> lock(mutex);
    expected().erase(std::find(expected().begin(), expected().end(), this));
}

ExpectedChannel::Known ExpectedChannel::of(const base::PortInterface& input) {
    const std::lock_guard<std::mutex> lock(mutex);
    for (const ExpectedChannel* const one : expected())
        if (&one->input_ == &input) return one->known_;
    return {};
}

}  // namespace RTT::corba::detail
