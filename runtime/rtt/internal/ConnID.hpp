// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How a port identifies the other end of a connection.
#ifndef ORO_CONN_ID_HPP
#define ORO_CONN_ID_HPP

#include <rtt/rtt-config.h>

#include <string>

namespace RTT {
namespace base {
class PortInterface;
}
namespace internal {

/** Identifies one connection of a port, so that it can be removed. */
class RTT_API ConnID {
public:
    virtual ~ConnID();
    virtual bool isSameID(ConnID const& id) const = 0;
    virtual ConnID* clone() const = 0;
    virtual std::string toString() const = 0;
    /** The port at the other end, if it is in this process. */
    virtual base::PortInterface* peer() const { return nullptr; }
    /** The same, if each of the two ports has a channel of its own, which leads to a transport. */
    virtual base::PortInterface* partner() const { return nullptr; }
};

/** The other end is a port of this process. */
class RTT_API LocalConnID : public ConnID {
public:
    explicit LocalConnID(base::PortInterface const* port);
    bool isSameID(ConnID const& id) const override;
    LocalConnID* clone() const override;
    /** The full name that the port had when this was made. */
    std::string toString() const override;
    base::PortInterface* peer() const override { return const_cast<base::PortInterface*>(ptr); }

    base::PortInterface const* const ptr;

private:
    const std::string name_;  // the port may be destroyed before a copy of this is
};

/** The other end is a transport's stream. */
class RTT_API StreamConnID : public ConnID {
public:
    explicit StreamConnID(std::string const& name) : name_id(name) {}
    bool isSameID(ConnID const& id) const override;
    StreamConnID* clone() const override;
    std::string toString() const override;

    const std::string name_id;
};

/** The other end is a port of this process, by way of a transport's stream. */
class RTT_API OutOfBandConnID : public StreamConnID {
public:
    OutOfBandConnID(std::string const& name, base::PortInterface& partner) : StreamConnID(name), partner_(partner) {}
    OutOfBandConnID* clone() const override;
    base::PortInterface* partner() const override { return &partner_; }

private:
    base::PortInterface& partner_;
};

/** The other end is a shared connection. */
class RTT_API SharedConnID : public StreamConnID {
public:
    explicit SharedConnID(std::string const& name) : StreamConnID(name) {}
    bool isSameID(ConnID const& id) const override;
    SharedConnID* clone() const override;
};

}  // namespace internal
}  // namespace RTT

#endif
