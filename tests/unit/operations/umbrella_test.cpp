// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What user code finds with <rtt/RTT.hpp> alone.
#include <rtt/RTT.hpp>

// Besides, for RTT::detail.
#include <rtt/extras/rtt-extras-fwd.hpp>
#include <rtt/marsh/MarshallInterface.hpp>
#include <rtt/plugin/PluginLoader.hpp>

#include <gtest/gtest.h>

#include <type_traits>

using namespace Orocos;

namespace {

class Component : public RTT::TaskContext {
public:
    explicit Component(std::string const& name)
        : TaskContext(name, PreOperational), gain("gain", "a gain", 1.0), limit("limit", 2.0) {
        this->addOperation("twice", &Component::twice, this, RTT::OwnThread).doc("Doubles.").arg("x", "what");
        this->addEventPort("in", in, boost::bind(&Component::onData, this, _1));
        this->ports()->addPort("out", out).doc("results");
        this->addProperty(gain);
        this->addAttribute(limit);
    }
    ~Component() override { this->stop(); }
    double twice(double x) { return 2 * x; }
    void onData(RTT::base::PortInterface*) { ++events; }
    bool configureHook() override { return true; }

    RTT::InputPort<double> in;
    RTT::OutputPort<double> out;
    RTT::Property<double> gain;
    RTT::Attribute<double> limit;
    boost::shared_ptr<int> shared;
    boost::function<void(int)> function;
    RTT::ConnPolicy policy;
    RTT::os::Mutex mutex;
    std::map<std::string, std::vector<int>> table;
    int events = 0;
};

namespace everything {
using namespace RTT::detail;
static_assert(std::is_same_v<PortInterface, RTT::base::PortInterface>);
static_assert(std::is_same_v<ConnectionManager, RTT::internal::ConnectionManager>);
static_assert(std::is_same_v<TypeInfo, RTT::types::TypeInfo>);
static_assert(std::is_same_v<Mutex, RTT::os::Mutex>);
static_assert(std::is_same_v<SlaveActivity, RTT::extras::SlaveActivity>);
static_assert(std::is_same_v<PluginLoader, RTT::plugin::PluginLoader>);
static_assert(std::is_same_v<MarshallInterface, RTT::marsh::MarshallInterface>);
}  // namespace everything
static_assert(std::is_same_v<RTT::TimeService, RTT::os::TimeService>);

TEST(Umbrella, IsEnoughForAComponent) {
    Component c("component");
    EXPECT_TRUE(c.configure());
    OperationCaller<double(double)> twice = c.getOperation("twice");
    twice.setCaller(c.engine());
    EXPECT_EQ(twice(2.0), 4.0);
    RTT::os::MutexLock lock(c.mutex);
    std::stringstream text;
    text << std::sqrt(4.0) << strlen("ab");
    assert(text.str() == "22");
    Orocos::log(Orocos::Debug) << text.str() << Orocos::endlog();
    EXPECT_GT(RTT::os::TimeService::Instance()->getNSecs(), 0);
    const RTT::Seconds second = 1.0;
    EXPECT_EQ(RTT::Seconds_to_nsecs(second), 1000000000);
}

}  // namespace
