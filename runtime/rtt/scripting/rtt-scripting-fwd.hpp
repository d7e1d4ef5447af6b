// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Forward declarations of the scripting service.
#ifndef ORO_RTT_SCRIPTING_FWD_HPP
#define ORO_RTT_SCRIPTING_FWD_HPP

#include <boost/shared_ptr.hpp>

namespace RTT {
class Scripting;
namespace scripting {
class ProgramInterface;
class ScriptingService;
class StateInterface;
class StateMachine;
typedef boost::shared_ptr<ProgramInterface> ProgramInterfacePtr;
typedef boost::shared_ptr<StateMachine> StateMachinePtr;
}  // namespace scripting
}  // namespace RTT

#endif
