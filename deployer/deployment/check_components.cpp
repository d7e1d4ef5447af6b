// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "check_properties.hpp"
#include "lookup.hpp"
#include "port_faults.hpp"
#include "session.hpp"

#include <rtt/TaskContext.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/internal/flow/sample_type_name.hpp>
#include <rtt/types/TypeOps.hpp>

#include <cstring>
#include <typeinfo>

namespace OCL::deploy {
namespace {

using RTT::base::PortInterface;

struct Resolved {
    const PortInterface* port;
    ConnectedPort shown;
};

/** True if the component may still add ports while it is configured. */
bool mayAddPorts(const ComponentRecord& record) {
    return record.plan.autoConf.value_or(false) || !record.plan.scripts.empty();
}

/** Compares C++ types if both ports are local, because types without a typekit share one TypeInfo. */
bool sameType(const PortInterface& a, const PortInterface& b) {
    if (a.sampleOps() && b.sampleOps()) return std::strcmp(a.sampleOps()->id->name(), b.sampleOps()->id->name()) == 0;
    return a.getTypeInfo() == b.getTypeInfo();
}

class ConnectionCheck {
public:
    ConnectionCheck(const Connection& connection, bool configured, diag::Sink& sink)
        : connection_(connection), sink_(sink) {
        for (const Connection::Member& member : connection.members) resolve(member, configured);
    }

    void run() {
        checkTypes();
        // The direction of a port that may still appear is unknown.
        if (incomplete_ || ports_.size() < 2) return;
        std::vector<ConnectedPort> shown;
        for (const Resolved& one : ports_) shown.push_back(one.shown);
        checkDirections(connection_.name, shown, sink_);
    }

private:
    void resolve(const Connection::Member& member, bool configured) {
        const Text& name = member.plan->port;
        if (const PortInterface* port = findPort(*member.record->instance, name.value)) {
            const bool isOutput = port->asOutput() != nullptr;
            ports_.push_back(
                {port,
                 {name.where, member.record->name + "." + name.value, RTT::internal::sampleTypeName(*port), isOutput}});
            return;
        }
        incomplete_ = true;
        if (!configured && mayAddPorts(*member.record)) return;
        reportUnknownPort(member.record->name, name, portNames(*member.record->instance), sink_);
    }

    void checkTypes() {
        for (std::size_t i = 1; i < ports_.size(); ++i) {
            const Resolved& first = ports_.front();
            const Resolved& other = ports_[i];
            if (!sameType(*first.port, *other.port))
                reportOtherType(connection_.name, first.shown, other.shown, sink_);
            else
                checkSchema(first, other);
        }
    }

    void checkSchema(const Resolved& first, const Resolved& other) {
        const std::string difference = RTT::internal::sampleDifference(*first.port, *other.port);
        if (difference.empty()) return;
        sink_
            .error(other.shown.where, "DEP044",
                   "port '" + other.shown.name + "' cannot take part in connection '" + connection_.name +
                       "': its plugin was built with another definition of '" + other.shown.type + "': " + difference)
            .note(first.shown.where, "port '" + first.shown.name + "' gives the connection its type");
    }

    const Connection& connection_;
    diag::Sink& sink_;
    std::vector<Resolved> ports_;
    bool incomplete_ = false;
};

}  // namespace

void checkComponents(const Session& session, int group, bool configured, diag::Sink& sink) {
    for (const Connection& connection : session.records.connections())
        ConnectionCheck(connection, configured, sink).run();
    if (configured) return;
    checkProperties(session, group, sink);
}

}  // namespace OCL::deploy
