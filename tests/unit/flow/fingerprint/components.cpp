// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A writer and a reader, built with one version of the header; WRITER and READER are their names in this library.
#if defined UNDESCRIBED || defined VERSION_SAME
#include "sample.hpp"
#else
#include <sample/typekit/Types.hpp>
#endif

#include <rtt/Component.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>

namespace {

class WRITER : public RTT::TaskContext {
public:
    explicit WRITER(const std::string& name) : RTT::TaskContext(name) { addPort("out", out_); }

private:
    RTT::OutputPort<plan::Sample> out_;
};

class READER : public RTT::TaskContext {
public:
    explicit READER(const std::string& name) : RTT::TaskContext(name) {
        addPort("in", in_);
        addPort("places", places_);
    }

private:
    RTT::InputPort<plan::Sample> in_;
    RTT::InputPort<std::vector<plan::Place>> places_;
};

}  // namespace

#ifdef VERSION_SAME  // who includes it late is described all the same
#include <sample/typekit/Types.hpp>
#endif

ORO_CREATE_COMPONENT_LIBRARY()
// Once more, for the names that the two macros stand for.
#define LIST_COMPONENT_TYPE(TYPE) ORO_LIST_COMPONENT_TYPE(TYPE)
LIST_COMPONENT_TYPE(WRITER)
LIST_COMPONENT_TYPE(READER)
