// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Components that are promised another activity than the one they are constructed with: no thread is made for nothing,
// and whoever needs one before finds it.
#include "probe.hpp"

#include <rtt/Activity.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/engine/deferred_activity.hpp>

#include <filesystem>
#include <fstream>
#include <memory>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Probe;

namespace {

/** How many threads of this process have the name. */
int threadsOf(const std::string& name) {
    int count = 0;
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
        std::string word;
        std::ifstream(task.path() / "comm") >> word;
        count += word == name;
    }
    return count;
}

class Server : public Probe {
public:
    explicit Server(const std::string& name = "server") : Probe(name) {
        addOperation("threadId", &Server::threadId, this, OwnThread);
    }
    unsigned threadId() { return static_cast<unsigned>(gettid()); }
};

template <class Component>
std::unique_ptr<Component> promised() {
    const internal::ActivityFollows follows("promised");
    return std::make_unique<Component>("promised");
}

TEST(DeferredActivity, MakesNoThreadForAComponentThatGetsAnotherActivity) {
    const auto component = promised<Probe>();
    EXPECT_TRUE(component->isActive());
    EXPECT_EQ(threadsOf("promised"), 0);
    ASSERT_TRUE(component->setActivity(new extras::SequentialActivity));
    EXPECT_EQ(threadsOf("promised"), 0);
}

TEST(DeferredActivity, IsPromisedToOneComponentOnly) {
    const internal::ActivityFollows follows("promised");
    TaskContext other("other");
    EXPECT_EQ(threadsOf("other"), 1);
    TaskContext promised("promised");
    EXPECT_EQ(threadsOf("promised"), 0);
    TaskContext again("promised");
    EXPECT_EQ(threadsOf("promised"), 1);
}

TEST(DeferredActivity, PromiseEndsWithItsScope) {
    { const internal::ActivityFollows follows("component"); }
    TaskContext component("component");
    EXPECT_EQ(threadsOf("component"), 1);
}

TEST(DeferredActivity, ExecutesOperationsInAThreadOfTheComponent) {
    const auto server = promised<Server>();
    OperationCaller<unsigned()> threadId(server->getOperation("threadId"), internal::GlobalEngine::Instance());
    const unsigned executed = threadId();
    EXPECT_NE(executed, static_cast<unsigned>(gettid()));
    EXPECT_EQ(executed, server->getActivity()->thread()->getPid());
    EXPECT_EQ(threadId(), executed);
}

TEST(DeferredActivity, LetsTheComponentRunAndStop) {
    const auto component = promised<Probe>();
    ASSERT_TRUE(component->configure());
    ASSERT_TRUE(component->start());
    EXPECT_TRUE(eventually([&] { return component->updates > 0; }));
    EXPECT_TRUE(component->isActive());
    EXPECT_TRUE(component->stop());
}

TEST(DeferredActivity, TakesAPeriod) {
    const auto component = promised<Probe>();
    ASSERT_TRUE(component->setPeriod(0.001));
    EXPECT_DOUBLE_EQ(component->getPeriod(), 0.001);
    ASSERT_TRUE(component->configure() && component->start());
    EXPECT_TRUE(eventually([&] { return component->updates > 5; }));
}

TEST(DeferredActivity, IsAnActivityForWhoLooksAtIt) {
    const auto component = promised<Probe>();
    auto* const activity = component->getActivity<Activity>();
    ASSERT_NE(activity, nullptr);
    EXPECT_TRUE(activity->isActive());
    EXPECT_STREQ(activity->getName(), "promised");
    EXPECT_EQ(activity->getRunner(), component->engine());
    EXPECT_TRUE(component->setActivity(activity)) << "it is the present one, and owned already";
    EXPECT_EQ(component->getActivity(), activity);
    EXPECT_TRUE(activity->stop());
    EXPECT_FALSE(component->isActive());
    EXPECT_TRUE(component->activate());
    EXPECT_TRUE(activity->isActive());
}

TEST(DeferredActivity, IsAMasterForSlaves) {
    const auto master = promised<Probe>();
    Server slave;
    ASSERT_TRUE(slave.setActivity(new extras::SlaveActivity(master->getActivity())));
    OperationCaller<unsigned()> threadId(slave.getOperation("threadId"), internal::GlobalEngine::Instance());
    EXPECT_EQ(threadId(), master->getActivity()->thread()->getPid());
}

TEST(DeferredActivity, IsKeptWhenItIsForcedAgain) {
    class Forcing : public Probe {
    public:
        using Probe::Probe;
        void force() { forceActivity(getActivity()); }
    };
    const auto component = promised<Forcing>();
    component->force();
    EXPECT_TRUE(component->isActive());
    ASSERT_TRUE(component->configure() && component->start());
    EXPECT_TRUE(eventually([&] { return component->updates > 0; }));
    EXPECT_TRUE(component->getActivity()->stop());
}

TEST(DeferredActivity, StopsForAnotherThatTookTheRunner) {
    const auto component = promised<Probe>();
    Activity other(component->engine(), "other");
    EXPECT_TRUE(other.start());
    EXPECT_TRUE(component->getActivity()->start());
    EXPECT_EQ(component->engine()->getActivity(), component->getActivity());
    EXPECT_FALSE(other.isActive());
}

TEST(DeferredActivity, HandsOverWhatItWasSent) {
    const auto server = promised<Server>();
    OperationCaller<unsigned()> threadId(server->getOperation("threadId"), internal::GlobalEngine::Instance());
    (void)threadId();
    ASSERT_TRUE(server->setActivity(new Activity(nullptr, "another")));
    EXPECT_EQ(threadId(), server->getActivity()->thread()->getPid());
}

TEST(DeferredActivity, AnswersAllWhoCallWhileItIsExchanged) {
    for (int round = 0; round < 20; ++round) {
        const auto server = promised<Server>();
        std::atomic<int> answers{0};
        std::vector<std::thread> callers;
        for (int i = 0; i < 3; ++i)
            callers.emplace_back([&] {
                OperationCaller<unsigned()> threadId(server->getOperation("threadId"),
                                                     internal::GlobalEngine::Instance());
                for (int call = 0; call < 20; ++call)
                    if (threadId() != 0) ++answers;
            });
        ASSERT_TRUE(server->setActivity(new Activity(nullptr, "another")));
        for (std::thread& caller : callers) caller.join();
        EXPECT_EQ(answers, 60);
    }
}

}  // namespace
