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
 * The service "scripting": runs scripts in a component, and keeps the programs and state machines that they define. The
 * component's engine executes these while its activity runs, even if the component is stopped.
 *
 * A text is parsed as a whole; if it has a syntax error, nothing of it is executed. Then its statements are executed in
 * the thread of the caller; the first one that fails ends the script, and earlier ones keep their effects. Errors are
 * logged with their places, and false is returned.
 *
 * All functions run in the caller's thread and block until they are done. They are not real-time safe, except commands
 * and queries of a program or state machine, which look it up by name under a short lock. Several threads may call them
 * at the same time, as long as no script changes the component's interface.
 */
class RTT_API ScriptingService : public Service {
    // Only a real bool: otherwise two texts would match (file, bool).
    template <class T>
    using OnlyBool = std::enable_if_t<std::is_same_v<T, bool>, int>;

public:
    typedef boost::shared_ptr<ScriptingService> shared_ptr;
    typedef ProgramInterface::Status::ProgramStatus ProgramStatus;
    typedef StateMachine::Status::StateMachineStatus StateMachineStatus;

    /** The scripting service of a component, created if it has none. */
    static shared_ptr Create(TaskContext* parent);
    explicit ScriptingService(TaskContext* parent);
    ~ScriptingService() override;

    /** Unloads all programs and state machines, and forgets all functions. */
    void clear() override;

    // -- Scripts ------------------------------------------------------------------------------------------------
    bool eval(const std::string& code);
    /** As eval(), for a text that messages call `name`. */
    bool evalInternal(const std::string& name, const std::string& code);
    bool runScript(const std::string& file);
    /** As eval(); 0 for true, −1 for false. Deprecated. */
    int execute(const std::string& code);
    bool doExecute(const std::string& code);

    // -- Programs -----------------------------------------------------------------------------------------------
    /** Loads a file that defines only functions and programs. */
    bool loadPrograms(const std::string& file) { return load(file, Kind::Programs, false); }
    /** With `do_throw` throws program_load_exception instead of returning false. */
    template <class Bool, OnlyBool<Bool> = 0>
    bool loadPrograms(const std::string& file, Bool do_throw) {
        return load(file, Kind::Programs, do_throw);
    }
    /** The same for a text, which messages call `name`. */
    bool loadPrograms(const std::string& code, const std::string& name, bool do_throw = false) {
        return load(code, name, Kind::Programs, do_throw);
    }
    bool loadProgramText(const std::string& code) { return loadPrograms(code, "string"); }
    /** Adds the program to the engine, and a service of its name to the component. If there is a program or service of
        that name, logs an error and returns false. */
    bool loadProgram(ProgramInterfacePtr program);
    /** Removes the program from the engine. Logs an error and returns false if there is none of that name. */
    bool unloadProgram(const std::string& name);
    /** With `do_throw` throws program_unload_exception instead of returning false. */
    bool unloadProgram(const std::string& name, bool do_throw);
    std::vector<std::string> getProgramList() const;
    /** The program of that name; null if there is none. */
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
    /** The line of the statement that is next, or that failed; −1 if there is no such program. */
    int getProgramLine(const std::string& name) const;
    std::string getProgramText(const std::string& name) const;

    // -- State machines -----------------------------------------------------------------------------------------
    /** Loads a file that only defines types of state machines and instantiates at least one. */
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
    /** Adds the state machine and its sub machines to the engine, and its service to the component. If there is a state
        machine or service of that name, logs an error and returns false. */
    bool loadStateMachine(StateMachinePtr machine);
    /** Stops, deactivates and removes it. If there is none, or it does not stop, logs an error and returns false. */
    bool unloadStateMachine(const std::string& name);
    bool unloadStateMachine(const std::string& name, bool do_throw);
    /** The names of the root machines, and of those below them as "root.sub". */
    std::vector<std::string> getStateMachineList() const;
    /** The machine with a name from that list; null if there is none. */
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
    /** What has that name in the component; empty if it is free. */
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
