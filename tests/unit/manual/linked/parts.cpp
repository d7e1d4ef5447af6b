// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A file of a static library: no RTT_COMPONENT.
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>

#include <ocl/Component.hpp>

namespace linked {

class PartX : public RTT::TaskContext {
public:
    explicit PartX(const std::string& name) : RTT::TaskContext(name) { addPort("out", out_); }

private:
    RTT::OutputPort<double> out_;
};

class PartZ : public RTT::TaskContext {
public:
    explicit PartZ(const std::string& name) : RTT::TaskContext(name) { addPort("in", in_); }

private:
    RTT::InputPort<double> in_;
};

}  // namespace linked

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(linked::PartX)
ORO_LIST_COMPONENT_TYPE(linked::PartZ)
