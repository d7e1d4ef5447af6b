// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "state.hpp"

#include "conversion.hpp"
#include "engine_hook.hpp"
#include "open_libraries.hpp"
#include "owned_things.hpp"

#include <rtt/ExecutionEngine.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/engine/interruption.hpp>
#include <rtt/os/fosi.h>

#include <algorithm>
#include <exception>

namespace OCL::lua {

namespace {

// So many instructions pass between two looks at interruptions and time limits.
constexpr int kInstructions = 1000;

// Nested calls Lua → C++ → Lua of one thread use its stack; Lua itself knows nothing of them.
constexpr unsigned kDeepest = 150;
thread_local unsigned nesting __attribute__((tls_model("initial-exec"))) = 0;

}  // namespace

State::State(RTT::TaskContext& owner, std::unique_ptr<Memory> memory)
    : owner_(owner), memory_(std::move(memory)), owned_(new OwnedThings) {
    memory_->state = this;
    main_ = lua_newstate(&Memory::allocate, memory_.get());
    if (!main_) throw std::bad_alloc();
    countTo(main_, kInstructions);
    std::string error;
    try {
        if (protect(error, [this](lua_State* lua) {
                openLibraries(lua);
                makeThread();
            }))
            return;
    } catch (...) {
        lua_close(main_);
        throw;
    }
    lua_close(main_);
    throw std::runtime_error("Lua cannot be started: " + error);
}

State::~State() {
    // Their functions may be waiting for this state.
    for (const auto& hook : hooks_) hook->disable();
    const Lock lock(*this);
    lua_sethook(main_, nullptr, 0, 0);
    lua_close(main_);
}

/** So that --rt-check reports only what waits for another thread. */
void State::lock() {
    if (!mutex_.trylock()) mutex_.lock();
}

void State::enter() {
    const std::thread::id self = std::this_thread::get_id();
    if (inside_.load(std::memory_order_relaxed) != self) {
        lock();
        inside_.store(self, std::memory_order_relaxed);
    }
    ++depth_;
}

void State::exit() {
    if (--depth_ != 0) return;
    std::vector<std::function<void()>> unused = owned_->takeUnused();
    inside_.store(std::thread::id(), std::memory_order_relaxed);
    mutex_.unlock();
    // Destroying a port waits for callbacks, which may wait for this state.
    for (const auto& destroy : unused) destroy();
}

void State::makeRoom() {
    // They are destroyed when the outermost entry ends, which a program's may never do.
    constexpr std::size_t kMany = 100;
    if (owned_->unused() < kMany) return;
    const std::vector<std::function<void()>> unused = owned_->takeUnused();
    const Leave leave(*this);
    for (const auto& destroy : unused) destroy();
}

State::Entry::Entry(State& state) : state_(state) {
    if (nesting == kDeepest) throw Failure("Lua and C++ call each other too deeply");
    state.enter();
    try {
        lua_ = state.takeThread();
    } catch (...) {
        state.exit();
        throw;
    }
    outer_ = state.current_;
    state.current_ = lua_;
    ++nesting;
}

State::Entry::~Entry() {
    state_.current_ = outer_;
    state_.giveBack(lua_);
    state_.exit();
    --nesting;
}

State::Leave::Leave(State& state)
    : state_(state),
      depth_(state.depth_),
      lua_(state.current_),
      since_(state.deadline_ ? rtos_get_time_ns() : 0),
      deadline_(state.deadline_) {
    state.depth_ = 0;
    state.current_ = nullptr;
    state.deadline_ = 0;
    state.inside_.store(std::thread::id(), std::memory_order_relaxed);
    state.mutex_.unlock();
}

State::Leave::~Leave() {
    state_.lock();
    state_.inside_.store(std::this_thread::get_id(), std::memory_order_relaxed);
    state_.depth_ = depth_;
    state_.current_ = lua_;
    state_.deadline_ = deadline_ ? deadline_ + (rtos_get_time_ns() - since_) : 0;
}

State::Limit::Limit(State& state, double seconds) : state_(state), outer_(state.deadline_) {
    constexpr double kForEver = 1e9;
    if (seconds > 0 && seconds < kForEver && !outer_)
        state.deadline_ = rtos_get_time_ns() + static_cast<std::int64_t>(seconds * 1e9);
}

State::Limit::~Limit() { state_.deadline_ = outer_; }

// The main thread comes first: only in that coroutine.running() gives nil.
lua_State* State::takeThread() {
    if (!mainTaken_) {
        mainTaken_ = true;
        lua_settop(main_, 0);
        return main_;
    }
    if (idle_.empty()) {
        std::string error;
        auto make = [this](lua_State*) { makeThread(); };
        if (!protectCall(main_, &guarded<&State::invoke<decltype(make)>>, &make, error)) throw std::bad_alloc();
    }
    lua_State* const taken = idle_.back();
    idle_.pop_back();
    return taken;
}

void State::makeThread() {
    lua_State* const made = lua_newthread(main_);
    // Kept for good, under a key that is its own.
    lua_pushlightuserdata(main_, made);
    lua_insert(main_, -2);
    lua_rawset(main_, LUA_REGISTRYINDEX);
    idle_.push_back(made);
}

void State::giveBack(lua_State* lua) {
    lua_settop(lua, 0);
    // Lua code may have changed it by debug.sethook().
    if (lua_gethook(lua) != &State::onCount || lua_gethookcount(lua) != kInstructions) countTo(lua, kInstructions);
    if (lua == main_)
        mainTaken_ = false;
    else
        idle_.push_back(lua);
    if (depth_ == 1 && !mainTaken_) interrupted_.store(false, std::memory_order_relaxed);
}

void State::onCount(lua_State* lua, lua_Debug* where) {
    if (where->event == LUA_HOOKCOUNT) of(lua).failIfAsked(lua, 0);
}

void State::look(lua_State* lua) { failIfAsked(lua, 1); }

/** The message has the place of the caller at this level of the stack. */
void State::failIfAsked(lua_State* lua, int level) {
    if (refused_) {
        refused_ = false;
        (void)lua_gc(lua, LUA_GCCOLLECT, 0);
    }
    const RTT::internal::Interruption* const asked = RTT::internal::Interruption::ofThisThread();
    const bool interrupted = interrupted_.load(std::memory_order_relaxed) || (asked && asked->asked());
    if (!interrupted && !(deadline_ && rtos_get_time_ns() > deadline_)) {
        if (lua_gethook(lua) == &State::onCount && lua_gethookcount(lua) != kInstructions) countTo(lua, kInstructions);
        return;
    }
    // The next instruction fails, too, so that no pcall() around it goes on.
    countTo(lua, 1);
    luaL_where(lua, level);
    lua_pushstring(lua, interrupted ? "interrupted" : "this takes too long: the time limit has passed");
    lua_concat(lua, 2);
    lua_error(lua);
}

void State::refused() {
    refused_ = true;
    // Code that catches the error needs memory soon.
    if (current_) countTo(current_, 1);
}

void State::countTo(lua_State* lua, int instructions) {
    // Between hooks for lines, Lua itself does not note where it is.
    lua_sethook(lua, &State::onCount, LUA_MASKCOUNT | (exactLines_ ? LUA_MASKLINE : 0), instructions);
}

void State::end(lua_State* lua) {
    interrupt();
    countTo(lua, 1);
}

void State::keep(std::shared_ptr<EngineHook> hook) {
    hooks_.erase(std::remove_if(hooks_.begin(), hooks_.end(),
                                [](const auto& known) { return known.use_count() == 1 && !known->isLoaded(); }),
                 hooks_.end());
    hooks_.push_back(std::move(hook));
}

const Conversion& State::conversion(const RTT::types::TypeInfo* type) {
    std::unique_ptr<Conversion>& known = conversions_[type];
    if (!known) known.reset(new Conversion(type));
    return *known;
}

RTT::ExecutionEngine* State::caller() const { return owner_.engine(); }

std::size_t State::bytes() {
    const Entry entry(*this);
    return static_cast<std::size_t>(lua_gc(entry.lua(), LUA_GCCOUNT, 0)) * 1024 +
           static_cast<std::size_t>(lua_gc(entry.lua(), LUA_GCCOUNTB, 0));
}

}  // namespace OCL::lua
