// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Streams that come and go many times, ours and those of others, leave nothing behind. ./dev stress has 10^5 of each.
#include "node.hpp"

#include <ros/connection_manager.h>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt_roscomm/detail/open_topics.hpp>
#include <rtt_roscomm/rostopic.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <malloc.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <string>

namespace {

using namespace rtt_roscomm;
using ros_test::soon;

/** What the process has that a leak lets grow. */
struct Held {
    long threads = entries("/proc/self/task"), files = entries("/proc/self/fd");
    long bytes = static_cast<long>(mallinfo2().uordblks);

    static long entries(const char* folder) {
        return std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator());
    }
};

std::ostream& operator<<(std::ostream& out, const Held& held) {
    return out << held.threads << " threads, " << held.files << " files, " << held.bytes / 1024 << " kB";
}

class RosTopicStorm : public testing::Test {
protected:
    /** Does it many times, a third of them before the first look. */
    template <class Work>
    void repeat(int fewest, Work work) {
        const char* const wanted = std::getenv("ORO_ROS_STREAMS");
        const int times = wanted ? std::atoi(wanted) : fewest;
        for (int i = 0; i != times / 3; ++i) ASSERT_TRUE(work(i)) << i;
        const Held before;
        for (int i = times / 3; i != times; ++i) ASSERT_TRUE(work(i)) << i;
        // What was closed last may be on its way.
        (void)soon([&] { return Held().files <= before.files && Held().threads <= before.threads; },
                   std::chrono::seconds(5));
        const Held after;
        std::cout << times << " times: from " << before << " to " << after << std::endl;
        EXPECT_LE(after.threads, before.threads + 1);
        EXPECT_LE(after.files, before.files + 5);
        EXPECT_LE(after.bytes, before.bytes + 500 * 1024);  // 10^5 leaks of 8 bytes
    }

    ros_test::Node node;
    RTT::TaskContext component{"c"};
};

TEST_F(RosTopicStorm, SubscriptionsLeaveNothingBehind) {
    RTT::OutputPort<double> out("out");
    RTT::InputPort<double> in("in");
    component.addPort(out);
    component.addPort(in);
    ASSERT_TRUE(out.createStream(topicLatched("/kept")));
    out.write(1);
    repeat(150, [&](int i) {
        if (i % 10 != 0) {
            if (!in.createStream(topicBuffer("/t" + std::to_string(i % 7), 10))) return false;
        } else {
            double value = 0;
            if (!in.createStream(topic("/kept"))) return false;
            if (!soon([&] { return in.read(value) == RTT::NewData; })) return false;
        }
        in.disconnect();
        return !in.connected();
    });
}

TEST_F(RosTopicStorm, PublishersLeaveNothingBehind) {
    RTT::OutputPort<double> out("out");
    component.addPort(out);
    repeat(150, [&](int i) {
        if (!out.createStream(topicBuffer("/t" + std::to_string(i % 7), 10))) return false;
        if (i % 3 == 0) out.write(i);
        out.disconnect();
        return !out.connected();
    });
}

/** A subscriber in another process, as far as the publisher knows. */
class Visitor {
public:
    explicit Visitor(const std::string& topic) {
        std::string fields;
        for (const std::string& field :
             {"callerid=/visitor" + std::string(), "topic=" + topic, std::string("md5sum=*"), std::string("type=*")})
            fields += number(field.size()) + field;
        const std::string header = number(fields.size()) + fields;
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        address.sin_port = htons(static_cast<std::uint16_t>(ros::ConnectionManager::instance()->getTCPPort()));
        isIn_ = connect(fd_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
                send(fd_, header.data(), header.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(header.size());
    }
    ~Visitor() { close(fd_); }
    Visitor(const Visitor&) = delete;
    Visitor& operator=(const Visitor&) = delete;
    bool isIn() const { return isIn_; }
    /** Waits for the answer of the publisher, and of a latched one, the message. */
    bool hears(std::size_t bytes) {
        std::string all(bytes, ' ');
        return recv(fd_, all.data(), bytes, MSG_WAITALL) == static_cast<ssize_t>(bytes);
    }

private:
    static std::string number(std::size_t value) {
        const auto small = static_cast<std::uint32_t>(value);
        std::string text(4, ' ');
        std::memcpy(text.data(), &small, 4);
        return text;
    }
    const int fd_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    bool isIn_ = false;
};

TEST_F(RosTopicStorm, SubscribersOfOthersLeaveNothingBehind) {
    RTT::OutputPort<double> out("out");
    component.addPort(out);
    ASSERT_TRUE(out.createStream(topicLatched("/t")));
    out.write(1);
    repeat(600, [&](int i) {
        Visitor visitor("/t");
        // Some leave before they are let in.
        return visitor.isIn() && (i % 4 == 0 || visitor.hears(100));
    });
    EXPECT_TRUE(soon([&] { return detail::openTopics().at(0).peers == 0; }));
}

}  // namespace
