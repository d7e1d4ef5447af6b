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

/** Makes a name if there is none. False, with the reason in `why`, if it cannot be that of a queue. */
bool completeName(const base::PortInterface& port, std::string& name, std::string& why) {
    if (!name.empty()) {
        why = "the names of message queues begin with '/' and have no other '/', found '" + name + "'";
        return name[0] == '/' && name.size() > 1 && name.find('/', 1) == std::string::npos;
    }
    const DataFlowInterface* const interface = port.getInterface();
    if (!interface || !interface->getOwner()) {
        why =
            "policy.name_id is empty, and the name of a queue is made from that of the component, but the port belongs "
            "to none";
        return false;
    }
    static std::atomic<unsigned> made{0};  // one port may have several streams
    name = port.getFullName() + '.' + std::to_string(++made) + '@' + std::to_string(getpid());
    std::replace(name.begin(), name.end(), '/', '_');
    name.insert(0, 1, '/');
    return true;
}

/** The bytes of a message: as many as a sample has, or as the policy says. */
long bytesFor(const MessageFormat& format, const void* sample, int wanted) {
    const auto least = static_cast<long>(format.sizeOf(sample));
    if (format.hasFixedSize()) return std::max<long>(least, wanted);
    if (format.isOfOriginal() && wanted > least) return wanted;
    return std::max<long>({least, wanted, kLeastRoom});
}

/** Null, with the reason in `why`, if samples do not get through the queue. */
std::unique_ptr<Queue> openQueue(const std::string& name, bool isSender, Queue::Size size, long least,
                                 std::string& why) {
    auto queue = Queue::open(name, isSender ? Queue::Role::Sender : Queue::Role::Receiver, size, why);
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
    std::string why;
    if (!completeName(*port, policy.name_id, why)) return refused(why);
    std::unique_ptr<MessageFormat> format = makeFormat(*port->getTypeInfo(), why);
    if (!format) return refused(why);
    const base::DataSourceBase::shared_ptr sample = port->getTypeInfo()->buildValue();
    if (!sample || !sample->getRawPointer()) return refused("its type has no default value");

    const long bytes = bytesFor(*format, sample->getRawConstPointer(), policy.data_size);
    const long least = format->hasFixedSize() ? static_cast<long>(format->sizeOf(sample->getRawConstPointer())) : 1;
    auto queue = openQueue(policy.name_id, is_sender, {policy.size > 0 ? policy.size : kMessages, bytes}, least, why);
    if (!queue) return refused(why);
    policy.data_size = static_cast<int>(queue->size().bytes);
    if (!is_sender) return new detail::ReceiveChannel(std::move(queue), std::move(format), sample, described);
    return new detail::SendChannel(std::move(queue), std::move(format), policy.type == ConnPolicy::BUFFER, described);
}

}  // namespace RTT::mqueue
