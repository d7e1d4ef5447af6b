// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Without a node, without a master, with one that does not answer. Each case needs a process of its own.
#include "param_fixture.hpp"

#include <arpa/inet.h>
#include <chrono>
#include <sys/socket.h>
#include <unistd.h>

namespace param_test {

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
    address.sin_port = htons(static_cast<std::uint16_t>(std::stoi(none.uri().substr(none.uri().rfind(':') + 1))));
    const int fd = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    ASSERT_EQ(0, bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address));
    ASSERT_EQ(0, listen(fd, 10));
    becomeNode();
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_FALSE(call(component_, "getAll"));
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 6);
    EXPECT_THAT(log_.take(), HasSubstr("no answer within 5 s from the ROS master at " + none.uri()));
    close(fd);
}

}  // namespace param_test
