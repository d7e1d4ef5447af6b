// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Without a node, without a master, with one that does not answer. Each case needs a process of its own.
#include "param_fixture.hpp"

#include <rtt_rosparam/ros_param_data_source.hpp>
#include <xmlrpcpp/XmlRpc.h>

#include <arpa/inet.h>
#include <atomic>
#include <chrono>
#include <csignal>
#include <stdexcept>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace param_test {

std::uint16_t portOf(const std::string& uri) {
    return static_cast<std::uint16_t>(std::stoi(uri.substr(uri.rfind(':') + 1)));
}

class Alone : public WithService {
protected:
    void SetUp() override {
        if (ros::isInitialized()) GTEST_SKIP() << "this process is a node already";
        WithService::SetUp();
        component_.addProperty("p", value_);
    }
    /** All kinds of operations. The longest time of one. */
    double tryAll() {
        double longest = 0;
        const auto time = [&](const std::function<bool()>& one) {
            const auto begin = std::chrono::steady_clock::now();
            EXPECT_FALSE(one());
            const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
            longest = std::max(longest, took.count());
        };
        time([&] { return call(component_, "getAll"); });
        time([&] { return call(component_, "setAll"); });
        time([&] { return call(component_, "getPrivate", std::string("p")); });
        return longest;
    }
    double tryProperty() {
        const auto begin = std::chrono::steady_clock::now();
        RTT::OperationCaller<RTT::Property<int>&(const std::string&)> add(
            component_.provides("rosparam")->getOperation("addRosParamPropertyInt"));
        RTT::Property<int>& property = add("bound");
        EXPECT_EQ(0, property.get());
        property.set(3);
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
    int value_ = 5;
};
using ::testing::HasSubstr;

TEST_F(Alone, NoNode) {
    (void)tryAll();
    EXPECT_THAT(log_.take(), AllOf(HasSubstr("'~c': this process is not a ROS node"), HasSubstr("import rtt_rosnode")));
    (void)tryProperty();
    EXPECT_THAT(log_.take(), HasSubstr("'bound': this process is not a ROS node"));
    EXPECT_EQ(5, value_);
}

TEST_F(Alone, NoMaster) {
    const oroforge::test::RosMaster none(oroforge::test::RosMaster::Start::Later);
    becomeNode();
    EXPECT_LT(tryAll(), 1);
    EXPECT_THAT(log_.take(), AllOf(HasSubstr("the ROS master at " + none.uri()), HasSubstr("set ROS_MASTER_URI")));
    EXPECT_LT(tryProperty(), 1);
    EXPECT_THAT(log_.take(), HasSubstr("the ROS master at " + none.uri()));
    EXPECT_EQ(5, value_);
}

TEST_F(Alone, TheMasterComesAndGoes) {
    oroforge::test::RosMaster master(oroforge::test::RosMaster::Start::Later);
    becomeNode();
    EXPECT_FALSE(call(component_, "setAll"));
    ASSERT_TRUE(master.start());
    EXPECT_TRUE(call(component_, "setAll")) << log_.take();
    EXPECT_TRUE(call(component_, "getAll")) << log_.take();
    master.stop();
    EXPECT_FALSE(call(component_, "getAll"));
    ASSERT_TRUE(master.start());
    EXPECT_TRUE(call(component_, "setAll")) << log_.take();
    EXPECT_TRUE(call(component_, "getAll")) << log_.take();
}

TEST_F(Alone, AMasterThatDoesNotAnswer) {
    const oroforge::test::RosMaster none(oroforge::test::RosMaster::Start::Later);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(portOf(none.uri()));
    const int fd = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    ASSERT_EQ(0, bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address));
    ASSERT_EQ(0, listen(fd, 10));
    becomeNode();
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_FALSE(call(component_, "getAll"));
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 6);
    EXPECT_THAT(log_.take(),
                AllOf(HasSubstr("the ROS master at " + none.uri()), HasSubstr("no answer within 5000 ms")));
    close(fd);
}

/** A server that sets only some parameters, and cannot read any. */
class FussyMaster {
public:
    explicit FussyMaster(const std::string& uri) {
        if (!server_.bindAndListen(portOf(uri))) throw std::runtime_error("the port is taken");
        thread_ = std::thread([this] {
            while (!isOver_) server_.work(0.02);
        });
    }
    ~FussyMaster() {
        isOver_ = true;
        thread_.join();
        server_.shutdown();
    }
    int taken() const { return taken_; }

private:
    struct Set : XmlRpc::XmlRpcServerMethod {
        explicit Set(FussyMaster& its) : XmlRpcServerMethod("setParam", &its.server_), its_(its) {}
        void execute(Value& arguments, Value& result) override {
            const bool isBad = static_cast<std::string&>(arguments[1]).find("bad") != std::string::npos;
            result[0] = isBad ? -1 : 1;
            result[1] = isBad ? "not this one" : "";
            result[2] = 0;
            if (!isBad) ++its_.taken_;
        }
        FussyMaster& its_;
    };
    XmlRpc::XmlRpcServer server_;
    Set set_{*this};
    std::atomic<int> taken_{0};
    std::atomic<bool> isOver_{false};
    std::thread thread_;
};

TEST_F(Alone, WhatTheMasterRefusesDoesNotHinderOthers) {
    const oroforge::test::RosMaster none(oroforge::test::RosMaster::Start::Later);
    const FussyMaster master(none.uri());
    becomeNode();
    std::vector<int> values(1500, 1);
    for (std::size_t i = 0; i != values.size(); ++i)
        component_.addProperty((i == 2 || i == 1200 ? "bad" : "good") + std::to_string(i), values[i]);
    EXPECT_FALSE(call(component_, "setAll"));
    EXPECT_EQ(1499, master.taken()) << "with p";
    EXPECT_THAT(log_.take(), HasSubstr("the ROS master at " + none.uri() +
                                       " does not set parameter '/n/c/bad2': not this "
                                       "one; parameter '/n/c/bad1200': not this one"));
    EXPECT_FALSE(call(component_, "getAll"));
    EXPECT_THAT(log_.take(),
                AllOf(HasSubstr("does not take a call: it refuses getParam"), Not(HasSubstr("start roscore"))));
}

/** Of a node whose master tells it about changes. */
TEST_F(Alone, ReadingDoesNotAskAMasterThatIsStopped) {
    oroforge::test::RosMaster master;
    becomeNode();
    ros::start();
    ros::param::set("/there", 3);
    const rtt_rosparam::RosParamDataSource<int>::shared_ptr there(new rtt_rosparam::RosParamDataSource<int>("/there"));
    const rtt_rosparam::RosParamDataSource<int>::shared_ptr unset(new rtt_rosparam::RosParamDataSource<int>("/unset"));
    EXPECT_EQ(3, there->get());
    EXPECT_EQ(0, unset->get());
    EXPECT_THAT(log_.take(), HasSubstr("'/unset' is not set"));
    master.send(SIGSTOP);
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(3, there->get());
    EXPECT_EQ(0, unset->get());
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 1);
    there->set(4);
    EXPECT_THAT(log_.take(), HasSubstr("no answer within 5000 ms"));
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 6);
    master.send(SIGCONT);
    ros::shutdown();
}

}  // namespace param_test
