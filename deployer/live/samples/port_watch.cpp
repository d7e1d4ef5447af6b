// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "port_watch.hpp"

#include "wall_time.hpp"

#include <rtt/internal/flow/connection_facts.hpp>
#include <rtt/internal/flow/storage_core.hpp>
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
    std::unique_ptr<RTT::base::PortInterface> clone(value ? port.antiClone() : nullptr);
    if (!clone || !clone->asInput()) {
        why = "its type '" + type->getTypeName() + "' cannot be copied";
        return nullptr;
    }
    (void)clone->setName(kName);
    std::unique_ptr<PortWatch> watch(new PortWatch(std::move(value)));
    watch->json_ = std::move(json);
    watch->plan_ = std::move(plan);
    watch->seat_ = std::move(seat);
    if (options.buffer == 0 && port.keepsLastWrittenValue()) {
        watch->link_ = std::make_unique<const RTT::internal::PortLink>(port);
        return watch;
    }
    watch->port_.reset(clone.release()->asInput());
    if (watch->connect(port, options)) return watch;
    why = "it takes no further connection; the log says why";
    return nullptr;
}

bool PortWatch::connect(RTT::base::OutputPortInterface& port, const Options& options) {
    begin_ = wallTime();
    if (!connectOnce(port, 0)) return false;
    unsigned buffer = options.buffer;
    if (buffer == 0) return true;
    // A buffer has its samples from the beginning, so their size must be known before.
    std::string first;
    if (read(first)) {
        const auto room = static_cast<unsigned>(kMostMemory / (first.size() + 1));
        buffer = std::clamp(room, 1U, buffer);  // a data connection would not count what it drops
    }
    port_->disconnect();
    begin_ = wallTime();
    if (!connectOnce(port, buffer)) return false;
    times_ = options.times && storage_ && storage_->storageCore()->store().keepTimes();
    return true;
}

bool PortWatch::connectOnce(RTT::base::OutputPortInterface& port, unsigned buffer) {
    if (!port.createConnection(*port_, policyFor(buffer))) return false;
    // What a connection of its own kind, of a class derived from OutputPort, is made of is not known.
    const auto storages = RTT::internal::storagesOf(*port_);
    storage_ = storages.size() == 1 ? storages[0] : nullptr;
    return true;
}

PortWatch::PortWatch(RTT::base::DataSourceBase::shared_ptr value)
    : value_(std::move(value)), address_(value_->getRawPointer()), type_(value_->getTypeInfo()->getTypeName()) {}

PortWatch::~PortWatch() = default;

std::int64_t PortWatch::time() const {
    if (!times_) return wallTime();
    // Those that have no time were written before it was kept: the last one before this watch, or one as it began.
    return written_ != 0 ? written_ : begin_;
}

bool PortWatch::take() {
    if (link_) return link_->newest(address_, seen_);
    if (storage_) return storage_->storageCore()->store().readTimed(address_, written_) == RTT::NewData;
    return RTT::internal::PortLink(*port_).read(address_) == RTT::NewData;
}

bool PortWatch::read(std::string& encoded) {
    if (!take()) return false;
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

std::uint64_t PortWatch::dropped() const { return storage_ ? storage_->storageCore()->store().dropped() : 0; }

}  // namespace OCL::live
