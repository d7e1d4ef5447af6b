// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "port_watch.hpp"

#include <rtt/internal/flow/connection_facts.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <algorithm>
#include <iterator>
#include <mutex>
#include <set>
#include <utility>

namespace OCL::live {
namespace {

using RTT::encoding::ByteOrder;

/** In front of each value: plain CDR in the order of this machine. */
constexpr char kCdrHead[4] = {0, RTT::encoding::kNativeOrder == ByteOrder::Little ? 1 : 0, 0, 0};
constexpr std::size_t kMostMemory = 8 * 1024 * 1024;
constexpr unsigned kMostOfOne = 4, kMostOfAll = 32;

RTT::ConnPolicy policyFor(unsigned buffer) {
    RTT::ConnPolicy policy =
        buffer == 0 ? RTT::ConnPolicy::data() : RTT::ConnPolicy::circularBuffer(static_cast<int>(buffer));
    policy.init = true;
    return policy;
}

}  // namespace

/** The place of a watch at its port, which is only compared. */
class PortWatch::Seat {
public:
    Seat(const void* port, std::uint64_t watcher) : key_(port, watcher) {
        const std::lock_guard<std::mutex> lock(mutex());
        if (taken().count(key_) >= kMostOfOne)
            why_ = "you watch it " + std::to_string(kMostOfOne) + " times already";
        else if (countAt(port) >= kMostOfAll)
            why_ = "it is watched " + std::to_string(kMostOfAll) + " times already";
        else
            taken().insert(key_);
    }
    ~Seat() {
        const std::lock_guard<std::mutex> lock(mutex());
        if (why_.empty()) taken().erase(taken().find(key_));
    }
    Seat(const Seat&) = delete;
    Seat& operator=(const Seat&) = delete;
    /** Empty if it is one. */
    const std::string& why() const { return why_; }

private:
    typedef std::pair<const void*, std::uint64_t> Key;
    static std::mutex& mutex() {
        static std::mutex guard;
        return guard;
    }
    static std::multiset<Key>& taken() {
        static auto* const all = new std::multiset<Key>();
        return *all;
    }
    static std::size_t countAt(const void* port) {
        const auto begin = taken().lower_bound({port, 0}), end = taken().upper_bound({port, UINT64_MAX});
        return static_cast<std::size_t>(std::distance(begin, end));
    }

    const Key key_;
    std::string why_;
};

std::unique_ptr<PortWatch> PortWatch::make(RTT::base::OutputPortInterface& port, const Options& options,
                                           std::string& why) {
    const RTT::types::TypeInfo* const type = port.getTypeInfo();
    if (!type || !port.isLocal()) {
        why = type ? "it is a port of another process" : "its type is unknown";
        return nullptr;
    }
    auto seat = std::make_unique<const Seat>(&port, options.watcher);
    why = seat->why();
    if (!why.empty()) return nullptr;
    std::shared_ptr<const RTT::encoding::Json> json;
    std::shared_ptr<const RTT::encoding::Plan> plan;
    if (options.form == SampleForm::Json)
        json = RTT::encoding::Json::make(*type, why);
    else
        plan = RTT::encoding::Plan::make(*type, RTT::encoding::cdrRules(), why);
    if (!json && !plan) return nullptr;
    RTT::base::DataSourceBase::shared_ptr value = type->buildValue();
    auto* const clone =
        dynamic_cast<RTT::base::InputPortInterface*>(static_cast<RTT::base::PortInterface*>(port.antiClone()));
    if (!value || !clone) {
        why = "its type '" + type->getTypeName() + "' cannot be copied";
        return nullptr;
    }
    std::unique_ptr<RTT::base::InputPortInterface> own(clone);
    (void)own->setName(kName);
    std::unique_ptr<PortWatch> watch(new PortWatch(std::move(own), std::move(value)));
    watch->json_ = std::move(json);
    watch->plan_ = std::move(plan);
    watch->seat_ = std::move(seat);
    if (watch->connect(port, options.buffer)) return watch;
    why = "it takes no further connection; the log says why";
    return nullptr;
}

bool PortWatch::connect(RTT::base::OutputPortInterface& port, unsigned buffer) {
    if (!port.createConnection(*port_, policyFor(0))) return false;
    if (buffer == 0) return true;
    // A buffer has its samples from the beginning, so their size must be known before.
    if (read(first_)) {
        const auto room = static_cast<unsigned>(kMostMemory / (first_.size() + 1));
        buffer = std::clamp(room, 1U, buffer);  // a data connection would not count what it drops
    }
    port_->disconnect();
    first_.clear();
    return port.createConnection(*port_, policyFor(buffer));
}

PortWatch::PortWatch(std::unique_ptr<RTT::base::InputPortInterface> port, RTT::base::DataSourceBase::shared_ptr value)
    : port_(std::move(port)),
      link_(*port_),
      value_(std::move(value)),
      address_(value_->getRawPointer()),
      type_(value_->getTypeInfo()->getTypeName()) {}

PortWatch::~PortWatch() = default;

bool PortWatch::read(std::string& encoded) {
    if (!first_.empty()) {
        encoded = std::exchange(first_, std::string());
        return true;
    }
    if (link_.read(address_) != RTT::NewData) return false;
    if (json_) {
        encoded = json_->text(address_);
        return true;
    }
    const std::size_t size = plan_->sizeOf(address_);
    encoded.assign(kCdrHead, sizeof kCdrHead);
    encoded.resize(sizeof kCdrHead + size);
    if (size != 0 && plan_->encode(address_, &encoded[sizeof kCdrHead], size) != size) encoded.clear();
    return true;
}

std::uint64_t PortWatch::dropped() { return RTT::internal::droppedSamples(*port_); }

}  // namespace OCL::live
