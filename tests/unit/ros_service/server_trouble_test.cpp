// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "service_fixture.hpp"

#include <ros/ros.h>
#include <ros/service_manager.h>

#include <arpa/inet.h>
#include <atomic>
#include <random>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

using namespace service_test;

namespace {

/** A connection to the port of a service. */
class RawClient {
public:
    explicit RawClient(const std::string& service) : fd_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        std::string host;
        std::uint32_t port = 0;
        EXPECT_TRUE(ros::ServiceManager::instance()->lookupService(service, host, port));
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(0, connect(fd_, reinterpret_cast<sockaddr*>(&address), sizeof(address)));
        const timeval limit{5, 0};
        setsockopt(fd_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof(limit));
    }
    ~RawClient() { close(fd_); }
    void write(const std::string& bytes) { (void)!send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL); }
    std::string read(std::size_t bytes) {
        std::string got(bytes, 0);
        const ssize_t n = recv(fd_, got.data(), bytes, MSG_WAITALL);
        got.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
        return got;
    }
    static std::string length(std::size_t n) { return {char(n), char(n >> 8), char(n >> 16), char(n >> 24)}; }
    static std::string field(const std::string& text) { return length(text.size()) + text; }
    /** Says who calls, and takes the answer to that. */
    std::string greet(const std::string& service, const std::string& md5) {
        write(field(field("callerid=/raw") + field("service=" + service) + field("md5sum=" + md5) +
                    field("persistent=1")));
        const std::string size = read(4);
        if (size.size() != 4) return "";
        return read(static_cast<unsigned char>(size[0]) | static_cast<unsigned char>(size[1]) << 8);
    }

private:
    const int fd_;
};

}  // namespace

TEST_F(ServiceTest, MalformedBytesAreRefused) {
    ASSERT_TRUE(pump->services->connect("client", "/set", "std_srvs/SetBool"));
    ASSERT_TRUE(pump->services->connect("setFlag", "/flag", "std_srvs/SetBool"));
    const std::string md5 = "09fb03525b03e7ea1fd3992bafd87e16";
    for (const std::string service : {"/set", "/flag"}) {
        RawClient client(service);
        EXPECT_NE("", client.greet(service, md5));
        for (const std::string& request : {std::string(), std::string("ab"), std::string(100000, 'x')}) {
            client.write(RawClient::field(request));
            const std::string head = client.read(5);
            ASSERT_EQ(5u, head.size());
            EXPECT_EQ(0, head[0]);
            const std::string text = client.read(static_cast<unsigned char>(head[1]));
            EXPECT_NE(std::string::npos, text.find("of component 'pump': the ")) << text;
        }
        client.write(RawClient::field(std::string(1, 1)));
        EXPECT_EQ(1, client.read(5)[0]);
    }
    EXPECT_TRUE(pump->isOn);
    RawClient stranger("/set");
    EXPECT_NE(std::string::npos, stranger.greet("/set", "00000000000000000000000000000000").find("error="))
        << "wrong md5";
}

TEST_F(ServiceTest, GarbageDoesNoHarm) {
    ASSERT_TRUE(pump->services->connect("client", "/set", "std_srvs/SetBool"));
    std::mt19937 random(7);
    for (int i = 0; i != 50; ++i) {
        RawClient client("/set");
        std::string bytes(random() % 300, 0);
        for (char& byte : bytes) byte = static_cast<char>(random());
        client.write(i % 2 ? RawClient::field(bytes) : bytes);
    }
    std_srvs::SetBool call;
    call.request.data = true;
    EXPECT_TRUE(ros::service::call("/set", call));
}

TEST_F(ServiceTest, AComponentMayDisconnectWhileItIsCalled) {
    std::atomic<bool> isIn{false};
    const std::function<bool()> busy = [&] {
        isIn = true;
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        pump->services->disconnectAll();
        return true;
    };
    pump->addOperation("busy", busy, OwnThread);
    ASSERT_TRUE(pump->services->connect("busy", "/busy", "std_srvs/Empty"));
    std::thread first([] {
        std_srvs::Empty call;
        EXPECT_FALSE(ros::service::call("/busy", call));
    });
    while (!isIn) std::this_thread::yield();
    std_srvs::Empty call;
    EXPECT_FALSE(ros::service::call("/busy", call));  // waits for the component when that disconnects
    first.join();
    EXPECT_FALSE(ros::service::exists("/busy", false));
}

TEST_F(ServiceTest, DisconnectWaitsForTheSpinnersThatExecuteAnOperation) {
    std::atomic<bool> isIn{false}, isOut{false};
    const std::function<bool()> slow = [&] {
        isIn = true;
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        return isOut = true;
    };
    pump->addOperation("slow", slow, ClientThread);
    ASSERT_TRUE(pump->services->connect("slow", "/slow", "std_srvs/Empty"));
    std::thread client([] {
        std_srvs::Empty call;
        (void)ros::service::call("/slow", call);
    });
    while (!isIn) std::this_thread::yield();
    EXPECT_TRUE(pump->services->disconnect("/slow"));
    EXPECT_TRUE(isOut);
    client.join();
}

TEST_F(ServiceTest, OperationsInSpinnersMayDisconnectEachOther) {
    std::atomic<int> in{0}, out{0};
    const auto ends = [&](const std::string& service) -> std::function<bool()> {
        return [&, service] {
            ++in;
            while (in < 2) std::this_thread::yield();
            EXPECT_TRUE(pump->services->disconnect(service));
            return ++out != 0;
        };
    };
    pump->addOperation("endsTwo", ends("/two"), ClientThread);
    pump->addOperation("endsOne", ends("/one"), ClientThread);
    ASSERT_TRUE(pump->services->connect("endsTwo", "/one", "std_srvs/Empty"));
    ASSERT_TRUE(pump->services->connect("endsOne", "/two", "std_srvs/Empty"));
    std::vector<std::thread> clients;
    for (const char* service : {"/one", "/two"})
        clients.emplace_back([service] {
            std_srvs::Empty call;
            (void)ros::service::call(service, call);
        });
    for (std::thread& client : clients) client.join();
    while (out < 2) std::this_thread::yield();
}

TEST_F(ServiceTest, AComponentMayBeDestroyedWhileItIsCalled) {
    for (int i = 0; i != 20; ++i) {
        auto made = std::make_unique<Pump>("other");
        made->services = made->getProvider<rtt_roscomm::ROSService>("rosservice");
        made->start();
        ASSERT_TRUE(made->services->connect("flip", "/flip", "std_srvs/Empty"));
        std::atomic<int> answered{0};
        std::thread caller([&answered] {
            std_srvs::Empty call;
            ros::ServiceClient client = ros::NodeHandle().serviceClient<std_srvs::Empty>("/flip", true);
            while (client.call(call)) ++answered;
        });
        while (answered < 3) std::this_thread::yield();
        made->stop();
        made.reset();
        caller.join();
    }
}

TEST_F(ServiceTest, ManyClientsCallAtOnce) {
    std::atomic<int> total{0};
    const std::function<bool(bool)> count = [&](bool) { return ++total != 0; };
    pump->addOperation("count", count, ClientThread);
    ASSERT_TRUE(pump->services->connect("count", "/count", "std_srvs/SetBool"));
    std::vector<std::thread> callers;
    for (int t = 0; t != 6; ++t)
        callers.emplace_back([] {
            ros::ServiceClient client = ros::NodeHandle().serviceClient<std_srvs::SetBool>("/count", true);
            std_srvs::SetBool call;
            for (int i = 0; i != 200; ++i) EXPECT_TRUE(client.call(call) && call.response.success);
        });
    for (std::thread& caller : callers) caller.join();
    EXPECT_EQ(1200, total);
}

/** In a process of its own, because its master ends. */
class ServiceMasterTest : public ServiceTest {};

TEST_F(ServiceMasterTest, AMasterThatIsAwayIsNamed) {
    ASSERT_TRUE(pump->services->connect("flip", "/flip", "std_srvs/Empty"));
    master().stop();
    const LogText log;
    EXPECT_FALSE(pump->services->connect("ask", "/ask", "std_srvs/Empty"));
    EXPECT_TRUE(log.has("master at " + master().uri()));
    EXPECT_TRUE(pump->services->disconnect("/flip"));
    ASSERT_TRUE(pump->services->connect("ping", "/away", "std_srvs/Empty"));
    EXPECT_FALSE(pump->ping());
    EXPECT_TRUE(log.has("operation caller 'ping' of component 'pump': service '/away'")) << log.text();
    ASSERT_TRUE(master().start());
    EXPECT_TRUE(pump->services->connect("flip", "/away", "std_srvs/Empty"));
    EXPECT_TRUE(pump->ping());
}

TEST(ServiceNodeTest, NamesAreRemappedOnce) {
    loadServices();
    (void)master({{"/one", "/two"}, {"/two", "/one"}, {"~own", "/three"}, {"/three", "/four"}});
    Pump pump("pump");
    const auto services = pump.getProvider<rtt_roscomm::ROSService>("rosservice");
    pump.start();
    ASSERT_TRUE(services->connect("ask", "/one", "std_srvs/Trigger"));
    ASSERT_TRUE(services->connect("tell", "~own", "std_srvs/Trigger"));
    std::string host;
    std::uint32_t port = 0;
    const auto isThere = [&](const char* name) {
        return ros::ServiceManager::instance()->lookupService(name, host, port);
    };
    EXPECT_TRUE(isThere("/two"));
    EXPECT_FALSE(isThere("/one"));
    EXPECT_TRUE(isThere("/three"));
    EXPECT_FALSE(isThere("/four"));
    ASSERT_TRUE(services->connect("trigger", "~own", "std_srvs/Trigger"));
    std::string text;
    EXPECT_TRUE(pump.trigger(text));
    EXPECT_EQ("told", text);
    EXPECT_TRUE(services->disconnect("/one"));
    EXPECT_TRUE(services->disconnect("~own"));
    EXPECT_FALSE(isThere("/two"));
    EXPECT_FALSE(isThere("/three"));
}

TEST(ServiceNodeTest, WithoutANodeTheImportIsNamed) {
    loadServices();
    Pump lonely("lonely");
    const auto services = lonely.getProvider<rtt_roscomm::ROSService>("rosservice");
    const LogText log;
    EXPECT_FALSE(services->connect("flip", "/flip", "std_srvs/Empty"));
    EXPECT_FALSE(services->connect("ping", "/flip", "std_srvs/Empty"));
    EXPECT_TRUE(log.has("import rtt_rosnode")) << log.text();
    EXPECT_FALSE(lonely.ping.ready());
    EXPECT_FALSE(services->disconnect("/flip"));
    services->disconnectAll();
}
