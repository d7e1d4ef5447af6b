// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "probe.hpp"

#include <rtt/ServiceRequester.hpp>

#include <gmock/gmock.h>

using namespace RTT;
using oroforge::test::Probe;
using testing::ElementsAre;

namespace {

TEST(Services, AreMadeByProvidesButNotByGetService) {
    Probe c;
    EXPECT_EQ(c.provides()->getService("sub"), nullptr);
    EXPECT_FALSE(c.provides()->hasService("sub"));
    Service::shared_ptr sub = c.provides("sub");
    ASSERT_TRUE(sub);
    EXPECT_EQ(c.provides("sub"), sub);
    EXPECT_EQ(c.provides()->getService("sub"), sub);
    EXPECT_EQ(sub->getOwner(), &c);
    EXPECT_EQ(sub->getParent(), c.provides());
    EXPECT_EQ(sub->getOwnerExecutionEngine(), c.engine());
    EXPECT_THAT(c.provides()->getProviderNames(), ElementsAre("sub"));
}

TEST(Services, ThisIsTheServiceItself) {
    Probe c;
    EXPECT_EQ(c.provides("this"), c.provides());
    EXPECT_EQ(c.provides()->getService("this"), c.provides());
    EXPECT_TRUE(c.provides()->hasService("this"));
}

TEST(Services, NamesAreUnique) {
    Probe c;
    Service::shared_ptr one(new Service("s")), two(new Service("s"));
    EXPECT_TRUE(c.provides()->addService(one));
    EXPECT_FALSE(c.provides()->addService(two));
    EXPECT_FALSE(c.provides()->addService(nullptr));
    EXPECT_EQ(c.provides()->getService("s"), one);
    c.provides()->removeService("s");
    EXPECT_FALSE(one->getParent());
    EXPECT_EQ(one->getOwner(), nullptr);
    c.provides()->removeService("s");
    EXPECT_TRUE(c.provides()->addService(two));
}

TEST(Services, CreateAddsToItsOwner) {
    Probe c;
    Service::shared_ptr made = Service::Create("made", &c);
    EXPECT_EQ(c.provides()->getService("made"), made);
    EXPECT_EQ(made->getOwner(), &c);
}

TEST(Services, HoldPropertiesAndAttributesToo) {
    Probe c;
    double kp = 1.5;
    int hidden = 3;
    c.provides("gains")->addProperty("kp", kp).doc("proportional");
    c.provides("gains")->addAttribute("hidden", hidden);
    EXPECT_TRUE(c.provides("gains")->hasProperty("kp"));
    EXPECT_FALSE(c.provides()->hasProperty("kp"));
    EXPECT_TRUE(c.provides("gains")->hasAttribute("hidden"));
}

TEST(Services, MayOutliveTheirComponent) {
    Service::shared_ptr main, sub;
    {
        Probe c;
        main = c.provides();
        sub = c.provides("sub");
        sub->addOperation("op", [] {});
    }
    EXPECT_EQ(main->getOwner(), nullptr);
    EXPECT_EQ(sub->getOwner(), nullptr);
    EXPECT_TRUE(main->getOperationNames().empty());
}

TEST(Services, OfAComponentKeepItsOperationsInAnother) {
    TaskContext a("a"), b("b");
    ASSERT_TRUE(a.provides()->addService(b.provides()));
    EXPECT_TRUE(a.provides("b")->hasOperation("getPeriod"));
    OperationInterfacePart* const start = a.provides()->getPart("start");
    EXPECT_TRUE(a.provides("b")->hasOperation("start"));
    EXPECT_EQ(a.provides()->getPart("start"), start);
    a.provides()->removeService("b");
}

TEST(Services, MemberOperationsMayDieBeforeTheComponent) {
    struct WithMember : Probe {
        Operation<int()> op{"op", [] { return 1; }};
        WithMember() { addOperation(op).doc("dies first"); }
    };
    auto c = std::make_unique<WithMember>();
    EXPECT_NO_FATAL_FAILURE(c.reset());
}

TEST(Services, SubClassMayUseItselfInItsConstructor) {
    struct Own : Service {
        explicit Own(TaskContext* owner) : Service("own", owner) {
            provides()->addOperation("here", [] { return 1; });
            provides("nested")->addOperation("there", [] { return 2; });
        }
    };
    Probe c;
    Service::shared_ptr own(new Own(&c));
    ASSERT_TRUE(c.provides()->addService(own));
    EXPECT_EQ(OperationCaller<int()>(own->getOperation("here"))(), 1);
    EXPECT_EQ(OperationCaller<int()>(c.provides("own")->provides("nested")->getOperation("there"))(), 2);
}

struct Requester : testing::Test {
    Probe server{"server"}, client{"client"};
    OperationCaller<int()> number{"number"};
    OperationCaller<std::string()> text{"text"};
};

TEST_F(Requester, BindsWhatIsThere) {
    server.addOperation(
        "number", [] { return 4; }, OwnThread);
    ASSERT_TRUE(client.requires_()->addOperationCaller(number));
    EXPECT_FALSE(client.requires_()->addOperationCaller(number)) << "the name is taken";
    ASSERT_TRUE(client.requires_()->addOperationCaller(text));
    EXPECT_THAT(client.requires_()->getOperationCallerNames(), ElementsAre("number", "text"));
    EXPECT_FALSE(client.requires_()->connectTo(server.provides())) << "text is missing";
    EXPECT_TRUE(number.ready());
    EXPECT_FALSE(text.ready());
    server.addOperation("text", [] { return std::string("x"); });
    EXPECT_TRUE(client.requires_()->connectTo(server.provides()));
    EXPECT_EQ(number(), 4) << "the caller is the component's engine";
    EXPECT_EQ(text(), "x");
    EXPECT_FALSE(client.requires_()->connectTo(nullptr));
    client.requires_()->disconnect();
    EXPECT_FALSE(number.ready());
}

TEST_F(Requester, WithoutCallersIsReady) { EXPECT_TRUE(client.requires_("anything")->ready()); }

TEST_F(Requester, IsConnectedByConnectServices) {
    server.provides("numbers")->addOperation("number", [] { return 4; });
    client.requires_("numbers")->addOperationCaller(number);
    server.requires_("texts")->addOperationCaller(text);
    client.provides("texts")->addOperation("text", [] { return std::string("x"); });
    EXPECT_TRUE(client.connectServices(&server));
    EXPECT_EQ(number(), 4);
    EXPECT_EQ(text(), "x");
}

TEST_F(Requester, MissingServicesAreNoFailureOfConnectServices) {
    client.requires_("numbers")->addOperationCaller(number);
    EXPECT_TRUE(client.connectServices(&server));
    EXPECT_FALSE(number.ready());
    server.provides("numbers");
    EXPECT_FALSE(client.connectServices(&server)) << "now it is there, but lacks the operation";
}

TEST_F(Requester, RequiresIsOfferedUnderItsOldName) {
#if __cplusplus < 202002L
    EXPECT_EQ(client.requires(), client.requires_());
    EXPECT_EQ(client.requires("x"), client.requires_("x"));
#endif
    EXPECT_TRUE(client.requires_()->requiresService("x") || __cplusplus >= 202002L);
}

}  // namespace
