// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/mqueue/MQTransporter.hpp>

#include <rtt/DataFlowInterface.hpp>
#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/base/PortInterface.hpp>
#include <rtt/transports/mqueue/detail/receive_channel.hpp>
#include <rtt/transports/mqueue/detail/send_channel.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <algorithm>
#include <atomic>
#include <unistd.h>
#include <utility>

namespace RTT::mqueue {

namespace {

using detail::Queue;
typedef base::ChannelElementBase::shared_ptr ElementPtr;

constexpr long kMessages = 10;     // the limit of a system that nobody has changed
constexpr long kLeastRoom = 1024;  // bytes, for samples of any size of which nothing is known

std::string describe(const base::PortInterface& port, bool isSender) {
    return (isSender ? "output port " : "input port ") + port.getFullName() + " of type " +
           port.getTypeInfo()->getTypeName();
}

bool isQueueName(const std::string& name) {
    return name.size() > 1 && name[0] == '/' && name.find('/', 1) == std::string::npos;
}

/** A name that this process has not made before; empty if the port belongs to no component. */
std::string newName(const base::PortInterface& port) {
    const DataFlowInterface* const interface = port.getInterface();
    if (!interface || !interface->getOwner()) return {};
    static std::atomic<unsigned> made{0};  // one port may have several streams
    std::string name = port.getFullName() + '.' + std::to_string(++made) + '@' + std::to_string(getpid());
    std::replace(name.begin(), name.end(), '/', '_');
    return '/' + name;
}

/** The bytes of a message. A program of the original counts on those of the largest sample, if that is known. */
long bytesFor(const MessageFormat& format, long sampleSize, long wanted) {
    if (format.hasFixedSize() || (format.isOfOriginal() && wanted > sampleSize)) return std::max(sampleSize, wanted);
    return std::max({sampleSize, wanted, kLeastRoom});
}

/** A queue of a new name. */
std::unique_ptr<Queue> makeQueue(const base::PortInterface& port, std::string& name, Queue::Size size,
                                 std::string& why) {
    for (;;) {
        name = newName(port);
        if (name.empty()) {
            why =
                "policy.name_id is empty, and the name of a queue is made from that of the component, but the port "
                "belongs to none";
            return nullptr;
        }
        auto queue = Queue::make(name, size, why);
        if (queue || !why.empty()) return queue;
        // A process of the same number has left it.
    }
}

/** The queue of that name. Null, with the reason in `why`, if samples do not get through it. */
std::unique_ptr<Queue> openQueue(const std::string& name, Queue::Size size, long least, std::string& why) {
    auto queue = Queue::open(name, size, why);
    if (!queue || queue->size().bytes >= least) return queue;
    why = "it exists already, with messages of " + std::to_string(queue->size().bytes) + " bytes, and a sample needs " +
          std::to_string(least) + "; choose another name, or remove /dev/mqueue" + name + " if nobody uses it";
    return nullptr;
}

}  // namespace

ElementPtr MQTransporter::createStream(base::PortInterface* port, const ConnPolicy& policy, bool is_sender) const {
    const Logger::In in("MQueue");
    const std::string described = describe(*port, is_sender);
    const auto refused = [&](const std::string& why) {
        log(Error) << described << ": queue '" << policy.name_id << "' cannot be used: " << why << endlog();
        return nullptr;
    };
    if (!isQueueName(policy.name_id) && !(is_sender && policy.name_id.empty()))
        return refused("the names of message queues begin with '/' and have no other '/'");
    std::string why;
    std::unique_ptr<MessageFormat> format = makeFormat(*port->getTypeInfo(), why);
    if (!format) return refused(why);
    const base::DataSourceBase::shared_ptr sample = port->getTypeInfo()->buildValue();
    if (!sample || !sample->getRawPointer()) return refused("its type has no default value");

    const bool isBuffer = policy.type == ConnPolicy::BUFFER;
    if (!is_sender)
        return new detail::ReceiveChannel(policy.name_id, std::move(format), sample, isBuffer && policy.size > 0,
                                          described);

    const auto sampleSize = static_cast<long>(format->sizeOf(sample->getRawConstPointer()));
    const long messages = policy.size > 0 ? policy.size : kMessages;
    const Queue::Size size{isBuffer ? messages : std::max(messages, 2L),
                           bytesFor(*format, sampleSize, policy.data_size)};
    auto queue = policy.name_id.empty()
                     ? makeQueue(*port, policy.name_id, size, why)
                     : openQueue(policy.name_id, size, std::max<long>(sampleSize, policy.data_size), why);
    if (!queue) return refused(why);
    policy.data_size = static_cast<int>(queue->size().bytes);
    return new detail::SendChannel(std::move(queue), std::move(format), isBuffer, described);
}

}  // namespace RTT::mqueue
