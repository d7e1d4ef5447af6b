// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The common base of input and output ports, for samples of any type.
#ifndef ORO_PORT_INTERFACE_HPP
#define ORO_PORT_INTERFACE_HPP

#include <rtt/base/ChannelElementBase.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <boost/shared_ptr.hpp>

#include <atomic>
#include <memory>
#include <string>

namespace RTT {
class ConnPolicy;
class DataFlowInterface;
class Service;
namespace types {
class TypeInfo;
struct Schema;
struct TypeOps;
}  // namespace types
namespace internal {
class ConnID;
class ConnectionManager;
class PortEndpoint;
class PortLink;
class SharedConnectionBase;
struct ChannelArray;
}  // namespace internal

namespace base {
class InputPortInterface;
class OutputPortInterface;

/** A named end of connections. Any thread may connect and disconnect, also while other threads write and read, and from
    callbacks. That is not real-time safe, may allocate and takes a process-wide lock, but never makes a writer or
    reader wait. Destroying a port disconnects it and waits until no other thread is inside it. */
class RTT_API PortInterface {
public:
    virtual ~PortInterface();
    PortInterface(const PortInterface&) = delete;
    PortInterface& operator=(const PortInterface&) = delete;

    const std::string& getName() const { return name_; }
    /** "Component.port", with sub-services in between; only the name if the port belongs to no component. */
    std::string getFullName() const;
    std::string getQualifiedName() const { return getFullName(); }
    /** False, without a change, while the port is connected. */
    bool setName(const std::string& name);
    const std::string& getDescription() const { return description_; }
    /** Describes the port, and its service if it has one already. */
    PortInterface& doc(const std::string& text);

    /** This port, if samples are read from it, or written to it; null otherwise. Real-time safe. */
    virtual InputPortInterface* asInput() { return nullptr; }
    virtual const InputPortInterface* asInput() const { return nullptr; }
    virtual OutputPortInterface* asOutput() { return nullptr; }
    virtual const OutputPortInterface* asOutput() const { return nullptr; }

    /** True if there is at least one connection or stream. Real-time safe. */
    virtual bool connected() const;
    virtual bool connectedTo(PortInterface* port) const;
    virtual const types::TypeInfo* getTypeInfo() const = 0;

    /** Removes all connections and streams, at both ends. */
    virtual void disconnect();
    /** Removes the connection with `port`; false if there is none. */
    virtual bool disconnect(PortInterface* port);

    /** True if the port object is the port itself, not a proxy for one in another process. */
    virtual bool isLocal() const;
    /** 0 for a local port, otherwise the id of its proxy's protocol. */
    virtual int serverProtocol() const;

    /** A new unconnected port of the same kind, or of the opposite direction; the caller owns it. */
    virtual PortInterface* clone() const = 0;
    virtual PortInterface* antiClone() const = 0;

    /** Connects with a port of the other direction; without a policy, with the input port's default one. */
    virtual bool connectTo(PortInterface* other, ConnPolicy const& policy) = 0;
    virtual bool connectTo(PortInterface* other) = 0;
    /** Joins a transport's topic or queue. False, with an error logged, if policy.transport does not know the type. */
    virtual bool createStream(ConnPolicy const& policy) = 0;
    /** Joins a shared connection without naming a peer. */
    virtual bool createConnection(boost::intrusive_ptr<internal::SharedConnectionBase> shared_connection,
                                  ConnPolicy const& policy) = 0;
    /** The same with the policy of the shared connection; false, with an error logged, if that is null. */
    bool createConnection(boost::intrusive_ptr<internal::SharedConnectionBase> shared_connection);

    /** For transports: registers a finished channel and takes ownership of `id`. False, with an error logged, if one of
        the two is null. */
    virtual bool addConnection(internal::ConnID* id, ChannelElementBase::shared_ptr channel, ConnPolicy const& policy);
    virtual bool removeConnection(internal::ConnID* id);

    DataFlowInterface* getInterface() const { return interface_.load(std::memory_order_seq_cst); }
    void setInterface(DataFlowInterface* iface);
    /** The connections, for introspection. */
    internal::ConnectionManager* getManager() const { return manager_.get(); }
    virtual boost::intrusive_ptr<internal::SharedConnectionBase> getSharedConnection() const;
    /** The element at this port's end of its channels. */
    virtual ChannelElementBase* getEndpoint() const;
    /** A new id by which a peer knows this port; the caller owns it. */
    virtual internal::ConnID* getPortID() const;

    /** A new service with the port's operations for scripts; not yet part of any component. */
    virtual Service* createPortObject();
    /** Adds these operations to `object`. It calls this when its operations are first looked up. */
    virtual void addOperationsTo(Service& object);

    /** Null for a proxy. */
    const types::TypeOps* sampleOps() const { return ops_; }
    /** The definition of the samples' type in the plugin that made the port; null for a proxy. */
    const types::Schema* sampleSchema() const { return schema_; }
    /** A new storage element for samples of this port's type; null, with an error logged, if the policy is invalid. */
    virtual ChannelElementBase::shared_ptr buildStorage(ConnPolicy const& policy) const;

protected:
    PortInterface(const std::string& name, const types::TypeOps* ops);
    void setSampleSchema(const types::Schema& schema) { schema_ = &schema; }

    /** The storage that this port shares between its connections, or with other ports; null if there is none. */
    ChannelElementBase::shared_ptr sharedStorage() const;
    /** Leaves the component; waits for a callback of this port in another thread. */
    void leaveInterface();
    /** Disconnects, leaves the component and waits until no thread is inside. Every directly derived class calls it in
        its destructor, while its own part still exists. */
    void closeDown();
    internal::PortEndpoint& endpoint() const { return *endpoint_; }

    /** The data path reads it within a Reclaimer::Guard; null if not connected. */
    std::atomic<const internal::ChannelArray*> channels_{nullptr};

private:
    friend class internal::ConnectionManager;

    std::string name_;
    std::string description_;
    std::atomic<DataFlowInterface*> interface_{nullptr};
    const types::TypeOps* ops_;
    const types::Schema* schema_ = nullptr;
    boost::intrusive_ptr<internal::PortEndpoint> endpoint_;
    std::unique_ptr<internal::ConnectionManager> manager_;
};

}  // namespace base
}  // namespace RTT

#endif
