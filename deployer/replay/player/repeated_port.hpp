// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_REPLAY_REPEATED_PORT_HPP
#define OROFORGE_REPLAY_REPEATED_PORT_HPP

#include "message_decoder.hpp"

#include <rtt/base/DataSourceBase.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/internal/flow/port_sources.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <memory>
#include <string>

namespace OCL::replay {

/** A port that repeats a topic. */
class RepeatedPort {
public:
    /** Null if values of the type cannot be sent. */
    static std::unique_ptr<RepeatedPort> make(const RTT::types::TypeInfo& type, const std::string& name);

    const RTT::types::TypeInfo& type() const { return type_; }
    RTT::base::OutputPortInterface& port() const { return *port_; }
    /** Writes the value of a message. Empty if all went well; otherwise why it was not written. */
    std::string write(MessageDecoder& decoder, const oroforge::mcap::Message& message);

private:
    RepeatedPort(const RTT::types::TypeInfo& type, std::unique_ptr<RTT::base::OutputPortInterface> port,
                 RTT::base::DataSourceBase::shared_ptr value);

    const RTT::types::TypeInfo& type_;
    const std::unique_ptr<RTT::base::OutputPortInterface> port_;
    const RTT::internal::PortLink link_;  // writes without looking the type up each time
    const RTT::base::DataSourceBase::shared_ptr value_;
    void* const address_;
};

}  // namespace OCL::replay

#endif
