// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "repeated_port.hpp"

#include <utility>

namespace OCL::replay {

std::unique_ptr<RepeatedPort> RepeatedPort::make(const RTT::types::TypeInfo& type, const std::string& name) {
    std::unique_ptr<RTT::base::OutputPortInterface> port(type.outputPort(name));
    RTT::base::DataSourceBase::shared_ptr value = type.buildValue();
    if (!port || !value || !value->getRawPointer()) return nullptr;
    return std::unique_ptr<RepeatedPort>(new RepeatedPort(type, std::move(port), std::move(value)));
}

RepeatedPort::RepeatedPort(const RTT::types::TypeInfo& type, std::unique_ptr<RTT::base::OutputPortInterface> port,
                           RTT::base::DataSourceBase::shared_ptr value)
    : type_(type), port_(std::move(port)), link_(*port_), value_(std::move(value)), address_(value_->getRawPointer()) {}

std::string RepeatedPort::write(MessageDecoder& decoder, const oroforge::mcap::Message& message) {
    std::string problem = decoder.decode(message, address_);
    if (problem.empty()) (void)link_.write(address_);
    return problem;
}

}  // namespace OCL::replay
