// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_STATE_HPP
#define OCL_LUA_STATE_HPP

#include "failure.hpp"
#include "memory.hpp"

#include <rtt/internal/engine/engine_gate.hpp>
#include <rtt/internal/engine/script_place.hpp>
#include <rtt/os/Mutex.hpp>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace RTT {
class TaskContext;
namespace types {
class TypeInfo;
}
}  // namespace RTT

namespace OCL::lua {

class Conversion;
class EngineHook;
class OwnedThings;

/**
 * A Lua interpreter that belongs to a component, with the module `rtt`.
 *
 * Any number of threads may use it, one at a time: a thread enters, and waits until no other one is inside. It leaves
 * while Lua code waits for C++ code (an operation, a pause), so that calls in a circle through several threads never
 * wait for each other. Each thread that is inside, or has left for a while, has a Lua thread (coroutine) of its own.
 * Waiting threads lend their priority to the one that is inside.
 */
class State : public std::enable_shared_from_this<State> {
public:
    /** The component must outlive the state. Throws std::bad_alloc if the memory is too small. */
    State(RTT::TaskContext& owner, std::unique_ptr<Memory> memory);
    ~State();
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    /** The state that Lua code runs in. */
    static State& of(lua_State* lua) noexcept {
        void* memory = nullptr;
        (void)lua_getallocf(lua, &memory);
        return *static_cast<Memory*>(memory)->state;
    }

    /** While one exists, this thread is inside. Blocks until others have left. They nest. Lives on the stack. Throws
        Failure and std::bad_alloc. */
    class Entry {
    public:
        explicit Entry(State& state);
        ~Entry();
        Entry(const Entry&) = delete;
        Entry& operator=(const Entry&) = delete;
        /** An empty stack. */
        lua_State* lua() const { return lua_; }

    private:
        State& state_;
        lua_State* outer_;  // of the entry around this one
        lua_State* lua_;
    };

    /** The same without a Lua thread, for what is not Lua code. */
    class Lock {
    public:
        explicit Lock(State& state) : state_(state) { state.enter(); }
        ~Lock() { state_.exit(); }
        Lock(const Lock&) = delete;
        Lock& operator=(const Lock&) = delete;

    private:
        State& state_;
    };

    /** While one exists, this thread, which is inside, has left for other threads. */
    class Leave {
    public:
        explicit Leave(State& state);
        ~Leave();
        Leave(const Leave&) = delete;
        Leave& operator=(const Leave&) = delete;

    private:
        State& state_;
        const unsigned depth_;
        lua_State* const lua_;
        const std::int64_t since_;
        const std::int64_t deadline_;
        const RTT::internal::ScriptPlace noPlace_{nullptr, nullptr};
    };

    /** Lua code that runs longer than this many seconds without a call of C++ fails; 0 for no limit. For the outermost
        entry of this thread. */
    class Limit {
    public:
        Limit(State& state, double seconds);
        ~Limit();
        Limit(const Limit&) = delete;
        Limit& operator=(const Limit&) = delete;

    private:
        State& state_;
        const std::int64_t outer_;
    };

    /** Ends the Lua code that is running, with an error. May be called in a signal handler. */
    void interrupt() noexcept { interrupted_.store(true, std::memory_order_relaxed); }
    /** Forgets an interruption that came when no Lua code ran. */
    void clearInterrupt() noexcept { interrupted_.store(false, std::memory_order_relaxed); }

    /** Inside: raises an error of Lua if the code that runs was interrupted, or has passed its limit. */
    void look(lua_State* lua);
    /** Inside: as interrupt(), and no further instruction of this Lua thread is executed. */
    void end(lua_State* lua);
    /** Inside: the next instruction of this Lua thread looks, see look(). */
    void lookSoon(lua_State* lua) { countTo(lua, 1); }

    /** For functions of the engine and operations in Lua that the component's thread executes: the limit of hooks. */
    std::atomic<double> limit{0};

    /** Inside: calls the function below its arguments on the stack. False if it fails; then the message, with a
        traceback if `traced`, is the only value left of them. */
    bool call(lua_State* lua, int arguments, int results, bool traced = false);
    /** Calls `function(lua)` in the calling thread, where errors of Lua are caught. False if it fails, with the message
        in `error`. Outside of this, and of call(), an error of Lua ends the process; even the lack of memory is one. */
    template <class Function>
    bool protect(std::string& error, Function&& function) {
        void* const data = const_cast<void*>(static_cast<const void*>(&function));
        return protectCall(&guarded<&State::invoke<std::remove_reference_t<Function>>>, data, error);
    }
    /** Runs a file or a text in the calling thread. False if it fails, with the message in `error`. */
    bool runFile(const std::string& file, std::string& error);
    bool runText(const std::string& text, const std::string& name, std::string& error);
    /** Only compiles. Empty if that is possible, otherwise the message. */
    std::string check(const std::string& file);

    /** Inside: what becomes of values of this type. */
    const Conversion& conversion(const RTT::types::TypeInfo* type);
    RTT::TaskContext& owner() const { return owner_; }
    /** The engine for which operations are called. */
    RTT::ExecutionEngine* caller() const;
    OwnedThings& owned() { return *owned_; }
    /** Inside, before Lua code makes a port, property or attribute: destroys those that it no longer uses, if they are
        many. Leaves for that. */
    void makeRoom();
    /** Inside: a hook that goes on when no Lua code knows it any more. The state's end disables it. */
    void keep(std::shared_ptr<EngineHook> hook);
    Memory& memory() { return *memory_; }
    /** For the memory: a request was refused. Lua itself collects nothing then. */
    void refused();
    /** Bytes in use by Lua. Any thread. */
    std::size_t bytes();

    /** Inside: operations of components and services hide methods of the same name, see operation_lookup.hpp. */
    bool operationsFirst = false;

private:
    friend class Entry;
    template <class Function>
    static int invoke(lua_State* lua) {
        (*static_cast<Function*>(lua_touserdata(lua, 1)))(lua);
        return 0;
    }
    bool protectCall(lua_CFunction function, void* data, std::string& error);
    bool protectCall(lua_State* lua, lua_CFunction function, void* data, std::string& error);
    void collectAll(lua_State* lua);
    void makeThread();
    void lock();
    void enter();
    void exit();
    lua_State* takeThread();
    void giveBack(lua_State* lua);
    static void onCount(lua_State* lua, lua_Debug* where);
    void failIfAsked(lua_State* lua, int level);
    void countTo(lua_State* lua, int instructions);

    RTT::TaskContext& owner_;
    const bool exactLines_ = RTT::internal::ScriptPlace::isExactWanted();
    const std::unique_ptr<Memory> memory_;
    std::unique_ptr<OwnedThings> owned_;
    std::vector<std::shared_ptr<EngineHook>> hooks_;
    RTT::os::Mutex mutex_;
    std::atomic<std::thread::id> inside_{};
    unsigned depth_ = 0;  // entries of the thread inside
    lua_State* main_ = nullptr;
    bool mainTaken_ = false;
    lua_State* current_ = nullptr;  // of the entry of the thread inside
    bool refused_ = false;
    std::vector<lua_State*> idle_;
    std::atomic<bool> interrupted_{false};
    std::int64_t deadline_ = 0;  // monotonic, ns; 0 for none
    std::unordered_map<const RTT::types::TypeInfo*, std::unique_ptr<Conversion>> conversions_;
};

}  // namespace OCL::lua

#endif
