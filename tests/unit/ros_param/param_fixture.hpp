// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component with the service rosparam, in a process that is a node of a master of its own.
#ifndef TESTS_UNIT_ROS_PARAM_FIXTURE_HPP
#define TESTS_UNIT_ROS_PARAM_FIXTURE_HPP

#include <support/ros_master.hpp>

#include <ros/init.h>
#include <ros/param.h>
#include <rtt/Logger.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/plugin/PluginLoader.hpp>

#include <sstream>

#include "../types/builtin_typekit.hpp"
#include "../types/sample_types.hpp"

namespace param_test {

typedef XmlRpc::XmlRpcValue Value;

/** What the console would show, during a test. */
class LogText {
public:
    LogText() { RTT::Logger::Instance()->setStdStream(text_); }
    ~LogText() { RTT::Logger::Instance()->setStdStream(std::cerr); }
    LogText(const LogText&) = delete;
    LogText& operator=(const LogText&) = delete;
    std::string take() {
        const std::string text = text_.str();
        text_.str("");
        return text;
    }

private:
    std::ostringstream text_;
};

/** Calls one of the operations of the service by name. */
template <class... Arguments>
bool call(RTT::TaskContext& component, const std::string& operation, const Arguments&... arguments) {
    RTT::OperationCaller<bool(
        typename std::conditional_t<std::is_arithmetic_v<Arguments>, Arguments, const std::string&>...)>
        caller(component.provides("rosparam")->getOperation(operation));
    EXPECT_TRUE(caller.ready()) << operation;
    return caller.ready() && caller(arguments...);
}

/** Makes this process the node /n. */
inline void becomeNode() {
    if (!ros::isInitialized()) ros::init(ros::M_string{}, "n", ros::init_options::NoSigintHandler);
}

inline void loadTypes() {
    static const bool isLoaded = [] {
        std::string error;
        sample::addTypes();
        return RTT::plugin::PluginLoader::Instance()->loadLibrary(ROSPARAM_FILE, error) || !error.empty();
    }();
    (void)isLoaded;
}

class WithService : public types_test::WithBuiltinTypes {
protected:
    void SetUp() override {
        loadTypes();
        ASSERT_TRUE(component_.loadService("rosparam")) << log_.take();
    }

    LogText log_;
    RTT::TaskContext component_{"c"};
};

class WithMaster : public WithService {
protected:
    static void SetUpTestSuite() {
        WithService::SetUpTestSuite();
        static oroforge::test::RosMaster master;
        becomeNode();
    }
    void SetUp() override {
        WithService::SetUp();
        ros::param::del("/n");
    }

    /** Is the property of type T set from this parameter, and to what? */
    template <class T>
    T got(const Value& parameter, T before, bool isGood = true) {
        RTT::TaskContext component("c");
        component.addProperty("p", before);
        EXPECT_TRUE(component.loadService("rosparam"));
        ros::param::set("/n/c/p", parameter);
        EXPECT_EQ(isGood, call(component, "getAll")) << parameter.toXml() << log_.take();
        EXPECT_EQ(isGood, call(component, "getComponentPrivate", std::string("p"))) << parameter.toXml();
        return before;
    }
    /** The parameter that a property of this value sets. */
    template <class T>
    Value made(T value, bool isGood = true) {
        RTT::TaskContext component("c");
        component.addProperty("p", value);
        EXPECT_TRUE(component.loadService("rosparam"));
        ros::param::del("/n/c/p");
        EXPECT_EQ(isGood, call(component, "setAll")) << log_.take();
        Value parameter;
        ros::param::get("/n/c/p", parameter);
        return parameter;
    }
};

/** An array. */
template <class... Elements>
Value array(const Elements&... elements) {
    Value made;
    made.setSize(0);
    int i = 0;
    ((made[i++] = Value(elements)), ...);
    return made;
}

}  // namespace param_test

#endif
