// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What every component has from the moment of its construction: state, activity, operations, attributes.
#include "../types/builtin_typekit.hpp"
#include "probe.hpp"

#include <rtt/Activity.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/internal/plugin_loading.hpp>

#include <gmock/gmock.h>

#include <type_traits>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Probe;
using testing::ElementsAre;

namespace {

static_assert(TaskContext::Init == 0 && TaskContext::PreOperational == 1 && TaskContext::FatalError == 2 &&
                  TaskContext::Exception == 3 && TaskContext::Stopped == 4 && TaskContext::Running == 5 &&
                  TaskContext::RunTimeError == 6,
              "remote components send the numbers");
static_assert(!std::is_copy_constructible_v<TaskContext> && !std::is_copy_assignable_v<TaskContext>);
static_assert(std::is_base_of_v<base::TaskCore, TaskContext>);
static_assert(std::is_base_of_v<base::RunnableInterface, ExecutionEngine>);

TEST(NewComponent, HasAnActiveThreadOfItsOwn) {
    TaskContext c("new");
    EXPECT_EQ(c.getName(), "new");
    EXPECT_EQ(c.getTaskState(), TaskContext::Stopped);
    EXPECT_EQ(c.getTargetState(), TaskContext::Stopped);
    EXPECT_TRUE(c.isActive());
    auto* const activity = c.getActivity<Activity>();
    ASSERT_TRUE(activity);
    EXPECT_EQ(activity->getRunner(), c.engine());
    EXPECT_EQ(c.engine()->getActivity(), activity);
    EXPECT_EQ(c.engine()->getParent(), &c);
    EXPECT_EQ(c.engine()->getTaskCore(), &c);
    EXPECT_STREQ(activity->getName(), "new");
    EXPECT_FALSE(activity->isPeriodic());
    EXPECT_EQ(activity->getScheduler(), ORO_SCHED_OTHER);
    EXPECT_EQ(activity->getPriority(), 0) << "os::LowestPriority is none, with this scheduler";
    EXPECT_EQ(activity->getRunner()->getThread(), activity->thread());
}

TEST(NewComponent, BeginsInTheStateItIsTold) {
    TaskContext c("new", TaskContext::PreOperational);
    EXPECT_EQ(c.getTaskState(), TaskContext::PreOperational);
    EXPECT_EQ(c.getTargetState(), TaskContext::PreOperational);
    EXPECT_FALSE(c.isConfigured());
}

struct Row {
    const char* name;
    const char* result;
    std::vector<std::string> arguments;
};

struct StandardInterface : types_test::WithBuiltinTypes {
    Probe c{"c", TaskContext::PreOperational};

    template <class Signature>
    OperationCaller<Signature> op(const char* name) {
        OperationCaller<Signature> caller(c.getOperation(name));
        EXPECT_TRUE(caller.ready()) << name;
        return caller;
    }
};

TEST_F(StandardInterface, OperationsHaveTheirSignaturesAndAreExecutedByTheirCaller) {
    const std::vector<Row> table = {{"configure", "bool", {}},
                                    {"isConfigured", "bool", {}},
                                    {"start", "bool", {}},
                                    {"activate", "bool", {}},
                                    {"stop", "bool", {}},
                                    {"isRunning", "bool", {}},
                                    {"getPeriod", "double", {}},
                                    {"setPeriod", "bool", {"double"}},
                                    {"getCpuAffinity", "uint", {}},
                                    {"setCpuAffinity", "bool", {"uint"}},
                                    {"isActive", "bool", {}},
                                    {"inFatalError", "bool", {}},
                                    {"error", "void", {}},
                                    {"inRunTimeError", "bool", {}},
                                    {"inException", "bool", {}},
                                    {"cleanup", "bool", {}},
                                    {"update", "bool", {}},
                                    {"trigger", "bool", {}},
                                    {"loadService", "bool", {"string const&"}}};
    const OperationInterface& operations = *c.operations();
    EXPECT_EQ(operations.getNames().size(), table.size());
    for (const Row& row : table) {
        ASSERT_TRUE(operations.hasOperation(row.name)) << row.name;
        EXPECT_EQ(operations.getResultType(row.name), row.result) << row.name;
        std::vector<std::string> arguments;
        for (const ArgumentDescription& argument : operations.getArgumentList(row.name))
            arguments.push_back(argument.type);
        EXPECT_EQ(arguments, row.arguments) << row.name;
        EXPECT_FALSE(operations.getDescription(row.name).empty()) << row.name;
        const auto local =
            boost::dynamic_pointer_cast<base::OperationCallerInterface>(c.provides()->getLocalOperation(row.name));
        ASSERT_TRUE(local) << row.name;
        EXPECT_EQ(local->getThread(), ClientThread) << row.name;
    }
    EXPECT_EQ(operations.getArgumentList("loadService").front().name, "service_name");
}

TEST_F(StandardInterface, OperationsOfTheLifeCycle) {
    EXPECT_FALSE(op<bool()>("isConfigured")());
    EXPECT_FALSE(op<bool()>("start")());
    EXPECT_TRUE(op<bool()>("configure")());
    EXPECT_TRUE(op<bool()>("isConfigured")());
    EXPECT_TRUE(op<bool()>("start")());
    EXPECT_TRUE(op<bool()>("isRunning")());
    op<void()>("error")();
    EXPECT_TRUE(op<bool()>("inRunTimeError")());
    EXPECT_TRUE(op<bool()>("stop")());
    EXPECT_FALSE(op<bool()>("inRunTimeError")());
    EXPECT_TRUE(op<bool()>("cleanup")());
    EXPECT_EQ(c.takeHooks(), "configure start stop cleanup");
    EXPECT_FALSE(op<bool()>("inException")());
    c.exception();
    EXPECT_TRUE(op<bool()>("inException")());
    EXPECT_FALSE(op<bool()>("inFatalError")());
    c.fatal();
    EXPECT_TRUE(op<bool()>("inFatalError")());
}

TEST_F(StandardInterface, OperationsOfTheActivity) {
    EXPECT_TRUE(op<bool()>("isActive")());
    ASSERT_TRUE(c.getActivity()->stop());
    EXPECT_FALSE(op<bool()>("isActive")());
    EXPECT_TRUE(op<bool()>("activate")());
    EXPECT_TRUE(op<bool()>("isActive")());
    EXPECT_EQ(op<double()>("getPeriod")(), 0.0);
    EXPECT_TRUE(op<bool(double)>("setPeriod")(1000.0));
    EXPECT_EQ(op<double()>("getPeriod")(), 1000.0);
    EXPECT_FALSE(op<bool(double)>("setPeriod")(-1.0));
    EXPECT_FALSE(op<bool()>("trigger")()) << "periodic";
    EXPECT_TRUE(op<bool(double)>("setPeriod")(0.0));
    EXPECT_TRUE(op<bool()>("trigger")());
    const unsigned affinity = op<unsigned()>("getCpuAffinity")();
    EXPECT_NE(affinity, 0u);
    EXPECT_TRUE(op<bool(unsigned)>("setCpuAffinity")(affinity));
    EXPECT_FALSE(op<bool()>("update")()) << "it has a thread of its own";
    ASSERT_TRUE(c.setActivity(new extras::SlaveActivity()));
    EXPECT_TRUE(op<bool()>("update")());
}

TEST_F(StandardInterface, OperationsFindTheFunctionsThatASubClassOverrides) {
    struct Own : Probe {
        Own() : Probe("own") {}
        ~Own() override { getActivity()->stop(); }
        bool start() override { return note("own start"), Probe::start(); }
        bool loadService(const std::string& name) override { return name == "own"; }
    } own;
    EXPECT_TRUE(OperationCaller<bool()>(own.getOperation("start"))());
    EXPECT_EQ(own.takeHooks(), "own start start");
    EXPECT_TRUE(OperationCaller<bool(const std::string&)>(own.getOperation("loadService"))("own"));
}

TEST_F(StandardInterface, WithoutActivityThereIsNoPeriod) {
    struct Bare : base::TaskCore {
    } bare;
    EXPECT_EQ(bare.getPeriod(), -1.0);
    EXPECT_EQ(bare.getCpuAffinity(), ~0u);
    EXPECT_FALSE(bare.setPeriod(1.0) || bare.setCpuAffinity(1) || bare.isActive() || bare.activate());
    EXPECT_FALSE(bare.trigger() || bare.update());
    EXPECT_TRUE(bare.start()) << "the state does not depend on it";
    EXPECT_TRUE(bare.stop());
}

TEST_F(StandardInterface, AttributesHaveTheirTypesAndFollowTheComponent) {
    const auto type = [this](const char* name) { return c.getAttribute(name)->getDataSource()->getTypeName(); };
    EXPECT_EQ(type("TriggerOnStart"), "bool");
    EXPECT_TRUE(Attribute<bool>(c.getAttribute("TriggerOnStart")).get());
    ASSERT_TRUE(c.setActivity(new extras::SlaveActivity()));
    for (const char* name : {"CycleCounter", "IOCounter", "TimeOutCounter", "TriggerCounter"}) {
        EXPECT_EQ(type(name), "uint") << name;
        Attribute<unsigned>(c.getAttribute(name)).set(0);
    }
    ASSERT_TRUE(c.update());
    EXPECT_EQ(Attribute<unsigned>(c.getAttribute("CycleCounter")).get(), 1u);
    EXPECT_EQ(Attribute<unsigned>(c.getAttribute("TimeOutCounter")).get(), 1u);
    EXPECT_EQ(Attribute<unsigned>(c.getAttribute("TriggerCounter")).get(), 0u);
    EXPECT_EQ(Attribute<unsigned>(c.getAttribute("IOCounter")).get(), 0u);
}

// Operations that a component has like all others are added when somebody looks for them.
TEST(StandardOperation, GivesWayToTheUsersOwnOfThatName) {
    for (const std::string& name : TaskContext("any").provides()->getNames()) {
        TaskContext c("own");
        c.addOperation(name, [] { return 42; });
        OperationCaller<int()> own(c.getOperation(name));
        ASSERT_TRUE(own.ready()) << name;
        EXPECT_EQ(own(), 42) << name;
        EXPECT_EQ(c.provides()->getNames().size(), 19U) << name;
    }
}

TEST(StandardOperation, IsRemovedBeforeAnybodyLookedForIt) {
    TaskContext c("without");
    c.provides()->removeOperation("update");
    EXPECT_FALSE(c.provides()->hasOperation("update"));
    EXPECT_TRUE(c.provides()->hasOperation("trigger"));
    TaskContext cleared("cleared");
    cleared.clear();
    EXPECT_THAT(cleared.provides()->getNames(), ElementsAre());
}

TEST(StandardOperation, IsFoundByAllWhoLookAtTheSameTime) {
    for (int round = 0; round < 50; ++round) {
        TaskContext c("c");
        std::atomic<int> found{0};
        std::vector<std::thread> users;
        for (int i = 0; i < 4; ++i)
            users.emplace_back([&] {
                found += c.provides()->hasOperation("isRunning") && c.getOperation("getPeriod") &&
                         c.provides()->getNames().size() == 19U && !c.provides()->hasOperation("other");
            });
        for (std::thread& user : users) user.join();
        EXPECT_EQ(found, 4);
    }
}

}  // namespace
