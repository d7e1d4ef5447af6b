// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/detail/topic_writer.hpp>

#include <ros/names.h>
#include <ros/node_handle.h>
#include <rtt/Logger.hpp>
#include <rtt/base/PortInterface.hpp>
#include <rtt/internal/ConnFactory.hpp>
#include <rtt/internal/flow/sample_store.hpp>
#include <rtt/os/fosi.h>
#include <rtt/types/TypeInfo.hpp>
#include <rtt_roscomm/node_state.hpp>
#include <rtt_roscomm/detail/topic_name.hpp>
#include <rtt_roscomm/raw_message.hpp>

#include <algorithm>
#include <new>
#include <stdexcept>
#include <utility>

namespace rtt_roscomm::detail {

using RTT::ConnPolicy;
using RTT::WriteStatus;

namespace {

/** A publisher that takes longer than this delays the others. */
constexpr RTT::nsecs kSlow = 5 * 1000 * 1000;
constexpr std::chrono::milliseconds kPatience(2000);

}  // namespace

TopicWriter::Pointer TopicWriter::make(const RTT::base::PortInterface& port, const ConnPolicy& policy,
                                       std::shared_ptr<const MessageFormat> format, std::string& why) {
    if (!isNodeReady(why)) return nullptr;
    if (policy.name_id.empty()) policy.name_id = newTopicName(port);
    const Pointer made(new TopicWriter(port, std::move(format)));
    if (!made->makeStore(port, policy)) {
        why = "there is no storage for its samples";
        return nullptr;
    }
    if (!made->advertise(policy, why)) return nullptr;
    made->activity_.addUser();
    made->isOpen_ = true;
    made->show();
    return made;
}

TopicWriter::TopicWriter(const RTT::base::PortInterface& port, std::shared_ptr<const MessageFormat> format)
    : activity_(*RosPublishActivity::Instance()),
      format_(std::move(format)),
      described_(describe(port)),
      sample_(port.getTypeInfo()->buildValue()) {}

TopicWriter::~TopicWriter() = default;

bool TopicWriter::makeStore(const RTT::base::PortInterface& port, const ConnPolicy& policy) {
    if (policy.type == ConnPolicy::UNBUFFERED) return true;
    ConnPolicy own = policy;
    own.buffer_policy = RTT::PerConnection;
    store_ = RTT::internal::ConnFactory::makeStore(*port.getTypeInfo()->getOps(), own, sample_->getRawConstPointer());
    return store_ != nullptr;
}

bool TopicWriter::advertise(const ConnPolicy& policy, std::string& why) {
    ros::AdvertiseOptions options;
    options.queue_size = static_cast<std::uint32_t>(std::max(1, policy.size));
    options.md5sum = format_->md5();
    options.datatype = format_->message();
    options.message_definition = format_->definition();
    options.has_header = format_->hasHeader();
    options.latch = policy.init;
    const bool isFine = isDone(
        [&] {
            ros::NodeHandle node(namespaceOf(policy.name_id));
            options.topic = nameWithin(policy.name_id);
            publisher_ = node.advertise(options);
        },
        why);
    if (!isFine) return false;
    if (!publisher_) {
        if (isNodeReady(why)) why = whyRefused(ros::names::resolve(policy.name_id), *format_);
        return false;
    }
    topic_ = publisher_.getTopic();
    warnOfOtherType(described_, topic_, *format_);
    return true;
}

WriteStatus TopicWriter::write(const void* sample) {
    if (!store_) {
        const std::lock_guard<std::timed_mutex> lock(sending_);
        return !isClosed_ && send(sample) ? RTT::WriteSuccess : RTT::WriteFailure;
    }
    const WriteStatus status = store_->write(sample);
    activity_.publishSoon(*this);
    return status;
}

WriteStatus TopicWriter::setSample(const void* sample, bool reset) {
    if (!store_) return RTT::WriteSuccess;
    store_->setSample(sample, reset);
    const std::lock_guard<std::timed_mutex> lock(sending_);
    (void)sample_->assignValue(sample);
    return RTT::WriteSuccess;
}

void TopicWriter::publishDue() {
    if (!store_) return;
    {
        const std::lock_guard<std::mutex> lock(laneMutex_);
        if (lane_) {
            (void)lane_->trigger();
            return;
        }
    }
    const RTT::nsecs begin = rtos_get_time_ns();
    publishAll();
    if (rtos_get_time_ns() - begin >= kSlow) leaveTheOthers();
}

void TopicWriter::leaveTheOthers() {
    std::string why;
    std::unique_ptr<Lane> lane;
    // Without one, it delays the others as before.
    (void)isDone([&] { lane = std::make_unique<Lane>(static_cast<RosPublisher&>(*this)); }, why);
    const std::lock_guard<std::mutex> lock(laneMutex_);
    if (isClosed_) return;
    lane_ = std::move(lane);
    isSlow_ = true;
}

void TopicWriter::publish() { publishAll(); }

// As many as the store has room for: one that is written faster than it is sent must let the others have their turn.
void TopicWriter::publishAll() {
    const std::lock_guard<std::timed_mutex> lock(sending_);
    void* const sample = sample_->getRawPointer();
    for (std::size_t left = store_->capacity(); left != 0; --left) {
        if (isClosed_ || store_->read(sample, false) != RTT::NewData) return;
        (void)send(sample);
    }
    if (store_->size() != 0) activity_.publishSoon(*this);
}

bool TopicWriter::send(const void* sample) {
    std::size_t size = 0;
    const char* why = "a container in it is too large, or it has a value that the message cannot have";
    if (ros::isShuttingDown() || !publisher_) return false;
    try {
        if (format_->sizeOf(sample, size) && size <= kLargestMessage) {
            if (isSlow_) {
                // Roscpp has the message encoded with a lock that all topics of the process need.
                bytes_.resize(size);
                if (!format_->write(sample, bytes_.data(), size)) throw std::length_error(why);
                publisher_.publish(RawMessage{nullptr, bytes_.data(), size});
            } else {
                publisher_.publish(RawMessage{format_.get(), sample, size});
            }
            published_.fetch_add(1, std::memory_order_relaxed);
            complained_.store(false, std::memory_order_relaxed);
            return true;
        }
    } catch (const std::bad_alloc&) {
        why = "there is no memory for the message";
    } catch (...) {
        why = "its adapter throws, or the sample changed meanwhile";
    }
    if (!complained_.exchange(true))
        RTT::log(RTT::Error) << described_ << ": a sample does not get to topic " << topic_ << ": " << why
                             << RTT::endlog();
    return false;
}

void TopicWriter::close() {
    std::unique_ptr<Lane> lane;
    {
        const std::lock_guard<std::mutex> lock(laneMutex_);
        isClosed_ = true;
        if (!std::exchange(isOpen_, false)) return;
        lane = std::move(lane_);
    }
    hide();
    {
        // What is being sent is to be sent. Others who wait for roscpp are not waited for.
        const std::unique_lock<std::timed_mutex> lock(sending_, kPatience);
    }
    const Pointer self(this);
    endWithMaster([self] { self->publisher_.shutdown(); });
    if (lane) doWithin([kept = std::shared_ptr<Lane>(std::move(lane)), self] {}, kPatience);
    activity_.removeUser();
}

TopicState TopicWriter::state() const {
    return {topic_,
            format_->message(),
            described_,
            published_.load(std::memory_order_relaxed),
            store_ ? store_->dropped() : 0,
            publisher_.getNumSubscribers()};
}

}  // namespace rtt_roscomm::detail
