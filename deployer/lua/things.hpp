// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What Lua code holds: the kinds of userdata of the module `rtt`.
#ifndef OCL_LUA_THINGS_HPP
#define OCL_LUA_THINGS_HPP

#include "life.hpp"

#include <rtt/OperationInterfacePart.hpp>
#include <rtt/Service.hpp>
#include <rtt/ServiceRequester.hpp>
#include <rtt/base/AttributeBase.hpp>
#include <rtt/base/DataSourceBase.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/base/PropertyBase.hpp>

#include <boost/weak_ptr.hpp>

#include <memory>
#include <string>

namespace OCL::lua {

class Conversion;

/** A value of a type of C++. */
struct Variable {
    static constexpr const char* kName = "Variable";
    RTT::base::DataSourceBase::shared_ptr source;
    Life life;  ///< of the component that has the value
};

/** Something that a component has by a name, or that Lua code made. */
template <class Thing>
struct Held {
    Thing* thing;
    Life life;
    boost::weak_ptr<RTT::Service> home;  ///< of what a component has
    std::string name;                    ///< in the home
    std::shared_ptr<const bool> exists;  ///< of what Lua code made; otherwise null
};
struct Property : Held<RTT::base::PropertyBase> {
    static constexpr const char* kName = "Property";
};
struct Attribute : Held<RTT::base::AttributeBase> {
    static constexpr const char* kName = "Attribute";
};
/** A sample that Lua code reads or writes. */
struct Sample {
    RTT::base::DataSourceBase::shared_ptr value;
    bool busy;  ///< a thread that has left uses it
};
struct InputPort : Held<RTT::base::InputPortInterface> {
    static constexpr const char* kName = "InputPort";
    std::shared_ptr<Sample> sample;
    const Conversion* conversion;
    RTT::base::DataSourceBase::shared_ptr nothing;  ///< what is read when there is no data
};
struct OutputPort : Held<RTT::base::OutputPortInterface> {
    static constexpr const char* kName = "OutputPort";
    std::shared_ptr<Sample> sample;
    const Conversion* conversion;
};

class OperationCall;

struct Operation {
    static constexpr const char* kName = "Operation";
    std::shared_ptr<OperationCall> call;
};

struct SendHandle {
    static constexpr const char* kName = "SendHandle";
    RTT::OperationInterfacePart::shared_constptr part;
    RTT::base::DataSourceBase::shared_ptr handle;
};

struct ServiceBox {
    static constexpr const char* kName = "Service";
    RTT::Service::shared_ptr service;
    Life life;
};

struct RequesterBox {
    static constexpr const char* kName = "ServiceRequester";
    RTT::ServiceRequester::shared_ptr requester;
    Life life;
};

struct TaskBox {
    static constexpr const char* kName = "TaskContext";
    RTT::TaskContext* component;
    Life life;
};

}  // namespace OCL::lua

#endif
