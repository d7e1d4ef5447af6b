// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Services within services: who is whose parent, and when.
#include "probe.hpp"

#include <rtt/InputPort.hpp>

#include <boost/make_shared.hpp>

using namespace RTT;
using oroforge::test::Probe;

namespace {

/** Makes services and a port within its constructor, when nobody owns it yet. */
struct Tree : Service {
    explicit Tree(TaskContext* owner) : Service("tree", owner) {
        provides("branch")->provides("leaf")->addPort("in", port);
    }
    InputPort<int> port;
};

TEST(ServiceTree, ServicesMadeInAConstructorHaveTheirParent) {
    Probe c("c");
    const auto tree = boost::make_shared<Tree>(&c);
    const auto branch = tree->getService("branch");
    ASSERT_TRUE(branch);
    EXPECT_EQ(branch->getParent(), tree) << "before the service is added to anything";
    ASSERT_TRUE(c.provides()->addService(tree));
    EXPECT_EQ(branch->getParent(), tree);
    EXPECT_EQ(branch->getService("leaf")->getParent(), branch);
    EXPECT_EQ(tree->getParent(), c.provides());
    EXPECT_EQ(tree->port.getFullName(), "c.tree.branch.leaf.in");
}

TEST(ServiceTree, ParentMayBeAskedForItInItsConstructor) {
    struct Asking : Service {
        Asking() : Service("asking") { parent = provides("sub")->getParent().get(); }
        Service* parent = nullptr;
    };
    const auto asking = boost::make_shared<Asking>();
    EXPECT_EQ(asking->parent, asking.get());
    EXPECT_EQ(asking->getService("sub")->getParent(), asking);
}

TEST(ServiceTree, ServicesThatOutliveTheirParentHaveNone) {
    Service::shared_ptr sub;
    {
        const auto parent = boost::make_shared<Service>("parent");
        sub = parent->provides("sub");
        EXPECT_EQ(sub->getParent(), parent);
    }
    EXPECT_FALSE(sub->getParent());
}

TEST(ServiceTree, RemovedFromOneParentTheServiceStaysThatOfTheOther) {
    const auto one = boost::make_shared<Service>("one"), two = boost::make_shared<Service>("two");
    const auto sub = boost::make_shared<Service>("sub");
    ASSERT_TRUE(one->addService(sub));
    ASSERT_TRUE(two->addService(sub));
    one->removeService("sub");
    EXPECT_EQ(sub->getParent(), two);
    two->removeService("sub");
    EXPECT_FALSE(sub->getParent());
}

TEST(ServiceTree, ServiceIsNotAddedToItself) {
    const auto service = boost::make_shared<Service>("s");
    EXPECT_FALSE(service->addService(service));
    EXPECT_FALSE(service->getParent());
}

TEST(ServiceTree, ServiceThatWasNeverAddedForgetsADestroyedOwner) {
    struct Alone : Service {
        explicit Alone(TaskContext* owner) : Service("alone", owner) { addEventPort("in", port); }
        InputPort<int> port;
    };
    boost::shared_ptr<Alone> alone;
    {
        Probe c("c");
        alone = boost::make_shared<Alone>(&c);
        EXPECT_EQ(alone->getOwner(), &c);
        EXPECT_EQ(alone->getOwnerExecutionEngine(), c.engine());
    }
    EXPECT_EQ(alone->getOwner(), nullptr);
    EXPECT_EQ(alone->getOwnerExecutionEngine(), nullptr);
    Probe other("other");
    EXPECT_TRUE(other.provides()->addService(alone));
    EXPECT_EQ(alone->port.getFullName(), "other.alone.in");
}

TEST(ServiceTree, ParentCanBeSetByHand) {
    const auto parent = boost::make_shared<Service>("parent"), sub = boost::make_shared<Service>("sub");
    sub->setParent(parent);
    EXPECT_EQ(sub->getParent(), parent);
    sub->setParent(nullptr);
    EXPECT_FALSE(sub->getParent());
}

}  // namespace
