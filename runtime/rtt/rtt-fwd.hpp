// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Forward declarations of the classes that components use.
#ifndef ORO_RTT_FWD_HPP
#define ORO_RTT_FWD_HPP

#include <rtt/rtt-config.h>
#include <rtt/base/rtt-base-fwd.hpp>

namespace RTT {
class Activity;
class ConfigurationInterface;
class ConnPolicy;
class DataFlowInterface;
class ExecutionEngine;
class Handle;
class Logger;
class OperationInterface;
class OperationInterfacePart;
class PropertyBag;
class Service;
class ServiceRequester;
class TaskContext;
template <typename T>
class Attribute;
template <typename T>
class Constant;
template <typename T>
class InputPort;
template <typename T>
class OutputPort;
template <typename T>
class Property;
template <class Signature>
class Operation;
template <class Signature>
class OperationCaller;
template <class Signature>
class SendHandle;
}  // namespace RTT

#endif
