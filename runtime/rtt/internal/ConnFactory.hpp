// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Makes connections and the elements in them.
#ifndef ORO_CONN_FACTORY_HPP
#define ORO_CONN_FACTORY_HPP

#include <rtt/ConnPolicy.hpp>
#include <rtt/internal/flow/channel_storage.hpp>
#include <rtt/internal/flow/sample_store.hpp>
#include <rtt/types/TypeOps.hpp>

#include <boost/shared_ptr.hpp>

#include <memory>
#include <string>

namespace RTT {
namespace base {
class InputPortInterface;
class OutputPortInterface;
class PortInterface;
}  // namespace base
namespace internal {
class ConnID;
class SharedConnectionBase;

/** The virtual functions are a type's port factory, for code that does not know the type. Nothing is real-time safe. */
class RTT_API ConnFactory {
public:
    typedef boost::shared_ptr<ConnFactory> shared_ptr;
    typedef base::ChannelElementBase::shared_ptr ElementPtr;

    virtual ~ConnFactory();
    virtual base::InputPortInterface* inputPort(const std::string& name) const = 0;
    virtual base::OutputPortInterface* outputPort(const std::string& name) const = 0;
    virtual ElementPtr buildDataStorage(ConnPolicy const& policy) const = 0;
    virtual ElementPtr buildChannelOutput(base::InputPortInterface& port, ConnPolicy const& policy) const;
    virtual ElementPtr buildChannelInput(base::OutputPortInterface& port, ConnPolicy const& policy) const;

    /** A storage for samples of the size of `initial_value`; null, with an error logged, if the policy is invalid. */
    template <typename T>
    [[gnu::cold]] static typename base::ChannelElement<T>::shared_ptr buildDataStorage(ConnPolicy const& policy,
                                                                                       const T& initial_value = T()) {
        return buildStorage<T>(policy, &initial_value);
    }
    template <typename T>
    [[gnu::cold]] static typename base::ChannelElement<T>::shared_ptr buildStorage(ConnPolicy const& policy,
                                                                                   const void* first) {
        auto* const made = new ChannelStorage<T>(policy, first);
        const typename base::ChannelElement<T>::shared_ptr held(made);
        return made->core() ? held : nullptr;
    }

    /** For transports: storage that `port` reads after a call of port.channelReady(storage, policy, id). */
    static ElementPtr makeChannelOutput(base::InputPortInterface& port, ConnPolicy const& policy);
    /** For transports: storage that `port` writes after a call of port.addConnection(id, storage, policy). */
    static ElementPtr makeChannelInput(base::OutputPortInterface& port, ConnPolicy const& policy);

    /** Connects two ports; see OutputPort::createConnection for the rules. */
    static bool createConnection(base::OutputPortInterface& output, base::InputPortInterface& input,
                                 ConnPolicy const& policy);
    /** Joins a transport's stream; fills in `policy.name_id` and `policy.data_size`. `partner`: the port at the other
        end, if it is in this process. */
    static bool createStream(base::OutputPortInterface& output, ConnPolicy const& policy,
                             base::InputPortInterface* partner = nullptr);
    static bool createStream(base::InputPortInterface& input, ConnPolicy const& policy,
                             base::OutputPortInterface* partner = nullptr);
    /** The same for a transport that knows both ends. The stream has the `id`, and ends together with the element
        `beyond` it. The stream's element, or null if it cannot be joined. */
    static ElementPtr createStream(base::OutputPortInterface& output, ConnPolicy const& policy,
                                   std::unique_ptr<ConnID> id, ElementPtr const& beyond);
    static ElementPtr createStream(base::InputPortInterface& input, ConnPolicy const& policy,
                                   std::unique_ptr<ConnID> id, ElementPtr const& beyond);
    static bool createSharedConnection(base::OutputPortInterface* output, base::InputPortInterface* input,
                                       boost::intrusive_ptr<SharedConnectionBase> connection, ConnPolicy const& policy);

    /** Completes and checks `policy` and makes the storage; null, with an error logged, if the policy is invalid. */
    static std::unique_ptr<SampleStore> makeStore(const types::TypeOps& ops, ConnPolicy& policy, const void* first);
};

}  // namespace internal
}  // namespace RTT

#endif
