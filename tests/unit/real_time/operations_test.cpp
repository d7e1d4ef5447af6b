// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Calling, sending and collecting operations; on the caller's side and on that of the component.
#include <support/real_time_trap.hpp>

#include <rtt/Activity.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/OperationCallerC.hpp>
#include <rtt/internal/calls/call_pool.hpp>

#include <atomic>
#include <gtest/gtest.h>
#include <string>
#include <vector>

using namespace RTT;
using oroforge::test::expectRealTime;
using oroforge::test::RealTimeTrap;

namespace {

typedef std::vector<double> Samples;

class RealTimeOperations : public testing::Test {
protected:
    void SetUp() override {
        OROFORGE_NEEDS_REAL_TIME_TRAP();
        server.addOperation(
            "add", [](double a, double b) { return a + b; }, ClientThread);
        server.addOperation(
            "size", [](const Samples& s) { return s.size(); }, ClientThread);
        server.addOperation(
            "own", [](double a) { return 2 * a; }, OwnThread);
        server.addOperation(
            "fill", [](double a, Samples& s) { s.assign(s.size(), a); }, OwnThread);
    }
    ~RealTimeOperations() override {
        server.stop();
        if (server.getActivity()) server.getActivity()->stop();
    }
    /** Executed by those who call update(). */
    void makeManual() { ASSERT_TRUE(server.setActivity(new extras::SlaveActivity())); }

    TaskContext server{"server"};
    ExecutionEngine* const global = internal::GlobalEngine::Instance();
};

}  // namespace

TEST_F(RealTimeOperations, CallsInTheThreadOfTheCaller) {
    OperationCaller<double(double, double)> add(server.getOperation("add"), global);
    OperationCaller<std::size_t(const Samples&)> size(server.getOperation("size"), global);
    const Samples samples(100);
    double sum = add(1, 2);
    std::size_t count = size(samples);
    expectRealTime([&] {
        EXPECT_TRUE(add.ready());
        sum = add(3, 4) + add.call(5, 6);
        count = size(samples);
    });
    EXPECT_EQ(sum, 18);
    EXPECT_EQ(count, 100u);
}

TEST_F(RealTimeOperations, CallsWithAnotherSignature) {
    OperationCaller<double(const double&, double)> add(server.getOperation("add"), global);
    OperationCaller<void(double, double)> ignoring(server.getOperation("add"), global);
    double sum = add(1, 2);
    ignoring(1, 2);
    expectRealTime([&] {
        sum = add(3, 4) + add.call(5, 6);
        ignoring(3, 4);
    });
    EXPECT_EQ(sum, 18);
}

TEST_F(RealTimeOperations, AskingWhetherARequesterIsReady) {
    OperationCaller<void()> missing("an_operation_of_a_long_name_that_nobody_offers");
    const auto requester = server.requires_("driver");
    ASSERT_TRUE(requester->addOperationCaller(missing));
    bool ready = true;
    expectRealTime([&] { ready = requester->ready(); });
    EXPECT_FALSE(ready);
}

TEST_F(RealTimeOperations, SendingExecutingAndCollecting) {
    makeManual();
    OperationCaller<double(double)> own(server.getOperation("own"), global);
    double result = 0;
    auto once = [&] {
        SendHandle<double(double)> handle = own.send(21);
        EXPECT_TRUE(handle.ready());
        EXPECT_EQ(handle.collectIfDone(result), SendNotReady);
        EXPECT_TRUE(server.update());
        EXPECT_EQ(handle.collectIfDone(result), SendSuccess);
        EXPECT_EQ(handle.collect(result), SendSuccess);
        EXPECT_EQ(handle.ret(), 42);
    };
    once();
    result = 0;
    expectRealTime([&] {
        for (int i = 0; i < 20; ++i) once();
    });
    EXPECT_EQ(result, 42);
}

TEST_F(RealTimeOperations, ManyCallsMayBeUnderWay) {
    makeManual();
    OperationCaller<double(double)> own(server.getOperation("own"), global);
    { (void)own.send(1); }
    server.update();
    SendHandle<double(double)> handles[100];
    expectRealTime([&] {
        for (auto& handle : handles) handle = own.send(1);
        EXPECT_TRUE(server.update());
        double sum = 0, result = 0;
        for (auto& handle : handles) {
            EXPECT_EQ(handle.collectIfDone(result), SendSuccess);
            sum += result;
            handle = SendHandle<double(double)>();
        }
        EXPECT_EQ(sum, 200);
    });
}

TEST_F(RealTimeOperations, ArgumentsByReferenceAreBroughtBack) {
    makeManual();
    OperationCaller<void(double, Samples&)> fill(server.getOperation("fill"), global);
    Samples samples(3);
    const unsigned locks = RealTimeTrap::kLock | RealTimeTrap::kWait;  // copying a vector into a new call allocates
    expectRealTime(
        [&] {
            auto handle = fill.send(7, samples);
            EXPECT_TRUE(server.update());
            EXPECT_EQ(handle.collectIfDone(samples), SendSuccess);
        },
        locks);
    EXPECT_EQ(samples, Samples(3, 7.0));
}

TEST_F(RealTimeOperations, ACallToAnotherThreadWaitsAndDoesNothingElse) {
    OperationCaller<double(double)> own(server.getOperation("own"), global);
    double sum = own(1);
    expectRealTime([&] { sum += own(2); }, RealTimeTrap::kEverything & ~unsigned(RealTimeTrap::kWait));
    EXPECT_EQ(sum, 6);
}

TEST_F(RealTimeOperations, CallingAgainThroughDataSources) {
    makeManual();
    double a = 1, sum = 0;
    internal::OperationCallerC call(server.getOperation("add"), "add", global);
    call.arg(a).argC(10.0).ret(sum);
    ASSERT_TRUE(call.call());
    expectRealTime([&] {
        a = 5;
        EXPECT_TRUE(call.call());
        EXPECT_TRUE(call.ready());
    });
    EXPECT_EQ(sum, 15);
    base::DataSourceBase::shared_ptr source = server.getOperation("add")->produce(
        {new internal::ValueDataSource<double>(1), new internal::ConstantDataSource<double>(2)}, global);
    ASSERT_TRUE(source->evaluate());
    expectRealTime([&] { EXPECT_TRUE(source->evaluate()); });
}

TEST_F(RealTimeOperations, TheCallPoolGivesAndTakesBack) {
    internal::CallPool::give(internal::CallPool::take(100));
    expectRealTime([] {
        void* small = internal::CallPool::take(200);
        void* large = internal::CallPool::take(1000);
        EXPECT_TRUE(internal::CallPool::owns(small) && internal::CallPool::owns(large));
        internal::CallPool::give(large);
        internal::CallPool::give(small);
    });
}
