// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "check_properties.hpp"
#include "lookup.hpp"
#include "session.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/internal/sample_type_name.hpp>
#include <rtt/types/TypeOps.hpp>

#include <cstring>
#include <typeinfo>

namespace OCL::deploy {
namespace {

using RTT::base::PortInterface;

struct Resolved {
    const Connection::Member* member;
    PortInterface* port;

    const diag::Location& where() const { return member->plan->port.where; }
    std::string name() const { return member->record->name + "." + member->plan->port.value; }
};

/** True if the component may still make ports before it is complete. */
bool mayAddPorts(const Record& record) { return record.plan.autoConf.value_or(false) || !record.plan.scripts.empty(); }

/** By C++ type if both are local, because types without a typekit share one TypeInfo. */
bool sameType(const PortInterface& a, const PortInterface& b) {
    if (a.sampleOps() && b.sampleOps()) return std::strcmp(a.sampleOps()->id->name(), b.sampleOps()->id->name()) == 0;
    return a.getTypeInfo() == b.getTypeInfo();
}

bool isOutput(const PortInterface* port) {
    return dynamic_cast<const RTT::base::OutputPortInterface*>(port) != nullptr;
}
bool isInput(const PortInterface* port) { return dynamic_cast<const RTT::base::InputPortInterface*>(port) != nullptr; }

class ConnectionCheck {
public:
    ConnectionCheck(const Connection& connection, bool configured, diag::Sink& sink)
        : connection_(connection), sink_(sink) {
        for (const Connection::Member& member : connection.members) resolve(member, configured);
    }

    void run() {
        checkTypes();
        // As long as a port may still appear, its direction is unknown.
        if (incomplete_ || ports_.size() < 2) return;
        const auto none = [this](bool (*direction)(const PortInterface*)) {
            for (const Resolved& one : ports_)
                if (direction(one.port)) return false;
            return true;
        };
        if (none(isOutput))
            explain(sink_.error(ports_.front().where(), "DEP042",
                                "no output port takes part in connection '" + connection_.name + "'"));
        else if (none(isInput))
            explain(sink_.warning(ports_.front().where(), "DEP042",
                                  "no input port takes part in connection '" + connection_.name + "'"));
    }

private:
    void resolve(const Connection::Member& member, bool configured) {
        if (PortInterface* port = findPort(*member.record->instance, member.plan->port.value)) {
            ports_.push_back(Resolved{&member, port});
            return;
        }
        incomplete_ = true;
        if (!configured && mayAddPorts(*member.record)) return;
        const Text& name = member.plan->port;
        sink_.error(name.where, "DEP040",
                    "component '" + member.record->name + "' has no port '" + name.value + "'" +
                        diag::didYouMean(name.value, portNames(*member.record->instance)));
    }

    void checkTypes() {
        for (std::size_t i = 1; i < ports_.size(); ++i) {
            const Resolved& first = ports_.front();
            const Resolved& other = ports_[i];
            if (!sameType(*first.port, *other.port))
                sink_
                    .error(other.where(), "DEP041",
                           "port '" + other.name() + "' of type '" + RTT::internal::sampleTypeName(*other.port) +
                               "' cannot take part in connection '" + connection_.name + "' of type '" +
                               RTT::internal::sampleTypeName(*first.port) + "'")
                    .note(first.where(), "port '" + first.name() + "' gives the connection its type");
            else
                checkSchema(first, other);
        }
    }

    void checkSchema(const Resolved& first, const Resolved& other) {
        const std::string difference = RTT::internal::sampleDifference(*first.port, *other.port);
        if (difference.empty()) return;
        sink_
            .error(other.where(), "DEP044",
                   "port '" + other.name() + "' cannot take part in connection '" + connection_.name +
                       "': its plugin was built with another definition of '" +
                       RTT::internal::sampleTypeName(*other.port) + "': " + difference)
            .note(first.where(), "port '" + first.name() + "' gives the connection its type");
    }

    void explain(diag::Diagnostic& diagnostic) {
        for (const Resolved& one : ports_)
            diagnostic.note(one.where(), "port '" + one.name() + "' is an " + (isInput(one.port) ? "input" : "output"));
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
