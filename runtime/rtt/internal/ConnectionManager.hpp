// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The connections of one port: the other end, the channel and the policy of each.
#ifndef ORO_CONNECTION_MANAGER_HPP
#define ORO_CONNECTION_MANAGER_HPP

#include <rtt/ConnPolicy.hpp>
#include <rtt/base/PortInterface.hpp>
#include <rtt/internal/ConnID.hpp>
#include <rtt/internal/SharedConnection.hpp>

#include <boost/shared_ptr.hpp>
#include <boost/tuple/tuple.hpp>

#include <list>
#include <vector>

namespace RTT {
namespace internal {
/** One process-wide lock serialises all changes of all ports. It is never held while user code runs, and writing and
    reading ports never take it. Only connected() is real-time safe. */
class RTT_API ConnectionManager {
public:
    /** The peer's id, the first channel element as seen from this port, the policy in force. */
    typedef boost::tuple<boost::shared_ptr<ConnID>, base::ChannelElementBase::shared_ptr, ConnPolicy> ChannelDescriptor;
    typedef std::list<ChannelDescriptor> Connections;

    explicit ConnectionManager(base::PortInterface* port) : port_(port) {}
    ~ConnectionManager();

    /** A snapshot. */
    Connections getConnections() const;
    Connections getChannels() const { return getConnections(); }
    bool connected() const;
    bool connectedTo(base::PortInterface* port) const;
    /** The shared connection that the port has joined; null if none. */
    boost::intrusive_ptr<SharedConnectionBase> getSharedConnection() const;
    /** The storage that the port's connections share, or that of its shared connection; null if there is none. */
    base::ChannelElementBase::shared_ptr getSharedStorage() const;

    /** Registers a channel whose other end is not a local port. Takes ownership of `id`. */
    void addConnection(ConnID* id, base::ChannelElementBase::shared_ptr channel, const ConnPolicy& policy);
    /** These remove connections at both ends and break their channels; false if there was no such connection. */
    bool removeConnection(const ConnID* id);
    bool removeChannel(const base::ChannelElementBase* channel);
    bool disconnect(base::PortInterface* port);
    void disconnect();

    /** For ConnFactory: what prevents a new connection at a port, if anything. */
    enum Obstacle { None, OtherBufferPolicy, OtherStorage, AlreadyConnected, Retry };
    /** The storage that a new connection with `policy` has to use, because the port shares it between its connections,
        with its policy in `existing`; null if the connection needs a new one. */
    base::ChannelElementBase::shared_ptr sharedStorage(const ConnPolicy& policy, ConnPolicy* existing) const;
    /** Joins two ports by `storage`; Retry if sharedStorage() would no longer return `expected`. */
    static Obstacle join(ConnectionManager& output, ConnectionManager& input,
                         const base::ChannelElementBase::shared_ptr& storage, const ConnPolicy& policy,
                         const base::ChannelElementBase* expected);
    /** Joins this port and a shared connection. */
    Obstacle join(const boost::intrusive_ptr<SharedConnectionBase>& connection);

private:
    struct Connection {
        boost::shared_ptr<ConnID> id;
        base::ChannelElementBase::shared_ptr channel;
        ConnPolicy policy;
        boost::intrusive_ptr<SharedConnectionBase> shared;
    };
    typedef std::vector<Connection> List;
    struct Removal;

    static bool isInput(const base::PortInterface& port);

    /** Takes the lock. */
    template <class Which>
    bool removeIf(Which which);

    // With the lock held:
    bool leadsTo(const Connection& connection, const base::PortInterface& port) const;
    static void linkTo(base::ChannelElementBase& storage, const base::PortInterface& port, bool input);
    bool mixesBadly(const ConnPolicy& policy) const;
    void add(const Connection& connection);
    bool uses(const base::ChannelElementBase* channel) const;
    base::ChannelElementBase* findShared(const ConnPolicy& policy, ConnPolicy* existing) const;
    void publish();
    void unlink(const Connection& connection);
    void takeFromPartners(const List& gone, List& theirs);

    List connections_;
    base::PortInterface* port_;
    // As of the last connection: a port under destruction is not asked, because its class is changing.
    bool isOfInput_ = false;
};

}  // namespace internal
}  // namespace RTT

#endif
