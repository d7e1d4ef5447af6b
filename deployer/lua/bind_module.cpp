// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The functions of the module `rtt`.
#include "bindings.hpp"
#include "box.hpp"
#include "operation_lookup.hpp"
#include "state.hpp"
#include "things.hpp"
#include "values.hpp"

#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/os/fosi.h>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/types/GlobalsRepository.hpp>
#include <rtt/types/TypeInfoRepository.hpp>

#include <time.h>

namespace OCL::lua {

namespace {

constexpr std::int64_t kSecond = 1000000000;

int getTime(lua_State* lua) {
    const std::int64_t now = rtos_get_time_ns();
    lua_pushnumber(lua, static_cast<lua_Number>(now / kSecond));
    lua_pushnumber(lua, static_cast<lua_Number>(now % kSecond));
    return 2;
}

int sleep(lua_State* lua) {
    const lua_Number seconds = luaL_checknumber(lua, 1), rest = luaL_optnumber(lua, 2, 0);
    const lua_Number all = seconds * static_cast<lua_Number>(kSecond) + rest;
    if (!(all >= 0 && all < 9e18)) throw Failure("cannot sleep for " + std::to_string(seconds) + " s");
    State& state = State::of(lua);
    const std::int64_t end = rtos_get_time_ns() + static_cast<std::int64_t>(all);
    // In pieces, so that an interruption ends it.
    for (std::int64_t left = end - rtos_get_time_ns(); left > 0; left = end - rtos_get_time_ns()) {
        {
            const State::Leave leave(state);
            const std::int64_t piece = std::min(left, kSecond / 20);
            const timespec time{static_cast<time_t>(piece / kSecond), static_cast<long>(piece % kSecond)};
            nanosleep(&time, nullptr);
        }
        state.look(lua);
    }
    return 0;
}

int getTC(lua_State* lua) {
    pushTask(lua, State::of(lua).owner());
    return 1;
}

int globalNames(lua_State* lua) {
    pushTexts(lua, RTT::types::GlobalsRepository::Instance()->getAttributeNames());
    return 1;
}

int globalProperties(lua_State* lua) {
    std::vector<std::string> names;
    for (const RTT::base::PropertyBase* const one :
         RTT::types::GlobalsRepository::Instance()->properties()->getProperties())
        names.push_back(one->getName());
    pushTexts(lua, names);
    return 1;
}

int getGlobal(lua_State* lua) {
    const std::string name = textAt(lua, 1);
    RTT::types::GlobalsRepository& globals = *RTT::types::GlobalsRepository::Instance();
    if (const RTT::base::AttributeBase* const attribute = globals.getValue(name))
        pushValue(lua, attribute->getDataSource(), Life());
    else if (const RTT::base::PropertyBase* const property = globals.getProperty(name))
        pushValue(lua, property->getDataSource(), Life());
    else
        lua_pushnil(lua);
    return 1;
}

int provides(lua_State* lua) {
    RTT::Service::shared_ptr service = RTT::internal::GlobalService::Instance();
    for (int i = 1; i <= lua_gettop(lua); ++i) {
        const std::string name = textAt(lua, i);
        RTT::Service::shared_ptr next = service->getService(name);
        if (!next) throw Failure("there is no global service '" + name + "'; import the package that has it");
        service = next;
    }
    pushService(lua, service);
    return 1;
}

int services(lua_State* lua) {
    pushTexts(lua, RTT::plugin::PluginLoader::Instance()->listServices());
    return 1;
}

int typekits(lua_State* lua) {
    pushTexts(lua, RTT::plugin::PluginLoader::Instance()->listTypekits());
    return 1;
}

int types(lua_State* lua) {
    pushTexts(lua, RTT::types::Types()->getTypes());
    return 1;
}

constexpr const char* kLevels[] = {"Never", "Fatal", "Critical", "Error", "Warning", "Info", "Debug", "RealTime"};

RTT::Logger::LogLevel levelAt(lua_State* lua, int index) {
    const std::string wanted = textAt(lua, index);
    std::string known;
    for (std::size_t i = 0; i != std::size(kLevels); ++i) {
        if (wanted == kLevels[i]) return static_cast<RTT::Logger::LogLevel>(i);
        known += (i ? ", " : "") + std::string(kLevels[i]);
    }
    throw Failure("there is no log level '" + wanted + "', but " + known);
}

int setLogLevel(lua_State* lua) {
    RTT::Logger::Instance()->setLogLevel(levelAt(lua, 1));
    return 0;
}

int getLogLevel(lua_State* lua) {
    const auto level = static_cast<std::size_t>(RTT::Logger::Instance()->getLogLevel());
    lua_pushstring(lua, level < std::size(kLevels) ? kLevels[level] : "Never");
    return 1;
}

std::string textsFrom(lua_State* lua, int index) {
    std::string line;
    for (; index <= lua_gettop(lua); ++index) line += textAt(lua, index);
    return line;
}

int log(lua_State* lua) {
    RTT::Logger::log() << textsFrom(lua, 1) << RTT::endlog();
    return 0;
}

int logAt(lua_State* lua) {
    const RTT::Logger::LogLevel level = levelAt(lua, 1);
    RTT::log(level) << textsFrom(lua, 2) << RTT::endlog();
    return 0;
}

/** rtt.Variable("int") is rtt.Variable.new("int"). In C++, so that errors name the line of the script. */
int callNew(lua_State* lua) {
    lua_remove(lua, 1);
    return lua_tocfunction(lua, lua_upvalueindex(1))(lua);
}

/** Makes the table of methods on top callable, if it has `new`. */
void makeCallable(lua_State* lua) {
    lua_newtable(lua);
    lua_getfield(lua, -2, "new");
    if (lua_isnil(lua, -1)) return lua_pop(lua, 2);
    lua_pushcclosure(lua, &callNew, 1);
    lua_setfield(lua, -2, "__call");
    lua_setmetatable(lua, -2);
}

const luaL_Reg kFunctions[] = {{"getTime", &guarded<&getTime>},
                               {"sleep", &guarded<&sleep>},
                               {"getTC", &guarded<&getTC>},
                               {"globals_getNames", &guarded<&globalNames>},
                               {"globals_getProperties", &guarded<&globalProperties>},
                               {"globals_get", &guarded<&getGlobal>},
                               {"provides", &guarded<&provides>},
                               {"services", &guarded<&services>},
                               {"typekits", &guarded<&typekits>},
                               {"types", &guarded<&types>},
                               {"setLogLevel", &guarded<&setLogLevel>},
                               {"getLogLevel", &guarded<&getLogLevel>},
                               {"log", &guarded<&log>},
                               {"logl", &guarded<&logAt>},
                               {"operations_first", &operationsFirst},
                               {nullptr, nullptr}};

}  // namespace

void openModule(lua_State* lua) {
    // Makes the global table, and registers it for require().
    luaL_register(lua, "rtt", kFunctions);
    const struct {
        const char* name;
        void (*bind)(lua_State*);
    } kinds[] = {{"Variable", &bindVariable},
                 {"Property", &bindProperty},
                 {"Attribute", &bindAttribute},
                 {"InputPort", &bindInputPort},
                 {"OutputPort", &bindOutputPort},
                 {"Operation", &bindOperation},
                 {"SendHandle", &bindSendHandle},
                 {"Service", &bindService},
                 {"ServiceRequester", &bindRequester},
                 {"TaskContext", &bindTask},
                 {"EEHook", &bindHook}};
    for (const auto& kind : kinds) {
        kind.bind(lua);
        makeCallable(lua);
        lua_setfield(lua, -2, kind.name);
    }
    lua_pop(lua, 1);
}

}  // namespace OCL::lua
