// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Properties that are parameters.
#include "param_fixture.hpp"

#include <ros/init.h>
#include <rtt_rosparam/ros_param_data_source.hpp>

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

namespace param_test {

using oroforge::test::RosMaster;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class ParameterProperty : public WithMaster {
protected:
    void SetUp() override {
        WithMaster::SetUp();
        ros::start();  // the master tells the node about changes
    }
    template <class T>
    RTT::Property<T>& add(const std::string& operation, const std::string& name) {
        RTT::OperationCaller<RTT::Property<T>&(const std::string&)> caller(
            component_.provides("rosparam")->getOperation(operation));
        EXPECT_TRUE(caller.ready());
        return caller(name);
    }
    template <class Condition>
    static bool soon(Condition condition) {
        for (int i = 0; i != 200 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
        return condition();
    }
};

/** Before static objects go. */
class Node : public ::testing::Environment {
    void TearDown() override {
        if (ros::isInitialized()) ros::shutdown();
    }
};
const ::testing::Environment* const node = ::testing::AddGlobalTestEnvironment(new Node);

TEST_F(ParameterProperty, ReadsAndSets) {
    ros::param::set("/n/c/p", 3);
    RTT::Property<int>& property = add<int>("addRosParamPropertyIntComponentPrivate", "p");
    EXPECT_EQ(&property, component_.properties()->find("p"));
    EXPECT_EQ(3, property.get());
    property.set(4);
    EXPECT_EQ(4, property.get());
    int there = 0;
    EXPECT_TRUE(ros::param::get("/n/c/p", there) && there == 4);
    EXPECT_EQ(0, oroforge::test::RosMaster::tool({"rosparam", "set", "/n/c/p", "5"}).status);
    EXPECT_TRUE(soon([&] { return property.get() == 5; }));
    EXPECT_EQ(5, property.rvalue());
    property.value() = 6;
    property.getDataSource()->updated();
    EXPECT_TRUE(ros::param::get("/n/c/p", there) && there == 6);
    property.value() = 7;
    EXPECT_EQ(7, property.get()) << "without updated()";
    EXPECT_TRUE(ros::param::get("/n/c/p", there) && there == 7);
    ros::param::set("/n/c/p", 8);
    EXPECT_EQ(8, property.get()) << "a reference that is not used does no harm";
    EXPECT_EQ("", log_.take());
    RTT::Property<int>& again = add<int>("addRosParamPropertyIntComponentPrivate", "p");
    EXPECT_EQ(&property, &again);
}

TEST_F(ParameterProperty, KeepsTheLastValue) {
    ros::param::set("/n/p", array(1, 2));
    RTT::Property<std::vector<int>>& property = add<std::vector<int>>("addRosParamPropertyVectorOfIntPrivate", "p");
    EXPECT_THAT(property.get(), ElementsAre(1, 2));
    ros::param::set("/n/p", array(1, 2.5));
    EXPECT_THAT(property.get(), ElementsAre(1, 2));
    EXPECT_THAT(log_.take(), AllOf(HasSubstr("ERROR"), HasSubstr("'/n/p[1]' is a double (2.5)")));
    EXPECT_THAT(property.get(), ElementsAre(1, 2));
    EXPECT_EQ("", log_.take()) << "once is enough";
    ros::param::set("/n/p", array(7));
    EXPECT_THAT(property.get(), ElementsAre(7));
    ros::param::del("/n/p");
    EXPECT_THAT(property.get(), ElementsAre(7));
    EXPECT_THAT(log_.take(), HasSubstr("'/n/p' is not set"));
}

TEST_F(ParameterProperty, FollowsWhatTheServiceSets) {
    RTT::Property<double>& property = add<double>("addRosParamPropertyDoublePrivate", "d");
    EXPECT_EQ(0, property.get());
    RTT::OperationCaller<void(const std::string&, const double&)> set(
        component_.provides("rosparam")->getOperation("setDoublePrivate"));
    set("d", 0.5);
    EXPECT_TRUE(soon([&] { return property.get() == 0.5; }));
}

TEST_F(ParameterProperty, ANameThatIsTaken) {
    std::string text = "x";
    component_.addProperty("p", text);
    RTT::Property<int>& property = add<int>("addRosParamPropertyInt", "p");
    EXPECT_THAT(log_.take(), HasSubstr("'p' of type int is not added: the component has one of type string already"));
    EXPECT_EQ(&property, &add<int>("addRosParamPropertyInt", "p")) << "one is enough";
    property.set(3);
    int there = 0;
    EXPECT_TRUE(ros::param::get("/p", there) && there == 3);
    EXPECT_EQ("x", text);
    ros::param::del("/p");
}

TEST_F(ParameterProperty, DataSourceOfAStruct) {
    typedef rtt_rosparam::RosParamDataSource<sample::Point> Source;
    const Source::shared_ptr source(new Source("~point"));
    source->set({1, 2});
    Value there;
    ASSERT_TRUE(ros::param::get("/n/point", there));
    EXPECT_EQ(Value(2.0), there["y"]);
    ros::param::set("/n/point/y", 3);
    EXPECT_TRUE(soon([&] { return source->get().y == 3; }));
    EXPECT_EQ(1, source->value().x);
    ros::param::set("/n/point/z", 9);
    source->set({4, 5});
    EXPECT_EQ(4, source->get().x);
    EXPECT_TRUE(ros::param::has("/n/point/z")) << "foreign parameters stay";
    EXPECT_EQ("", log_.take());
    EXPECT_EQ(0, RosMaster::tool({"rosparam", "delete", "/n/point"}).status);
    std::string text;
    EXPECT_TRUE(soon([&] {
        (void)source->get();
        return !(text += log_.take()).empty();
    }));
    EXPECT_THAT(text, HasSubstr("'/n/point' is not set"));
    EXPECT_EQ(4, source->get().x);
    source->set({6, 7});
    EXPECT_EQ(6, source->get().x);
    EXPECT_EQ("", log_.take());
    const Source::shared_ptr malformed(new Source("a b"));
    EXPECT_EQ(0, malformed->get().x);
    EXPECT_THAT(log_.take(), HasSubstr("'a b' is not a name"));
}

TEST_F(ParameterProperty, AnotherNodeDeletesIt) {
    RTT::Property<int>& property = add<int>("addRosParamPropertyIntPrivate", "p");
    property.set(3);
    EXPECT_EQ(3, property.get());
    EXPECT_EQ(0, RosMaster::tool({"rosparam", "delete", "/n/p"}).status);
    std::string text;
    EXPECT_TRUE(soon([&] {
        EXPECT_EQ(3, property.get());
        return !(text += log_.take()).empty();
    }));
    EXPECT_THAT(text, HasSubstr("'/n/p' is not set"));
}

TEST_F(ParameterProperty, NotANumberIsNoChange) {
    RTT::Property<double>& property = add<double>("addRosParamPropertyDoublePrivate", "d");
    property.set(1);
    property.value() = NAN;
    EXPECT_TRUE(std::isnan(property.get()));
    ros::param::set("/n/d", 2.0);
    EXPECT_EQ(2, property.get());
}

TEST_F(ParameterProperty, WhatTheMasterRefusesIsReported) {
    const rtt_rosparam::RosParamDataSource<int>::shared_ptr source(new rtt_rosparam::RosParamDataSource<int>("/"));
    source->set(3);
    EXPECT_THAT(log_.take(), HasSubstr("does not set parameter '/'"));
}

TEST_F(ParameterProperty, DataSourceOfABag) {
    typedef rtt_rosparam::RosParamDataSource<RTT::PropertyBag> Source;
    const Source::shared_ptr source(new Source("~bag"));
    RTT::PropertyBag bag;
    bag.ownProperty(new RTT::Property<int>("a", "", 1));
    source->set(bag);
    ros::param::set("/n/bag/a", 5);
    EXPECT_EQ(5, source->get().getPropertyType<int>("a")->get());
    EXPECT_EQ("", log_.take());
}

TEST_F(ParameterProperty, SeveralThreadsReadIt) {
    typedef rtt_rosparam::RosParamDataSource<std::vector<int>> Source;
    const Source::shared_ptr source(new Source("~list"));
    source->set({0, 0});
    std::atomic<bool> isOver{false}, isWhole{true};
    std::vector<std::thread> readers;
    for (int i = 0; i != 2; ++i)
        readers.emplace_back([&] {
            while (!isOver) {
                const std::vector<int> list = source->get();
                isWhole = isWhole && list.size() >= 2 && list.front() == list.back();
            }
        });
    for (int i = 1; i != 30; ++i) {
        source->set(std::vector<int>(static_cast<std::size_t>(i) + 1, i));
        EXPECT_EQ(i, source->get().back());
    }
    isOver = true;
    for (std::thread& reader : readers) reader.join();
    EXPECT_TRUE(isWhole);
}

}  // namespace param_test
