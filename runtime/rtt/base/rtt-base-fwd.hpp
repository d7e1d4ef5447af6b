// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Forward declarations of the interfaces in namespace base.
#ifndef ORO_RTT_BASE_FWD_HPP
#define ORO_RTT_BASE_FWD_HPP

namespace RTT {
namespace base {
class ActionInterface;
class ActivityInterface;
class AttributeBase;
class ChannelElementBase;
class DataSourceBase;
class DisposableInterface;
class ExecutableInterface;
class InputPortInterface;
class OperationBase;
class OperationCallerInterface;
class OutputPortInterface;
class PortInterface;
class PropertyBase;
class RunnableInterface;
class TaskCore;
}  // namespace base
}  // namespace RTT

#endif
