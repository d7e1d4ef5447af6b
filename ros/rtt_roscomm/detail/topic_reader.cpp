// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/detail/topic_reader.hpp>

#include <ros/names.h>
#include <ros/node_handle.h>
#include <ros/subscription_callback_helper.h>
#include <rtt/Logger.hpp>
#include <rtt/base/DataSourceBase.hpp>
#include <rtt/base/PortInterface.hpp>
#include <rtt/internal/flow/reclaimer.hpp>
#include <rtt/os/fosi.h>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeOps.hpp>
#include <rtt_roscomm/node_state.hpp>
#include <rtt_roscomm/detail/topic_name.hpp>

#include <boost/make_shared.hpp>
#include <boost/smart_ptr/enable_shared_from_this.hpp>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <utility>

namespace rtt_roscomm::detail {

namespace {

constexpr RTT::nsecs kBetweenComplaints = 1000 * 1000 * 1000;
/** Of this thread: the receiver whose sample it is writing. */
thread_local const void* writing = nullptr;

}  // namespace

/** What roscpp calls for each message. Lives as long as roscpp has messages for it. */
class TopicReader::Receiver : public ros::SubscriptionCallbackHelper,
                              public boost::enable_shared_from_this<TopicReader::Receiver> {
public:
    Receiver(const RTT::types::TypeInfo& type, std::shared_ptr<const MessageFormat> format, std::string described)
        : ops_(*type.getOps()), format_(std::move(format)), described_(std::move(described)), first_(type.buildValue()) {}
    ~Receiver() override { discard(spare_.load()); }

    /** Holds the element until the next call. */
    void setTarget(RTT::base::ChannelElementBase* element, const std::string& topic) {
        Target before = element;
        const std::lock_guard<std::mutex> lock(mutex_);
        element_.swap(before);
        topic_ = topic;
    }
    bool isWriting() const { return writing == this; }
    std::uint64_t received() const { return received_.load(std::memory_order_relaxed); }
    std::uint64_t refused() const { return refused_.load(std::memory_order_relaxed); }

    // What roscpp keeps for one type is used by all that subscribe with it: this is the C++ type of the samples.
    const std::type_info& getTypeInfo() override { return *ops_.id; }
    bool isConst() override { return true; }
    bool hasHeader() override { return format_->hasHeader(); }

    ros::VoidConstPtr deserialize(const ros::SubscriptionCallbackHelperDeserializeParams& params) override {
        const boost::shared_ptr<void> sample = newSample();
        std::string why;
        if (format_->read(params.buffer, params.length, sample.get(), why)) return sample;
        refused_.fetch_add(1, std::memory_order_relaxed);
        const auto from = params.connection_header->find("callerid");
        complain("a message of " + std::to_string(params.length) + " bytes from " +
                     (from == params.connection_header->end() ? "a node" : from->second),
                 "it is no " + format_->message() + ": " + why);
        return {};
    }
    void call(ros::SubscriptionCallbackHelperCallParams& params) override {
        const boost::shared_ptr<void const> sample = params.event.getConstMessage();
        const Target element = target();
        if (!element) return;
        received_.fetch_add(1, std::memory_order_relaxed);
        const Writing now(*this);
        // An exception would end the process.
        try {
            const RTT::internal::Reclaimer::Guard guard;
            if (element->RTT::base::ChannelElementBase::writeErased(sample.get()) == RTT::WriteFailure)
                refused_.fetch_add(1, std::memory_order_relaxed);
        } catch (const std::exception& error) {
            refused_.fetch_add(1, std::memory_order_relaxed);
            complain("a message", error.what());
        }
    }

private:
    typedef RTT::base::ChannelElementBase::shared_ptr Target;
    class Writing {
    public:
        explicit Writing(const Receiver& receiver) : outer_(std::exchange(writing, &receiver)) {}
        ~Writing() { writing = outer_; }
        Writing(const Writing&) = delete;
        Writing& operator=(const Writing&) = delete;

    private:
        const void* const outer_;
    };
    Target target() {
        const std::lock_guard<std::mutex> lock(mutex_);
        return element_;
    }
    /** One sample is used again and again, with the memory that its containers have. */
    boost::shared_ptr<void> newSample() {
        void* sample = spare_.exchange(nullptr, std::memory_order_acquire);
        if (!sample) {
            sample = ::operator new(ops_.size, std::align_val_t(ops_.align));
            ops_.copyConstruct(sample, first_->getRawConstPointer());
        }
        const boost::shared_ptr<Receiver> self = shared_from_this();
        return boost::shared_ptr<void>(sample, [self](void* used) { self->giveBack(used); });
    }
    void giveBack(void* sample) { discard(spare_.exchange(sample, std::memory_order_acq_rel)); }
    void discard(void* sample) {
        if (!sample) return;
        ops_.destroy(sample);
        ::operator delete(sample, std::align_val_t(ops_.align));
    }
    void complain(const std::string& what, const std::string& why) {
        const RTT::nsecs now = rtos_get_time_ns();
        RTT::nsecs next = nextComplaint_.load();
        if (now < next || !nextComplaint_.compare_exchange_strong(next, now + kBetweenComplaints)) return;
        std::string topic;
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            topic = topic_;
        }
        RTT::log(RTT::Error) << described_ << ": " << what << " on topic " << topic << " is ignored: " << why
                             << RTT::endlog();
    }

    const RTT::types::TypeOps& ops_;
    const std::shared_ptr<const MessageFormat> format_;
    const std::string described_;
    const RTT::base::DataSourceBase::shared_ptr first_;
    std::atomic<void*> spare_{nullptr};
    std::atomic<std::uint64_t> received_{0}, refused_{0};
    std::atomic<RTT::nsecs> nextComplaint_{0};
    std::mutex mutex_;  // guards all below; held for moments only
    Target element_;
    std::string topic_;
};

TopicReader::TopicReader(const RTT::base::PortInterface& port, const RTT::ConnPolicy& policy,
                         std::shared_ptr<const MessageFormat> format)
    : format_(std::move(format)),
      described_(describe(port)),
      name_(policy.name_id),
      queueSize_(static_cast<std::uint32_t>(std::max(1, policy.size))),
      receiver_(boost::make_shared<Receiver>(*port.getTypeInfo(), format_, described_)) {}

TopicReader::~TopicReader() { close(); }

bool TopicReader::open(RTT::base::ChannelElementBase& element, std::string& why) {
    const std::lock_guard<std::mutex> lock(changing_);
    if (isOpen_) return true;
    if (!isNodeReady(why)) return false;
    const bool isFine = isDone(
        [&] {
            ros::NodeHandle node(namespaceOf(name_));
            ros::SubscribeOptions options(nameWithin(name_), queueSize_, format_->md5(), format_->message());
            receiver_->setTarget(&element, node.resolveName(options.topic));
            options.helper = receiver_;
            options.transport_hints = ros::TransportHints().tcpNoDelay();
            subscriber_ = node.subscribe(options);
        },
        why);
    if (!isFine || !subscriber_) {
        receiver_->setTarget(nullptr, name_);
        if (isFine && isNodeReady(why)) why = whyRefused(ros::names::resolve(name_), *format_);
        return false;
    }
    isOpen_ = true;
    topic_ = subscriber_.getTopic();
    warnOfOtherType(described_, topic_, *format_);
    show();
    return true;
}

void TopicReader::close() {
    const std::lock_guard<std::mutex> lock(changing_);
    if (!std::exchange(isOpen_, false)) return;
    hide();
    receiver_->setTarget(nullptr, topic_);
    const auto taken = std::make_shared<ros::Subscriber>(std::move(subscriber_));
    const auto end = [taken] { taken->shutdown(); };
    // roscpp waits for a callback that is executing, which may be the one that calls this.
    receiver_->isWriting() ? endWithMasterLater(end) : endWithMaster(end);
}

TopicState TopicReader::state() const {
    return {topic_,
            format_->message(),
            described_,
            receiver_->received(),
            receiver_->refused(),
            subscriber_.getNumPublishers()};
}

}  // namespace rtt_roscomm::detail
