// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Connections and signals that outlive each other, or are used by several threads.
#include "probe.hpp"

#include <rtt/internal/Signal.hpp>

#include <memory>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Probe;

namespace {

typedef internal::Signal<void(int)> IntSignal;

/** Memory that was just freed, if that is possible, has other contents afterwards. */
void dirtyTheHeap() {
    std::vector<std::unique_ptr<char[]>> blocks;
    for (std::size_t size = 16; size <= 512; size += 16)
        for (int i = 0; i != 8; ++i) {
            blocks.emplace_back(new char[size]);
            std::fill_n(blocks.back().get(), size, 'Z');
        }
}

TEST(SignalLife, HandleThatIsNotConnectedOutlivesTheSignal) {
    Handle disconnected, prepared;
    {
        auto signal = std::make_unique<IntSignal>();
        disconnected = signal->connect([](int) {});
        disconnected.disconnect();
        prepared = signal->setup([](int) {});
    }
    dirtyTheHeap();
    EXPECT_FALSE(disconnected.connect());
    EXPECT_FALSE(prepared.connect());
    EXPECT_FALSE(prepared.disconnect());
    EXPECT_FALSE(prepared.connected());
}

TEST(SignalLife, HandleOutlivesTheComponentOfItsOperation) {
    Handle handle;
    {
        Probe c;
        handle = c.addOperation("op", [](int) {}).signals([](int) {});
        handle.disconnect();
    }
    dirtyTheHeap();
    EXPECT_FALSE(handle.connect());
}

TEST(SignalLife, CleanupHandleForgetsItsFunction) {
    IntSignal signal;
    auto witness = std::make_shared<int>(0);
    {
        CleanupHandle handle(signal.connect([witness](int n) { *witness += n; }));
        signal.emit(2);
        EXPECT_EQ(*witness, 2);
    }
    signal.emit(2);
    EXPECT_EQ(*witness, 2);
    EXPECT_EQ(witness.use_count(), 1) << "the signal still holds the function";
}

TEST(SignalLife, HandlersMayConnectOthers) {
    IntSignal signal;
    int late = 0;
    Handle added;
    Handle first = signal.connect([&](int) {
        if (!added.ready()) added = signal.connect([&](int) { ++late; });
    });
    signal.emit(1);
    EXPECT_EQ(late, 0) << "counts from the next emission";
    signal.emit(1);
    EXPECT_EQ(late, 1);
}

TEST(SignalLife, EachHandlerHasAValueOfItsOwn) {
    internal::Signal<void(std::string &&)> signal;
    std::vector<std::string> heard;
    const auto steal = [&](std::string&& text) { heard.push_back(std::move(text)); };
    Handle a = signal.connect(steal), b = signal.connect(steal);
    const std::string text = "a text that is long enough not to be stored in place";
    signal.emit(std::string(text));
    EXPECT_EQ(heard, (std::vector<std::string>{text, text}));
}

TEST(SignalLife, ReferencesReachTheCallerOfTheSignal) {
    internal::Signal<void(int&, const std::string&)> signal;
    const std::string text = "x";
    const std::string* seen = nullptr;
    Handle a = signal.connect([&](int& n, const std::string& s) { ++n, seen = &s; });
    int n = 1;
    signal.emit(n, text);
    EXPECT_EQ(n, 2);
    EXPECT_EQ(seen, &text);
}

TEST(SignalLifeStress, ManyThreadsConnectEmitAndDisconnect) {
    IntSignal signal;
    std::atomic<bool> stop{false};
    std::atomic<long> calls{0}, wrong{0};
    std::vector<std::thread> threads;
    for (int i = 0; i != 2; ++i)
        threads.emplace_back([&] {
            while (!stop) signal.emit(3);
        });
    for (int i = 0; i != 2; ++i)
        threads.emplace_back([&] {
            for (int n = 0; n != 500; ++n) {
                auto own = std::make_shared<int>(3);
                ScopedHandle handle(signal.connect([own, &calls, &wrong](int value) {
                    ++calls;
                    if (value != *own) ++wrong;
                }));
                const long before = calls;
                eventually([&] { return calls != before; });
            }
        });
    threads[2].join();
    threads[3].join();
    stop = true;
    threads[0].join();
    threads[1].join();
    EXPECT_GE(calls, 500);
    EXPECT_EQ(wrong, 0);
}

}  // namespace
