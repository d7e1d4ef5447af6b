// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "state_channel.hpp"

#include <reporting/mcap_file/cdr_text.hpp>
#include <rtt/ExecutionEngine.hpp>
#include <rtt/internal/engine/engine_gate.hpp>
#include <rtt/internal/engine/state_changes.hpp>

namespace OCL::recording {
namespace {

namespace mcap = oroforge::mcap;

const char* textOf(RTT::base::TaskCore::TaskState state) {
    switch (state) {
        case RTT::base::TaskCore::Init: return "Init";
        case RTT::base::TaskCore::PreOperational: return "PreOperational";
        case RTT::base::TaskCore::FatalError: return "FatalError";
        case RTT::base::TaskCore::Exception: return "Exception";
        case RTT::base::TaskCore::Stopped: return "Stopped";
        case RTT::base::TaskCore::Running: return "Running";
        case RTT::base::TaskCore::RunTimeError: return "RunTimeError";
    }
    return "";
}

const char* stateBehind(const RTT::internal::EngineGate& gate) {
    const RTT::internal::EngineGate::Visit visit(gate);
    const RTT::ExecutionEngine* const engine = visit.engine();
    const RTT::base::TaskCore* const component = engine ? engine->getTaskCore() : nullptr;
    return component ? textOf(component->getTaskState()) : "Destroyed";
}

}  // namespace

StateChannel::StateChannel(const RTT::TaskContext::PeerGates& components, bool onlyHere) : onlyHere_(onlyHere) {
    for (const auto& [name, gate] : components) components_.push_back({name, gate});
}

mcap::Schema StateChannel::schema(std::uint16_t id) {
    return {id, "oroforge/msg/ComponentState", "ros2msg",
            "# A component has another state than before.\n"
            "string component\n"
            "# Init, PreOperational, FatalError, Exception, Stopped, Running, RunTimeError or Destroyed\n"
            "string state\n"};
}

mcap::Channel StateChannel::channel(std::uint16_t id, std::uint16_t schema) {
    id_ = id;
    return {id, schema, "/oroforge/states", "cdr", {{"oroforge.kind", "states"}}};
}

void StateChannel::add(ChunkPipe& pipe, std::uint64_t now) {
    const std::uint64_t changes = RTT::internal::stateChanges();
    if (onlyHere_ && changes == changes_) return;
    changes_ = changes;
    for (Component& component : components_) {
        const char* const state = stateBehind(*component.gate);
        if (state == component.state) continue;
        component.state = state;
        CdrText message;
        message.text(component.name).text(state);
        if (!addMessage(pipe, message.bytes(), {id_, sequence_++, now, now}))
            lost_.fetch_add(1, std::memory_order_relaxed);
    }
}

}  // namespace OCL::recording
