// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_LUA_FIXTURE_HPP
#define OROFORGE_TESTS_LUA_FIXTURE_HPP

#include "../components/library_fixture.hpp"

#include <ocl/LuaComponent.hpp>
#include <rtt/Attribute.hpp>
#include <rtt/Property.hpp>
#include <rtt/extras/SlaveActivity.hpp>

#include <fstream>

namespace lua_test {

/** A component that executes Lua code, in the thread of the test. */
class LuaTest : public components_test::WithLibrary {
protected:
    LuaTest() { component.setActivity(new RTT::extras::SlaveActivity(0.001)); }

    bool run(const std::string& code) { return component.exec_str(code); }
    /** What Lua makes of an expression, as text. */
    std::string value(const std::string& expression) {
        RTT::Property<std::string> result("", "");
        if (!component.getProperty("result")) {
            EXPECT_TRUE(run("local p = rtt.Property.new('string', 'result') rtt.getTC():addProperty(p)"));
        }
        if (!run("rtt.getTC():getProperty('result'):set(tostring(" + expression + "))")) return "(failed)";
        return RTT::Property<std::string>(component.getProperty("result")).get();
    }
    /** What is logged meanwhile. */
    template <class Action>
    std::string logged(Action action) {
        std::ostringstream text;
        RTT::Logger::Instance()->setStdStream(text);
        action();
        RTT::Logger::Instance()->setStdStream(std::cerr);
        return text.str();
    }
    template <class T>
    void set(const std::string& property, T value) {
        RTT::Property<T>(component.getProperty(property)).set(value);
    }

    OCL::LuaComponent component{"lua_component"};
};

}  // namespace lua_test

#endif
