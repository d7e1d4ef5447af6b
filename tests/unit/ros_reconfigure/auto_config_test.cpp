// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The properties that a component happens to have, with clients of dynamic_reconfigure.
#include "reconfigure_fixture.hpp"

#include "../flow/log_capture.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/types/StructTypeInfo.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cfloat>
#include <climits>
#include <thread>

struct Gains {
    double p = 1;
    float i = 0.1f;
    int unused[2] = {};
};

namespace boost {
namespace serialization {
template <class Archive>
void serialize(Archive& archive, Gains& gains, unsigned) {
    archive& make_nvp("p", gains.p);
    archive& make_nvp("i", gains.i);
}
}  // namespace serialization
}  // namespace boost

namespace {

using namespace reconfigure_test;
using flow_test::LogCapture;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

struct Motor : RTT::TaskContext {
    explicit Motor(const std::string& name = "motor") : TaskContext(name) {
        RTT::types::Types()->addType(new RTT::types::StructTypeInfo<Gains>("/Gains"));
        addProperty("on", on).doc("Is it on?");
        addProperty("steps", steps).doc("How many.");
        addProperty("count", count);
        addProperty("speed", speed).doc("Metres per second.");
        addProperty("ratio", ratio);
        addProperty("label", label);
        addProperty("list", list);
        addProperty("gains", gains);
        limits.ownProperty(new RTT::Property<double>("top", "The highest.", 10));
        auto* const deep = new RTT::Property<RTT::PropertyBag>("deep", "");
        deep->set().ownProperty(new RTT::Property<std::string>("note", "", "n"));
        limits.ownProperty(deep);
        addProperty("limits", limits);
    }
    ~Motor() override { stop(); }
    double top() const { return limits.getPropertyType<double>("top")->get(); }
    bool on = false;
    int steps = 1;
    unsigned count = 3000000000u;
    double speed = 2.5;
    float ratio = 0.1f;
    std::string label = "x";
    std::vector<double> list;
    Gains gains;
    RTT::PropertyBag limits;
};

TEST(RosAutoConfig, DynparamListsGetsAndSets) {
    const Node node;
    Motor motor;
    serverOf(motor).advertise();
    RTT::Property<RTT::PropertyBag> max = motor.provides("reconfigure")->properties()->getProperty("max");
    max.rvalue().getPropertyType<double>("speed")->set(4);
    ASSERT_TRUE(motor.start());
    const std::vector<std::string> tool = {"rosrun", "dynamic_reconfigure", "dynparam"};
    const auto run = [&](std::vector<std::string> words) {
        words.insert(words.begin(), tool.begin(), tool.end());
        return RosMaster::tool(words);
    };
    EXPECT_EQ("/tester/motor\n", run({"list"}).out);
    const auto done = run({"set", "/tester/motor", "{'speed': 9.0, 'limits__top': 7, 'on': true, 'label': 'new'}"});
    EXPECT_EQ(0, done.status) << done.err;
    EXPECT_EQ(4, motor.speed);
    EXPECT_EQ(7, motor.top());
    EXPECT_TRUE(motor.on);
    EXPECT_EQ("new", motor.label);
    EXPECT_THAT(run({"get", "/tester/motor"}).out, AllOf(HasSubstr("'speed': 4.0"), HasSubstr("'gains__p': 1.0")));
}

TEST(RosAutoConfig, TheDescriptionHasTypesGroupsLimitsAndDefaults) {
    const Node node;
    Motor motor;
    ASSERT_TRUE(serverOf(motor).advertise("/m"));
    const ConfigDescription text = descriptionOf("/m");
    std::string all;
    for (const auto& group : text.groups) {
        all += group.name + '(' + std::to_string(group.id) + '/' + std::to_string(group.parent) + "):";
        for (const auto& one : group.parameters)
            all += ' ' + one.type + ' ' + one.name + '=' + std::to_string(one.level);
        all += '\n';
    }
    EXPECT_EQ(
        "Default(0/0): bool on=1 int steps=2 int count=4 double speed=8 double ratio=16 str label=32\n"
        "gains(1/0): double gains__p=64 double gains__i=128\n"
        "limits(2/0): double limits__top=256\n"
        "limits__deep(3/2): str limits__deep__note=512\n",
        all);
    EXPECT_EQ("Metres per second.", text.groups[0].parameters[3].description);
    EXPECT_EQ(std::to_string(INT_MIN), in(text.min, "steps"));
    EXPECT_EQ("0", in(text.min, "count"));
    EXPECT_EQ(std::to_string(INT_MAX), in(text.max, "count"));
    EXPECT_EQ("1", in(text.max, "on"));
    EXPECT_EQ(DBL_MAX, text.max.doubles[0].value);
    EXPECT_EQ(double(FLT_MAX), text.max.doubles[1].value);
    EXPECT_EQ("2.5", in(text.dflt, "speed"));
    EXPECT_EQ("n", in(text.dflt, "limits__deep__note"));
    const Config update = updateOf("/m");
    EXPECT_EQ("10", in(update, "limits__top"));
    ASSERT_EQ(4u, update.groups.size());
    EXPECT_EQ("limits__deep", update.groups[3].name);
    EXPECT_TRUE(update.groups[3].state);
}

TEST(RosAutoConfig, NumbersAreLimitedAndOthersStay) {
    const Node node;
    Motor motor;
    ASSERT_TRUE(serverOf(motor).advertise("/m"));
    ASSERT_TRUE(motor.start());
    Config got;
    ASSERT_TRUE(set("/m", a("count", -5) + a("ratio", 1e300) + a("gains__i", 2.0) + a("speed", 3), &got));
    EXPECT_EQ(0u, motor.count);
    EXPECT_EQ(FLT_MAX, motor.ratio);
    EXPECT_EQ(2.0f, motor.gains.i);
    EXPECT_EQ(3, motor.speed);
    EXPECT_EQ("0", in(got, "count"));
    EXPECT_EQ("3", in(updateOf("/m"), "speed"));
    motor.count = 3000000000u;
    ASSERT_TRUE(set("/m", a("count", INT_MAX) + a("steps", 4)));
    EXPECT_EQ(3000000000u, motor.count) << "a client cannot know that number, so it does not change it";
    EXPECT_EQ(4, motor.steps);
}

TEST(RosAutoConfig, AnImpossibleValueChangesNothing) {
    const Node node;
    Motor motor;
    ASSERT_TRUE(serverOf(motor).advertise("/m"));
    LogCapture log;
    EXPECT_FALSE(set("/m", a("steps", 7) + a("speed", std::numeric_limits<double>::quiet_NaN())));
    EXPECT_FALSE(set("/m", a("steps", 7) + a("none", 1)));
    EXPECT_FALSE(set("/m", a("steps", 7) + a("label", 1)));
    EXPECT_FALSE(set("/m", a("steps", 7.5)));
    EXPECT_THAT(log.finish(), AllOf(HasSubstr("'speed' is not a number"), HasSubstr("no parameter 'none' of type int"),
                                    HasSubstr("'label'"), HasSubstr("'steps' of type double"), HasSubstr("'motor'")));
    EXPECT_EQ(1, motor.steps);
}

struct Careful : Motor {
    Careful() : Motor("careful") {
        addOperation("updateProperties", &Careful::take, this, RTT::OwnThread);
        addOperation("notifyPropertiesUpdated", &Careful::told, this, RTT::OwnThread);
    }
    ~Careful() override { stop(); }
    bool take(const RTT::PropertyBag& bag, unsigned level) {
        isOwn = engine()->isSelf();
        if (bag.getPropertyType<int>("steps")->get() > 10) return false;
        if (bag.getPropertyType<int>("steps")->get() == 10) throw std::runtime_error("ten");
        levels = level;
        return RTT::updateProperties(*properties(), bag);
    }
    void told(unsigned level) { notified = level; }
    std::atomic<bool> isOwn{false};
    std::atomic<unsigned> levels{0}, notified{0};
};

TEST(RosAutoConfig, AnOperationOfTheComponentDecides) {
    const Node node;
    Careful careful;
    ASSERT_TRUE(serverOf(careful).advertise());
    ASSERT_TRUE(careful.start());
    ASSERT_TRUE(set("/tester/careful", a("steps", 5) + a("limits__top", 8.5) + a("speed", 2.5)));
    EXPECT_TRUE(careful.isOwn);
    EXPECT_EQ(2u + 256u, careful.levels);
    EXPECT_EQ(2u + 256u, careful.notified);
    EXPECT_EQ(5, careful.steps);
    EXPECT_EQ(8.5, careful.top());
    LogCapture log;
    EXPECT_FALSE(set("/tester/careful", a("steps", 11) + a("speed", 1)));
    EXPECT_FALSE(set("/tester/careful", a("steps", 10)));
    EXPECT_THAT(log.finish(), AllOf(HasSubstr("updateProperties() refuses"), HasSubstr("ten")));
    EXPECT_EQ(5, careful.steps);
    EXPECT_EQ(2.5, careful.speed);
    EXPECT_EQ("5", in(updateOf("/tester/careful"), "steps"));
}

TEST(RosAutoConfig, ScriptsSetLimitsAndAdvertise) {
    const Node node;
    Motor motor;
    (void)serverOf(motor);
    ASSERT_TRUE(motor.loadService("scripting"));
    RTT::OperationCaller<bool(std::string)> eval(motor.provides("scripting")->getOperation("eval"));
    ASSERT_TRUE(
        eval("reconfigure.min.speed = -2.0; reconfigure.max.limits.top = 12.0; reconfigure.dflt.label = \"d\";"));
    ASSERT_TRUE(eval("reconfigure.advertise(\"\")"));
    ASSERT_TRUE(set("/tester/motor", a("speed", -5.0) + a("limits__top", 13.0)));
    EXPECT_EQ(-2, motor.speed);
    EXPECT_EQ(12, motor.top());
    ASSERT_TRUE(eval("reconfigure.updated(); reconfigure.refresh(); reconfigure.shutdown()"));
    EXPECT_FALSE(set("/tester/motor", a("speed", 0.0)));
}

TEST(RosAutoConfig, RefreshFollowsThePropertiesAndKeepsLimits) {
    const Node node;
    Motor motor;
    ServerBase& server = serverOf(motor);
    ASSERT_TRUE(server.advertise("/m"));
    RTT::Property<RTT::PropertyBag> min = server.properties()->getProperty("min");
    RTT::Property<double>* const speed = min.rvalue().getPropertyType<double>("speed");
    speed->set(-1);
    double extra = 5;
    motor.addProperty("extra", extra);
    motor.properties()->removeProperty(motor.getProperty("gains"));
    ASSERT_TRUE(server.refresh());
    EXPECT_EQ(speed, min.rvalue().getPropertyType<double>("speed"));
    EXPECT_EQ(nullptr, min.rvalue().getProperty("gains"));
    const ConfigDescription text = descriptionOf("/m");
    EXPECT_EQ("-1", in(text.min, "speed"));
    EXPECT_EQ("5", in(text.dflt, "extra"));
    EXPECT_EQ("-", in(text.max, "gains__p"));
    ASSERT_TRUE(set("/m", a("speed", -3.0) + a("extra", 6.0)));
    EXPECT_EQ(-1, motor.speed);
    EXPECT_EQ(6, extra);
    motor.label = "mine";
    ASSERT_TRUE(server.updated());
    EXPECT_EQ("mine", in(updateOf("/m"), "label"));
    EXPECT_EQ("x", in(descriptionOf("/m").dflt, "label")) << "defaults are those of the last refresh()";
}

/** Two properties that are always equal. */
struct Pair : RTT::TaskContext {
    Pair() : TaskContext("pair") {
        addProperty("left", left);
        addProperty("right", right);
        setPeriod(0.0005);
    }
    ~Pair() override { stop(); }
    void updateHook() override {
        if (left != right) ++broken;
        ++updates;
    }
    int left = 0, right = 0;
    std::atomic<int> broken{0}, updates{0};
};

TEST(RosAutoConfig, ManyClientsNeverChangeHalfOfASet) {
    const Node node;
    Pair pair;
    ServerBase& server = serverOf(pair);
    ASSERT_TRUE(server.advertise("/p"));
    ASSERT_TRUE(pair.start());
    std::vector<std::thread> clients;
    for (int i = 1; i != 4; ++i)
        clients.emplace_back([i] {
            for (int k = 0; k != 50; ++k) EXPECT_TRUE(set("/p", a("left", i * 1000 + k) + a("right", i * 1000 + k)));
        });
    for (int k = 0; k != 50; ++k) {
        EXPECT_TRUE(server.updated());
        EXPECT_TRUE(server.refresh());
    }
    for (std::thread& client : clients) client.join();
    EXPECT_EQ(0, pair.broken);
    EXPECT_GT(pair.updates, 0);
    pair.stop();
    EXPECT_EQ(std::to_string(pair.left), in(updateOf("/p"), "left")) << "the last update is published last";
}

}  // namespace
