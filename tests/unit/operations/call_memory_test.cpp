// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Calls to the thread of a component take no memory once they have done so. Part of a program with its own operator new.
#include "call_memory.hpp"
#include "probe.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <map>
#include <memory>
#include <string>
#include <vector>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Probe;

namespace {

template <class Call>
unsigned long allocationsOf(Call&& call) {
    call();
    const unsigned long before = oroforge::test::allocations();
    for (int i = 0; i != 2000; ++i) call();
    return oroforge::test::allocations() - before;
}

struct CallMemory : testing::Test {
    Probe server{"server"};
    template <class Signature, class Function>
    OperationCaller<Signature> caller(Function function) {
        server.addOperation("operation", function, OwnThread);
        return OperationCaller<Signature>(server.getOperation("operation"), internal::GlobalEngine::Instance());
    }
};

TEST_F(CallMemory, OfAVectorByConstantReference) {
    auto sum = caller<double(const std::vector<double>&)>([](const std::vector<double>& values) {
        double all = 0;
        for (const double value : values) all += value;
        return all;
    });
    std::vector<double> values(1000, 0.5);
    EXPECT_EQ(sum(values), 500);
    EXPECT_EQ(allocationsOf([&] { sum(values); }), 0u);
    values[0] = 1.5;
    EXPECT_EQ(sum(values), 501);
    EXPECT_EQ(sum({1, 2}), 3);
}

TEST_F(CallMemory, OfTextsAndAnArgumentThatIsChanged) {
    const std::string text(100, 'x');
    auto append = caller<void(const std::string&, std::vector<int>&)>(
        [](const std::string& more, std::vector<int>& sizes) { sizes[0] += static_cast<int>(more.size()); });
    std::vector<int> sizes(100, 0);
    append(text, sizes);
    EXPECT_EQ(sizes[0], 100);
    EXPECT_EQ(allocationsOf([&] { append(text, sizes); }), 0u);
    EXPECT_EQ(sizes[0], 100 * 2002);
}

TEST_F(CallMemory, TheOperationThrowsInBetween) {
    auto check = caller<int(const std::vector<int>&)>([](const std::vector<int>& values) {
        if (values.empty()) throw std::runtime_error("empty");
        return values[0];
    });
    EXPECT_EQ(check({7}), 7);
    EXPECT_THROW(check({}), std::runtime_error);
    ASSERT_TRUE(server.recover());
    EXPECT_EQ(check({8}), 8);
    EXPECT_EQ(check({9}), 9);
}

TEST_F(CallMemory, WhatAPointerRefersToIsReleasedAtOnce) {
    auto take = caller<void(const std::vector<int>&, std::shared_ptr<int>)>(
        [](const std::vector<int>&, const std::shared_ptr<int>&) {});
    std::weak_ptr<int> released;
    {
        const auto value = std::make_shared<int>(1);
        released = value;
        take({1}, value);
    }
    EXPECT_TRUE(eventually([&] { return released.expired(); }));
}

// Copies of these can be made, but none can be assigned.
TEST_F(CallMemory, OfACallerThatIsBoundAnewWhileItWaits) {
    Probe other("other");
    other.addOperation(
        "operation", [](const std::string& text) { return text + "!"; }, OwnThread);
    Probe client("client");
    OperationCaller<std::string(const std::string&)> shared;
    client.addOperation(
        "rebind", [&] { shared = other.getOperation("operation"); }, OwnThread);
    server.addOperation(
        "operation",
        [&](const std::string& text) {
            OperationCaller<void()> rebind(client.getOperation("rebind"), server.engine());
            rebind();
            return text + "?";
        },
        OwnThread);
    std::string answers;
    client.addOperation(
        "ask",
        [&] {
            answers = shared(std::string(100, 'a'));
            answers += shared("b");
        },
        OwnThread);
    shared.setCaller(client.engine());
    shared = server.getOperation("operation");
    OperationCaller<void()> ask(client.getOperation("ask"), internal::GlobalEngine::Instance());
    ask();
    EXPECT_EQ(answers, std::string(100, 'a') + "?b!");
}

TEST_F(CallMemory, OfWhatCannotBeAssigned) {
    struct Constant {
        const int number;
    };
    auto count = caller<int(const std::vector<Constant>&, const std::string&)>(
        [](const std::vector<Constant>& all, const std::string&) { return all.empty() ? 0 : all.back().number; });
    EXPECT_EQ(count({{1}, {2}}, "a"), 2);
    auto size = caller<int(const std::map<int, const std::string>&)>(
        [](const std::map<int, const std::string>& all) { return static_cast<int>(all.size()); });
    EXPECT_EQ(size({{1, "a"}, {2, "b"}}), 2);
}

TEST_F(CallMemory, OfManyThreadsThatShareACaller) {
    auto size = caller<int(const std::vector<int>&)>(
        [](const std::vector<int>& values) { return static_cast<int>(values.size()); });
    std::vector<std::thread> threads;
    for (int thread = 1; thread != 5; ++thread)
        threads.emplace_back([&, thread] {
            const std::vector<int> values(thread * 10);
            for (int i = 0; i != 500; ++i) ASSERT_EQ(size(values), thread * 10);
        });
    for (std::thread& thread : threads) thread.join();
}

}  // namespace
