// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_SERVICE_HPP
#define ORO_SCRIPTING_SERVICE_HPP

#include <rtt/Service.hpp>
#include <rtt/scripting/ProgramInterface.hpp>
#include <rtt/scripting/StateMachine.hpp>
#include <rtt/scripting/rtt-scripting-fwd.hpp>
#include <rtt/scripting/script_exceptions.hpp>

#include <boost/shared_ptr.hpp>

#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace RTT {
class TaskContext;

namespace scripting {

namespace detail {
class ScriptRunner;
}

/**
 * The service "scripting": runs scripts in a component, and keeps the programs and state machines they define. Those are
 * executed by the component's engine while its activity runs, also while the component is stopped.
 *
 * A text is parsed as a whole; any syntax error in it means that nothing of it is executed. Then one statement after the
 * other is executed in the thread of the caller; the first that cannot be executed stops the script. Whatever goes wrong is
 * in the log, with its place in the text, and false is returned. What was done before stays done.
 *
 * All functions run in the caller's thread and block until they are done. They are not real-time safe, except those that
 * command and ask about a program or state machine, which look it up by name under a short lock. Several threads may call
 * them at the same time, as long as none of the scripts changes the component's interface.
 */
class RTT_API ScriptingService : public Service {
    // Else two texts would be taken for a file and true.
    template <class T>
    using OnlyBool = std::enable_if_t<std::is_same_v<T, bool>, int>;

public:
    typedef boost::shared_ptr<ScriptingService> shared_ptr;
    typedef ProgramInterface::Status::ProgramStatus ProgramStatus;
    typedef StateMachine::Status::StateMachineStatus StateMachineStatus;

    /** The scripting service of a component, which is made if it has none. */
    static shared_ptr Create(TaskContext* parent);
    explicit ScriptingService(TaskContext* parent);
    ~ScriptingService() override;

    /** Unloads all programs and state machines, and forgets all functions. */
    void clear() override;

    // -- Scripts ------------------------------------------------------------------------------------------------
    bool eval(const std::string& code);
    /** As eval(), for a text that came from somewhere: `name` stands for it in messages. */
    bool evalInternal(const std::string& name, const std::string& code);
    bool runScript(const std::string& file);
    /** As eval(); 0 for true, −1 for false. Deprecated. */
    int execute(const std::string& code);
    bool doExecute(const std::string& code);

    // -- Programs -----------------------------------------------------------------------------------------------
    /** For a file that defines functions and programs, and nothing else. */
    bool loadPrograms(const std::string& file) { return load(file, Kind::Programs, false); }
    /** With `do_throw` throws program_load_exception instead of returning false. */
    template <class Bool, OnlyBool<Bool> = 0>
    bool loadPrograms(const std::string& file, Bool do_throw) {
        return load(file, Kind::Programs, do_throw);
    }
    /** Of a text; `name` stands for it in messages. */
    bool loadPrograms(const std::string& code, const std::string& name, bool do_throw = false) {
        return load(code, name, Kind::Programs, do_throw);
    }
    bool loadProgramText(const std::string& code) { return loadPrograms(code, "string"); }
    /** Has the engine execute the program, and gives the component a service of its name. False, with an error in the log, if
        there is a program or service of that name. */
    bool loadProgram(ProgramInterfacePtr program);
    /** Takes it out of the engine. False, with an error in the log, if there is none. */
    bool unloadProgram(const std::string& name);
    /** With `do_throw` throws program_unload_exception instead of returning false. */
    bool unloadProgram(const std::string& name, bool do_throw);
    std::vector<std::string> getProgramList() const;
    /** Null if there is none. */
    ProgramInterfacePtr getProgram(const std::string& name) const;
    bool hasProgram(const std::string& name) const;
    bool startProgram(const std::string& name);
    bool stopProgram(const std::string& name);
    bool stepProgram(const std::string& name);
    bool pauseProgram(const std::string& name);
    bool isProgramRunning(const std::string& name) const;
    bool isProgramPaused(const std::string& name) const;
    bool inProgramError(const std::string& name) const;
    ProgramStatus getProgramStatus(const std::string& name) const;
    std::string getProgramStatusStr(const std::string& name) const;
    /** Of the statement that comes next, or failed; −1 if there is no such program. */
    int getProgramLine(const std::string& name) const;
    std::string getProgramText(const std::string& name) const;

    // -- State machines -----------------------------------------------------------------------------------------
    /** For a file that defines types of state machines and instantiates at least one, and nothing else. */
    bool loadStateMachines(const std::string& file) { return load(file, Kind::StateMachines, false); }
    /** As for programs. */
    template <class Bool, OnlyBool<Bool> = 0>
    bool loadStateMachines(const std::string& file, Bool do_throw) {
        return load(file, Kind::StateMachines, do_throw);
    }
    bool loadStateMachines(const std::string& code, const std::string& name, bool do_throw = false) {
        return load(code, name, Kind::StateMachines, do_throw);
    }
    bool loadStateMachineText(const std::string& code) { return loadStateMachines(code, "string"); }
    /** Has the engine execute the state machine and its sub machines, and gives the component its service. False, with an
        error in the log, if there is a state machine or service of that name. */
    bool loadStateMachine(StateMachinePtr machine);
    /** Stops and deactivates it first. False, with an error in the log, if there is none or it does not stop. */
    bool unloadStateMachine(const std::string& name);
    bool unloadStateMachine(const std::string& name, bool do_throw);
    /** Of the root machines, and those below them as "root.sub". */
    std::vector<std::string> getStateMachineList() const;
    /** By the names of that list; null if there is none. */
    StateMachinePtr getStateMachine(const std::string& name) const;
    bool hasStateMachine(const std::string& name) const;
    bool activateStateMachine(const std::string& name);
    bool deactivateStateMachine(const std::string& name);
    bool startStateMachine(const std::string& name);
    bool pauseStateMachine(const std::string& name);
    bool stopStateMachine(const std::string& name);
    bool resetStateMachine(const std::string& name);
    bool requestStateMachineState(const std::string& name, const std::string& state);
    bool isStateMachineActive(const std::string& name) const;
    bool isStateMachineRunning(const std::string& name) const;
    bool isStateMachinePaused(const std::string& name) const;
    bool inStateMachineError(const std::string& name) const;
    bool inStateMachineState(const std::string& name, const std::string& state) const;
    std::string getStateMachineState(const std::string& name) const;
    StateMachineStatus getStateMachineStatus(const std::string& name) const;
    std::string getStateMachineStatusStr(const std::string& name) const;
    /** −1 if there is no such state machine. */
    int getStateMachineLine(const std::string& name) const;
    std::string getStateMachineText(const std::string& name) const;

private:
    friend class detail::ScriptRunner;
    struct Loaded;
    enum class Kind { Programs, StateMachines };
    bool load(const std::string& file, Kind kind, bool do_throw);
    bool load(const std::string& code, const std::string& name, Kind kind, bool do_throw);
    void addScriptOperations();
    void addProgramOperations();
    void addStateMachineOperations();
    bool takeOutProgram(const std::string& name);
    bool takeOutMachine(StateMachinePtr machine);
    bool addMachine(const StateMachinePtr& machine);
    bool removeMachine(const StateMachinePtr& machine);
    /** Who has that name in the component; empty if nobody has. */
    std::string nameInUse(const std::string& name) const;
    void announce(const std::string& what) const;
    static bool refuse(const std::string& what, const std::string& why);
    std::vector<std::string> rootMachines() const;
    void retire(const StateMachinePtr& machine);
    void retire(ProgramInterfacePtr program);

    std::unique_ptr<Loaded> loaded_;
    bool zero_period_warning_ = true;
};

}  // namespace scripting
}  // namespace RTT

#endif
