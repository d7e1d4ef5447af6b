// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What packages that register services themselves use.
#include "service_fixture.hpp"

#include <rtt/internal/GlobalService.hpp>
#include <rtt_roscomm/rosservice_registry_service.h>
#include <rtt_roscomm/message_table.hpp>
#include <rtt_roscomm/rtt_rosservice_proxy.h>

#include <ros/ros.h>

#include <algorithm>

using namespace service_test;

namespace rtt_roscomm {
template <>
struct ROSServiceServerOperationCallerWrapper<std_srvs::Trigger, 1> {
    typedef int Signature();
    typedef RTT::OperationCaller<Signature> ProxyOperationCallerType;
    template <class Callable>
    static bool call(Callable& operation, std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
        const int n = operation();
        response.success = n > 0;
        response.message = std::to_string(n);
        return n >= 0;
    }
};
}  // namespace rtt_roscomm

/** Each in a process of its own: what they register stays. */
class ServiceRegistryTest : public ServiceTest {};

TEST_F(ServiceRegistryTest, AFactoryOfUsersComesFirst) {
    const auto registry = ROSServiceRegistryService::Instance();
    ASSERT_TRUE(registry);
    EXPECT_TRUE(registry->hasServiceFactory("std_srvs/Trigger"));
    EXPECT_FALSE(registry->registerServiceFactory(nullptr));
    ASSERT_TRUE(registry->registerServiceFactory(new ROSServiceProxyFactory<std_srvs::Trigger>("std_srvs/Trigger")));
    ASSERT_TRUE(registry->registerServiceFactory(new ROSServiceProxyFactory<std_srvs::Trigger>("std_srvs/Trigger")));

    int number = 3;
    pump->addOperation("count", std::function<int()>([&] { return number; }), OwnThread);
    const std::function<bool(std_srvs::TriggerRequest&, std_srvs::TriggerResponse&)> full =
        [](std_srvs::TriggerRequest&, std_srvs::TriggerResponse& response) {
            response.message = "full";
            return true;
        };
    pump->addOperation("full", full);
    ASSERT_TRUE(pump->services->connect("count", "/count", "std_srvs/Trigger"));
    ASSERT_TRUE(pump->services->connect("full", "/full", "std_srvs/Trigger"));
    std_srvs::Trigger call;
    ASSERT_TRUE(ros::service::call("/count", call));
    EXPECT_EQ("3", call.response.message);
    number = -1;
    EXPECT_FALSE(ros::service::call("/count", call));
    ASSERT_TRUE(ros::service::call("/full", call));
    EXPECT_EQ("full", call.response.message);

    OperationCaller<bool(std_srvs::TriggerRequest&, std_srvs::TriggerResponse&)> caller("caller");
    pump->requires_()->addOperationCaller(caller);
    ASSERT_TRUE(pump->services->connect("caller", "/full", "std_srvs/Trigger"));
    call.response.message = "";
    EXPECT_TRUE(caller(call.request, call.response));
    EXPECT_EQ("full", call.response.message);
    EXPECT_TRUE(pump->services->disconnect("/full"));
    EXPECT_FALSE(caller.ready());

    const LogText log;
    EXPECT_FALSE(pump->services->connect("half", "/half", "std_srvs/Trigger"));
    EXPECT_TRUE(
        log.has("double(int), expected bool(std_srvs::TriggerRequest_<std::allocator<void> > &, "
                "std_srvs::TriggerResponse_<std::allocator<void> > &), or int()"))
        << log.text();
}

namespace {

class OddFactory : public ROSServiceProxyFactoryBase {
public:
    OddFactory() : ROSServiceProxyFactoryBase("odd_srvs/Odd") {}
    ROSServiceClientProxyBase* create_client_proxy(const std::string&) override { throw std::runtime_error("too odd"); }
    ROSServiceServerProxyBase* create_server_proxy(const std::string&) override { return nullptr; }
};

}  // namespace

TEST_F(ServiceRegistryTest, AFactoryThatFailsIsReported) {
    ASSERT_TRUE(ROSServiceRegistryService::Instance()->registerServiceFactory(new OddFactory()));
    const LogText log;
    EXPECT_FALSE(pump->services->connect("ping", "/odd", "odd_srvs/Odd"));
    EXPECT_TRUE(log.has("too odd"));
    EXPECT_FALSE(pump->services->connect("ask", "/odd", "odd_srvs/Odd"));
    EXPECT_TRUE(log.has("makes no servers"));
    EXPECT_FALSE(pump->services->disconnect("/odd"));
}

TEST_F(ServiceRegistryTest, TheRegistryListsTypes) {
    const RTT::Service::shared_ptr service =
        RTT::internal::GlobalService::Instance()->getService("rosservice_registry");
    ASSERT_TRUE(service);
    OperationCaller<bool(const std::string&)> has = service->getOperation("hasServiceFactory");
    EXPECT_TRUE(has("std_srvs/Empty"));
    EXPECT_FALSE(has("std_srvs/Full"));
    OperationCaller<std::vector<std::string>()> list = service->getOperation("listSrvs");
    EXPECT_EQ((std::vector<std::string>{"std_srvs/Empty", "std_srvs/SetBool", "std_srvs/Trigger"}), list());
    EXPECT_EQ(nullptr, ROSServiceRegistryService::Instance()->getServiceFactory("std_srvs/Full"));
}

TEST_F(ServiceRegistryTest, ATypeWithoutATypekitIsRefused) {
    static const rtt_roscomm::ServiceEntry ghost = {"ghost_srvs/Boo", "00000000000000000000000000000000",
                                                    "/ghost_srvs/BooRequest", "/ghost_srvs/BooResponse"};
    rtt_roscomm::addServices(&ghost, 1);
    const LogText log;
    EXPECT_FALSE(pump->services->connect("ask", "/boo", "ghost_srvs/Boo"));
    EXPECT_TRUE(log.has("import rtt_ghost_srvs")) << log.text();
    EXPECT_FALSE(pump->services->connect("away.standard", "/boo", "ghost_srvs/Boo"));
}

TEST(ServiceCodecTest, BytesBehindARequestAreRefused) {
    const rtt_roscomm::RosCodec<std_srvs::SetBoolRequest> codec;
    const std::uint8_t bytes[] = {1, 0};
    std_srvs::SetBoolRequest request;
    codec.decode(bytes, 1, &request);
    EXPECT_TRUE(request.data);
    EXPECT_THROW(codec.decode(bytes, 2, &request), std::runtime_error);
}

TEST_F(ServiceRegistryTest, ASecondConnectOfAProxyLeavesTheFirst) {
    auto* const factory = ROSServiceRegistryService::Instance()->getServiceFactory("std_srvs/Trigger");
    ASSERT_TRUE(factory);
    const std::unique_ptr<ROSServiceServerProxyBase> proxy(factory->create_server_proxy("/told"));
    ASSERT_TRUE(proxy->connect(pump.get(), pump->getOperation("tell")));
    const LogText log;
    EXPECT_FALSE(proxy->connect(pump.get(), pump->getOperation("ask")));
    EXPECT_TRUE(log.has("offered by operation 'tell' of component 'pump' already")) << log.text();
    std_srvs::Trigger call;
    ASSERT_TRUE(ros::service::call("/told", call));
    EXPECT_EQ("told", call.response.message);
}
