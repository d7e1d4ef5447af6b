// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_HPP
#define ORO_SCRIPTING_HPP

#include <rtt/OperationCaller.hpp>
#include <rtt/ServiceRequester.hpp>
#include <rtt/scripting/ProgramInterface.hpp>
#include <rtt/scripting/StateMachine.hpp>

#include <string>
#include <vector>

namespace RTT {

/** Calls the service "scripting": component->getProvider<RTT::Scripting>("scripting")->runScript(file). */
class Scripting : public ServiceRequester {
public:
    typedef OperationCaller<bool(const std::string&)> OfName;
    typedef OperationCaller<bool(const std::string&, const std::string&)> OfNameAndState;
    typedef OperationCaller<int(const std::string&)> NumberOfName;
    typedef OperationCaller<std::string(const std::string&)> TextOfName;
    typedef OperationCaller<std::vector<std::string>()> Names;
    typedef scripting::ProgramInterface::ProgramStatus ProgramStatus;
    typedef scripting::StateMachine::StateMachineStatus StateMachineStatus;

    explicit Scripting(TaskContext* owner = nullptr) : ServiceRequester("scripting", owner) {
        for (auto* caller : {&eval,
                             &runScript,
                             &doExecute,
                             &loadPrograms,
                             &loadProgramText,
                             &loadStateMachines,
                             &loadStateMachineText,
                             &unloadProgram,
                             &unloadStateMachine,
                             &hasProgram,
                             &startProgram,
                             &stopProgram,
                             &stepProgram,
                             &pauseProgram,
                             &isProgramRunning,
                             &isProgramPaused,
                             &inProgramError,
                             &hasStateMachine,
                             &activateStateMachine,
                             &deactivateStateMachine,
                             &startStateMachine,
                             &pauseStateMachine,
                             &stopStateMachine,
                             &resetStateMachine,
                             &isStateMachineActive,
                             &isStateMachineRunning,
                             &isStateMachinePaused,
                             &inStateMachineError})
            addOperationCaller(*caller);
        for (auto* caller : {&requestStateMachineState, &inStateMachineState}) addOperationCaller(*caller);
        for (auto* caller : {&execute, &getProgramLine, &getStateMachineLine}) addOperationCaller(*caller);
        for (auto* caller : {&getProgramStatusStr, &getProgramText, &getStateMachineStatusStr, &getStateMachineText,
                             &getStateMachineState})
            addOperationCaller(*caller);
        for (auto* caller : {&getProgramList, &getStateMachineList}) addOperationCaller(*caller);
        addOperationCaller(getProgramStatus);
        addOperationCaller(getStateMachineStatus);
    }

    OfName eval{"eval"};
    OfName runScript{"runScript"};
    NumberOfName execute{"execute"};
    OfName doExecute{"doExecute"};

    OfName loadPrograms{"loadPrograms"};
    OfName loadProgramText{"loadProgramText"};
    OfName unloadProgram{"unloadProgram"};
    Names getProgramList{"getProgramList"};
    OfName hasProgram{"hasProgram"};
    OfName startProgram{"startProgram"};
    OfName stopProgram{"stopProgram"};
    OfName stepProgram{"stepProgram"};
    OfName pauseProgram{"pauseProgram"};
    OfName isProgramRunning{"isProgramRunning"};
    OfName isProgramPaused{"isProgramPaused"};
    OfName inProgramError{"inProgramError"};
    OperationCaller<ProgramStatus(const std::string&)> getProgramStatus{"getProgramStatus"};
    TextOfName getProgramStatusStr{"getProgramStatusStr"};
    NumberOfName getProgramLine{"getProgramLine"};
    TextOfName getProgramText{"getProgramText"};

    OfName loadStateMachines{"loadStateMachines"};
    OfName loadStateMachineText{"loadStateMachineText"};
    OfName unloadStateMachine{"unloadStateMachine"};
    Names getStateMachineList{"getStateMachineList"};
    OfName hasStateMachine{"hasStateMachine"};
    OfName activateStateMachine{"activateStateMachine"};
    OfName deactivateStateMachine{"deactivateStateMachine"};
    OfName startStateMachine{"startStateMachine"};
    OfName pauseStateMachine{"pauseStateMachine"};
    OfName stopStateMachine{"stopStateMachine"};
    OfName resetStateMachine{"resetStateMachine"};
    OfNameAndState requestStateMachineState{"requestStateMachineState"};
    OfName isStateMachineActive{"isStateMachineActive"};
    OfName isStateMachineRunning{"isStateMachineRunning"};
    OfName isStateMachinePaused{"isStateMachinePaused"};
    OfName inStateMachineError{"inStateMachineError"};
    OfNameAndState inStateMachineState{"inStateMachineState"};
    TextOfName getStateMachineState{"getStateMachineState"};
    OperationCaller<StateMachineStatus(const std::string&)> getStateMachineStatus{"getStateMachineStatus"};
    TextOfName getStateMachineStatusStr{"getStateMachineStatusStr"};
    NumberOfName getStateMachineLine{"getStateMachineLine"};
    TextOfName getStateMachineText{"getStateMachineText"};
};

}  // namespace RTT

#endif
