// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "service_fixture.hpp"

#include <rtt/Logger.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/types/StructTypeInfo.hpp>
#include <rtt/types/Types.hpp>
#include <rtt_roscomm/message_table.hpp>

#include <ros/ros.h>

namespace boost::serialization {
template <class A>
void serialize(A&, std_srvs::EmptyRequest&, unsigned) {}
template <class A>
void serialize(A&, std_srvs::EmptyResponse&, unsigned) {}
template <class A>
void serialize(A& a, std_srvs::SetBoolRequest& m, unsigned) {
    a& make_nvp("data", m.data);
}
template <class A>
void serialize(A& a, std_srvs::SetBoolResponse& m, unsigned) {
    a& make_nvp("success", m.success);
    a& make_nvp("message", m.message);
}
}  // namespace boost::serialization

namespace service_test {

namespace {

const rtt_roscomm::ServiceEntry entries[] = {
    {"std_srvs/Empty", "d41d8cd98f00b204e9800998ecf8427e", "/std_srvs/EmptyRequest", "/std_srvs/EmptyResponse"},
    {"std_srvs/SetBool", "09fb03525b03e7ea1fd3992bafd87e16", "/std_srvs/SetBoolRequest", "/std_srvs/SetBoolResponse"},
    // Its types are missing, so only the short signatures work.
    {"std_srvs/Trigger", "937c9679a518e3a18d831e57125ea522", "/std_srvs/TriggerRequest", "/std_srvs/TriggerResponse"},
};

struct Node {
    explicit Node(const ros::M_string& remapped) {
        ros::init(remapped, "pumps", ros::init_options::NoSigintHandler);
        ros::start();
        spinner = std::make_unique<ros::AsyncSpinner>(3);
        spinner->start();
    }
    ~Node() {
        spinner->stop();
        ros::shutdown();
    }
    RosMaster master;
    std::unique_ptr<ros::AsyncSpinner> spinner;
};

}  // namespace

RosMaster& master(const std::map<std::string, std::string>& remapped) {
    static Node node(remapped);
    return node.master;
}

void loadServices() {
    static const bool once = [] {
        for (const char* file : {RTT_TYPEKIT_FILE, REGISTRY_FILE, ROSSERVICE_FILE})
            if (!RTT::plugin::PluginLoader::Instance()->loadLibrary(file)) return false;
        using RTT::types::StructTypeInfo;
        RTT::types::Types()->addType(new StructTypeInfo<std_srvs::EmptyRequest>("/std_srvs/EmptyRequest"));
        RTT::types::Types()->addType(new StructTypeInfo<std_srvs::EmptyResponse>("/std_srvs/EmptyResponse"));
        RTT::types::Types()->addType(new StructTypeInfo<std_srvs::SetBoolRequest>("/std_srvs/SetBoolRequest"));
        RTT::types::Types()->addType(new StructTypeInfo<std_srvs::SetBoolResponse>("/std_srvs/SetBoolResponse"));
        rtt_roscomm::addServices(entries, std::size(entries));
        return true;
    }();
    ASSERT_TRUE(once);
}

LogText::LogText() { RTT::Logger::Instance()->setStdStream(text_); }
LogText::~LogText() {
    RTT::Logger::Instance()->setStdStream(std::cerr);
    std::cerr << text();
}

Pump::Pump(const std::string& name) : TaskContext(name) {
    const auto here = [this] { thread = std::this_thread::get_id(); };
    for (RTT::base::OperationCallerBaseInvoker* caller :
         {static_cast<RTT::base::OperationCallerBaseInvoker*>(&standard),
          static_cast<RTT::base::OperationCallerBaseInvoker*>(&quiet),
          static_cast<RTT::base::OperationCallerBaseInvoker*>(&odd)})
        requires_("away")->addOperationCaller(*caller);
    requires_()->addOperationCaller(withMessage);
    requires_()->addOperationCaller(plain);
    requires_()->addOperationCaller(asText);
    requires_()->addOperationCaller(trigger);
    requires_()->addOperationCaller(ping);
    requires_()->addOperationCaller(poke);

    const std::function<bool(std_srvs::SetBoolRequest&, std_srvs::SetBoolResponse&)> set =
        [this, here](std_srvs::SetBoolRequest& request, std_srvs::SetBoolResponse& response) {
            here();
            isOn = request.data != 0;
            response.success = isOn;
            response.message = isOn ? "pumping" : "";
            return true;
        };
    provides("own")->addOperation("standard", set, OwnThread);
    addOperation("client", set, ClientThread);
    const std::function<bool(bool, std::string&)> message = [this](bool on, std::string& text) {
        isOn = on;
        text = on ? "up" : "down";
        return on;
    };
    addOperation("setMessage", message);
    const std::function<bool(bool)> flag = [this](bool on) { return !(isOn = on); };
    addOperation("setFlag", flag);
    const std::function<std::string(bool)> text = [this](bool on) { return (isOn = on) ? "yes" : "no"; };
    addOperation("setText", text);
    const std::function<void(bool)> silent = [this](bool on) { isOn = on; };
    addOperation("setSilent", silent, OwnThread);
    const std::function<bool(std::string&)> report = [this](std::string& found) {
        found = isOn ? "on" : "off";
        return isOn;
    };
    addOperation("report", report);
    const std::function<bool()> ask = [this] { return isOn; };
    addOperation("ask", ask);
    const std::function<std::string()> tell = [] { return std::string("told"); };
    addOperation("tell", tell);
    const std::function<void()> flip = [this, here] {
        here();
        isOn = !isOn;
    };
    addOperation("flip", flip, OwnThread);
    const std::function<void()> fails = [] { throw std::runtime_error("no water"); };
    addOperation("fails", fails, ClientThread);
    const std::function<double(int)> half = [](int n) { return n / 2.0; };
    addOperation("half", half);
}

ServiceTest::ServiceTest() {
    loadServices();
    master();
    pump = std::make_unique<Pump>("pump");
    pump->services = pump->getProvider<rtt_roscomm::ROSService>("rosservice");
    if (!pump->services || !pump->services->ready()) throw std::runtime_error("no service rosservice");
    pump->start();
}

ServiceTest::~ServiceTest() = default;

std::string ServiceTest::listed() { return RosMaster::tool({"rosservice", "list"}).out; }

std::unique_ptr<ChildProcess> ServiceTest::startServer(const std::string& seconds) {
    oroforge::test::Command command;
    command.program = "/usr/bin/python3";
    command.arguments = {SERVER_SCRIPT, seconds};
    auto process = std::make_unique<ChildProcess>(command);
    EXPECT_TRUE(process->waitForOutput("ready", std::chrono::seconds(15)));
    return process;
}

}  // namespace service_test
