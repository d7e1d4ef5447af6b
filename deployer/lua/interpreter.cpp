// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "interpreter.hpp"

#include <cstdlib>
#include <stdexcept>
#include <utility>

#include <signal.h>
#include <unistd.h>

namespace OCL::lua {

namespace {

/** Lua's way to say that a chunk is not complete. */
constexpr const char kEndOfText[] = "'<eof>'";

constexpr const char* kEnds = "the program ends";

char selfKey;

/** For os.exit(), which may be called after the interpreter has ended. */
void setSelf(lua_State* lua, Interpreter* self) {
    lua_pushlightuserdata(lua, &selfKey);
    lua_pushlightuserdata(lua, self);
    lua_rawset(lua, LUA_REGISTRYINDEX);
}

bool endsWith(const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/** Without a first line that is for the system; its end stays, so that lines keep their numbers. */
void dropFirstComment(std::string& code) {
    if (code.empty() || code[0] != '#') return;
    const std::size_t end = code.find('\n');
    code.erase(0, end);
    if (code.size() > 1 && code[1] == LUA_SIGNATURE[0]) code.erase(0, 1);  // a compiled chunk begins there
}

/** The error on the stack as text. */
std::string textOf(lua_State* lua) {
    if (lua_isstring(lua, -1)) return lua_tostring(lua, -1);
    if (luaL_callmeta(lua, -1, "__tostring")) {
        if (lua_isstring(lua, -1)) {
            const std::string text = lua_tostring(lua, -1);
            lua_pop(lua, 1);
            return text;
        }
        lua_pop(lua, 1);
    }
    return std::string("(error object is a ") + luaL_typename(lua, -1) + " value)";
}

int makeText(lua_State* lua) {
    lua_pushstring(lua, textOf(lua).c_str());
    return 1;
}

}  // namespace

Interpreter::Interpreter(State& state, std::string program)
    : state_(state), program_(std::move(program)), thread_(std::this_thread::get_id()) {
    std::string error;
    const bool done = state_.protect(error, [this](lua_State* lua) {
        setSelf(lua, this);
        lua_getglobal(lua, "os");
        lua_pushcfunction(lua, &onExit);
        lua_setfield(lua, -2, "exit");
    });
    if (!done) throw std::runtime_error("os.exit() cannot be replaced: " + error);
}

Interpreter::~Interpreter() {
    std::string ignored;  // the key exists: this takes no memory
    (void)state_.protect(ignored, [](lua_State* lua) { setSelf(lua, nullptr); });
}

bool Interpreter::run(const std::function<void()>& body) {
    std::string error;
    // A function of C calls all code, as in other interpreters: that shows in tracebacks.
    const bool good = state_.protect(error, [&](lua_State* lua) {
        lua_settop(lua, 0);
        lua_ = lua;
        body();
    });
    lua_ = nullptr;
    if (!good && !ends()) complain(error);
    return good;
}

void Interpreter::complain(const std::string& message) const {
    std::fflush(stdout);
    std::fprintf(stderr, "%s%s%s\n", program_.c_str(), program_.empty() ? "" : ": ", message.c_str());
    std::fflush(stderr);
}

/** Writes the error on the stack, and removes it. */
void Interpreter::report() {
    if (!ends()) {
        lua_pushcfunction(lua_, &makeText);
        lua_insert(lua_, -2);
        if (lua_pcall(lua_, 1, 1, 0) == 0 || lua_isstring(lua_, -1))
            complain(lua_tostring(lua_, -1));
        else
            complain("an error that is no text");
    }
    lua_pop(lua_, 1);
}

/** Calls the function below its arguments on the stack. */
bool Interpreter::call(int arguments, int results) {
    const bool good = !ends() && state_.call(lua_, arguments, results, true);
    state_.clearInterrupt();
    if (good && !ends()) return true;
    report();
    return false;
}

bool Interpreter::loaded(int failure) {
    if (failure == 0) return true;
    report();
    return false;
}

bool Interpreter::text(const std::string& code, const std::string& name) {
    const bool good = loaded(luaL_loadbuffer(lua_, code.data(), code.size(), name.c_str())) && call(0, 0);
    lua_settop(lua_, 0);
    return good;
}

bool Interpreter::file(const std::string& file) {
    const bool good = loaded(luaL_loadfile(lua_, file.c_str())) && call(0, 0);
    lua_settop(lua_, 0);
    return good;
}

bool Interpreter::require(const std::string& module) {
    lua_getglobal(lua_, "require");
    lua_pushlstring(lua_, module.data(), module.size());
    const bool good = call(1, 0);
    lua_settop(lua_, 0);
    return good;
}

bool Interpreter::initialise() {
    const char* const init = std::getenv("LUA_INIT");
    if (!init) return true;
    return init[0] == '@' ? file(init + 1) : text(init, "=LUA_INIT");
}

bool Interpreter::script(const Words& words) {
    return loaded(luaL_loadfile(lua_, words.all[words.script].c_str())) && scriptLoaded(words);
}

bool Interpreter::script(const Words& words, std::string code) {
    dropFirstComment(code);
    return loaded(luaL_loadbuffer(lua_, code.data(), code.size(), "=stdin")) && scriptLoaded(words);
}

bool Interpreter::input(std::string code) {
    dropFirstComment(code);
    return text(code, "=stdin");
}

/** Executes the function on the stack as a script. */
bool Interpreter::scriptLoaded(const Words& words) {
    const int count = static_cast<int>(words.all.size()), script = static_cast<int>(words.script);
    lua_newtable(lua_);
    int index = -script;
    for (const std::string& word : words.all) {
        lua_pushlstring(lua_, word.data(), word.size());
        lua_rawseti(lua_, -2, index++);
    }
    lua_setglobal(lua_, "arg");
    luaL_checkstack(lua_, count, "too many arguments to script");
    for (std::size_t i = words.script + 1; i < words.all.size(); ++i)
        lua_pushlstring(lua_, words.all[i].data(), words.all[i].size());
    const bool good = call(count - script - 1, 0);
    lua_settop(lua_, 0);
    return good;
}

bool Interpreter::goesOn(const std::string& statement) {
    const int failure = luaL_loadbuffer(lua_, statement.data(), statement.size(), "=stdin");
    const bool more = failure == LUA_ERRSYNTAX && endsWith(lua_tostring(lua_, -1), kEndOfText);
    lua_settop(lua_, 0);
    return more;
}

void Interpreter::typed(const std::string& statement) {
    if (loaded(luaL_loadbuffer(lua_, statement.data(), statement.size(), "=stdin")) && call(0, LUA_MULTRET)) {
        const int count = lua_gettop(lua_);
        if (count > 0) {
            lua_getglobal(lua_, "print");
            lua_insert(lua_, 1);
            (void)call(count, 0);
        }
    }
    lua_settop(lua_, 0);
    std::fflush(stdout);
}

std::string Interpreter::prompt(const char* variable, const char* otherwise) {
    // Raw: modules that find wrong names of variables make reading one that does not exist an error.
    lua_pushstring(lua_, variable);
    lua_rawget(lua_, LUA_GLOBALSINDEX);
    std::string text = lua_isstring(lua_, -1) ? lua_tostring(lua_, -1) : otherwise;
    lua_pop(lua_, 1);
    return text;
}

/** os.exit(): leaves all Lua code with errors that it cannot catch, so that the program ends in order. */
int Interpreter::onExit(lua_State* lua) {
    const int status = luaL_optint(lua, 1, EXIT_SUCCESS);
    lua_pushlightuserdata(lua, &selfKey);
    lua_rawget(lua, LUA_REGISTRYINDEX);
    if (!lua_touserdata(lua, -1)) return luaL_error(lua, kEnds);
    Interpreter& self = *static_cast<Interpreter*>(lua_touserdata(lua, -1));
    if (!self.ends_.exchange(true)) self.status_ = status;
    if (std::this_thread::get_id() == self.thread_) {
        self.state_.end(lua);
        if (self.lua_) self.state_.end(self.lua_);
    } else {
        // Of a component: the main thread may be executing code, or waiting for a line.
        kill(getpid(), SIGTERM);
    }
    return luaL_error(lua, kEnds);
}

}  // namespace OCL::lua
