// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Calls of a script that connect components: their effects, and what the graph shows of them.
#include "chains.hpp"
#include "lookup.hpp"
#include "script_forecast.hpp"

#include <rtt/TaskContext.hpp>

#include <utility>

namespace OCL::deploy {

void ScriptForecast::peers(const std::string& operation, const Call& call, Expectations& expected) const {
    const std::string* const one = textOf(call, 0);
    const std::string* const two = textOf(call, 1);
    const std::string* const alias = operation == "aliasPeer" ? textOf(call, 2) : two;
    if (!one || !two || !alias) return anyOperation(expected);
    RTT::TaskContext* const first = known(*one, expected);
    RTT::TaskContext* const second = known(*two, expected);
    const bool mutual = operation == "connectPeers";
    if (!isRun() && call.certain && first && second) {
        const std::string name = operation == "aliasPeer" ? *alias : second->getName();
        if (!first->hasPeer(name)) first->addPeer(second, name);
        if (mutual && !second->hasPeer(first->getName())) second->addPeer(first, first->getName());
        return;
    }
    if (first == session_.deployer) expected.components.insert(*alias);
    // A component that does not exist yet may call any operation of a peer, including the deployer.
    if (second == session_.deployer || (mutual && first == session_.deployer)) return anyOperation(expected);
    if (first) expected.more.insert(first);
    if (second) touch(*second, expected);
}

/** A sample may make a component execute code, also one that does not exist yet. */
void ScriptForecast::wiring(const std::vector<NamedArgument>& names, const Call& call, Expectations& expected) const {
    std::vector<RTT::TaskContext*> there;
    for (const NamedArgument& named : names)
        if (const std::string* const given = textOf(call, named.argument))
            if (RTT::TaskContext* const component = known(given->substr(0, given->find('.')), expected))
                there.push_back(component);
    if (names.size() < 2 || there.size() == names.size()) return;
    for (RTT::TaskContext* const component : there)
        if (component != session_.deployer) expected.more.insert(component);
}

namespace {

using Join = Foreseen::Join;

/** True if all arguments that name something are literals. Joins separate names of component and port to paths. */
bool namesOf(const std::string& operation, const RTT::scripting::ForeseenCall& call, Join& join) {
    const auto text = [&](std::size_t argument) { return textOf(call, argument); };
    const auto path = [&](std::size_t argument) {
        return text(argument) && text(argument + 1) ? *text(argument) + "." + *text(argument + 1) : std::string();
    };
    const bool isApart = operation == "connectTwoPorts" || operation == "createStream";
    const std::string first = isApart ? path(0) : text(0) ? *text(0) : std::string();
    const std::string second = join.kind == Join::Stream ? std::string()
                               : isApart                 ? path(2)
                               : text(1)                 ? *text(1)
                                                         : std::string();
    join.one = first;
    join.two = second;
    return !first.empty() && (join.kind == Join::Stream || !second.empty());
}

/** The kind of connection that an operation makes; false if it makes none. */
bool kindOf(const std::string& operation, Join::Kind& kind) {
    if (operation == "connect" || operation == "connectTwoPorts")
        kind = Join::Ports;
    else if (operation == "connectPorts")
        kind = Join::SamePorts;
    else if (operation == "stream" || operation == "createStream")
        kind = Join::Stream;
    else if (operation == "addPeer" || operation == "aliasPeer" || operation == "connectPeers")
        kind = Join::Peer;
    else
        return false;
    return true;
}

}  // namespace

void ScriptForecast::recordFor(const std::string& operation, const Call& call, const Expectations& expected) {
    Foreseen& graph = session_.foreseen;
    const auto isComputed = [&] {
        graph.computed.push_back(operation + "() in " + call.script + ":" + std::to_string(call.line));
    };
    if (operation == "loadComponent" || operation == "chain") {
        static const std::string chain = kChainType;
        const std::string* const name = textOf(call, 0);
        const std::string* const type = operation == "chain" ? &chain : textOf(call, 1);
        if (!name) return isComputed();
        graph.components.push_back({*name, type ? *type : std::string(), call.certain});
        return;
    }
    Join join{Join::Ports, {}, {}, call.certain};
    if (!kindOf(operation, join.kind)) return;
    if (!namesOf(operation, call, join)) return isComputed();
    // Certain connections have been made.
    const bool isMade =
        join.kind == Join::Peer && call.certain && known(join.one, expected) && known(join.two, expected);
    if (isMade) return;
    graph.joins.push_back(join);
    if (operation == "connectPeers") graph.joins.push_back({join.kind, join.two, join.one, join.certain});
}

}  // namespace OCL::deploy
