// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "file_descriptor_test.hpp"

#include <memory>
#include <sys/resource.h>
#include <thread>

using namespace RTT;
using extras::FileDescriptorActivity;
using oroforge::test::CountingRunner;
using oroforge::test::eventually;
using oroforge::test::FileDescriptorActivityTest;
using oroforge::test::LogCapture;
using oroforge::test::Pipe;

TEST_F(FileDescriptorActivityTest, InvalidArgumentsAreReportedAndIgnored) {
    const LogCapture log;
    a.watch(-1);
    EXPECT_FALSE(a.isWatched(-1));
    a.setTimeout(7);
    a.setTimeout(-1);
    a.setTimeout_us(-1);
    EXPECT_EQ(a.getTimeout(), 7);
    EXPECT_EQ(log.count(3, "'io': cannot watch file descriptor -1"), 1);
    EXPECT_EQ(log.count(3, "'io': invalid timeout of -1 ms"), 1);
    EXPECT_EQ(log.count(3, "'io': invalid timeout of -1 us"), 1);
}

TEST_F(FileDescriptorActivityTest, ReadyDescriptorsAreSeenBesideATimeout) {
    a.watch(pipe.read);
    ASSERT_TRUE(a.start());
    for (int i = 1; i <= 50; ++i) {
        ASSERT_TRUE(pipe.put());
        a.timeout();
        EXPECT_TRUE(eventually([&] { return taken == i && r.timeouts == i; }));
    }
}

TEST_F(FileDescriptorActivityTest, UnwatchedDescriptorsAreIgnored) {
    Pipe other;
    startIdle();
    a.watch(pipe.read);
    a.watch(pipe.read);  // once is enough
    a.watch(other.read);
    a.unwatch(pipe.read);
    EXPECT_FALSE(a.isWatched(pipe.read));
    ASSERT_TRUE(pipe.put());
    usleep(5000);
    EXPECT_EQ(r.ios, 0);
    a.clearAllWatches();
    EXPECT_FALSE(a.isWatched(other.read));
    ASSERT_TRUE(other.put());
    usleep(5000);
    EXPECT_EQ(r.ios, 0);
    EXPECT_EQ(taken, 0);
}

TEST_F(FileDescriptorActivityTest, NoTriggerIsLostWhenTheWatchesChange) {
    startIdle();
    for (int i = 0; i < 2000; ++i) {
        const int before = r.triggers;
        i % 2 ? a.unwatch(pipe.read) : a.watch(pipe.read);
        ASSERT_TRUE(a.trigger());
        ASSERT_TRUE(eventually([&] { return r.triggers > before; })) << "trigger " << i;
    }
}

TEST_F(FileDescriptorActivityTest, NoTimeoutIsLostWhenTheWatchesChange) {
    startIdle();
    std::atomic<bool> quit{false};
    std::thread changes([&] {
        while (!quit) {
            a.watch(pipe.read);
            a.unwatch(pipe.read);
        }
    });
    for (int i = 0; i < 1000; ++i) {
        const int before = r.timeouts;
        ASSERT_TRUE(a.timeout());
        ASSERT_TRUE(eventually([&] { return r.timeouts > before; })) << "timeout " << i;
    }
    quit = true;
    changes.join();
}

TEST_F(FileDescriptorActivityTest, AClosedDescriptorIsReportedOnceAndDropped) {
    const LogCapture log;
    startIdle();
    Pipe bad;
    const int fd = bad.read;
    a.watch(fd);
    bad.closeRead();
    a.trigger();
    EXPECT_TRUE(eventually([&] { return hadError == 1; }));
    usleep(20000);  // it does not go on and on
    EXPECT_LE(r.steps, 2);
    EXPECT_FALSE(a.isWatched(fd));
    EXPECT_EQ(log.count(3, "file descriptor " + std::to_string(fd) + " is not open"), 1);
    a.watch(pipe.read);
    ASSERT_TRUE(pipe.put());
    EXPECT_TRUE(eventually([&] { return taken == 1; }));
    EXPECT_FALSE(a.hasError());
}

TEST_F(FileDescriptorActivityTest, ARefusedWaitIsReportedOnceAndTriedAgain) {
    const LogCapture log;
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
    startIdle();
    a.watch(pipe.read);
    rlimit none = before;
    none.rlim_cur = 1;  // poll() refuses more descriptors than that
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
    a.trigger();
    EXPECT_TRUE(eventually([&] { return hadError >= 2; }));
    EXPECT_TRUE(a.trigger());  // still at work
    EXPECT_EQ(log.count(3, "cannot wait for the file descriptors"), 1);
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
    EXPECT_TRUE(eventually([&] { return a.trigger() && !a.hasError(); }));
    ASSERT_TRUE(pipe.put());
    EXPECT_TRUE(eventually([&] { return taken == 1; }));
}

TEST_F(FileDescriptorActivityTest, TheEndOfAFileIsReady) {
    Pipe other;
    std::atomic<bool> ended{false};
    r.onWork = [&](auto) {
        if (!a.isUpdated(other.read)) return;
        ended = true;
        a.unwatch(other.read);
    };
    startIdle();
    a.watch(other.read);
    other.closeWrite();
    EXPECT_TRUE(eventually([&] { return ended.load(); }));
    EXPECT_TRUE(eventually([&] { return !a.isWatched(other.read); }));
    EXPECT_FALSE(a.isUpdated(other.read));
}

TEST_F(FileDescriptorActivityTest, DescriptorsMayHaveAnyNumber) {
    const int high = ::fcntl(pipe.read, F_DUPFD_CLOEXEC, 1500);
    if (high < 0) GTEST_SKIP() << "the limit of open files is too low";
    std::atomic<int> ready{0};
    r.onWork = [&](auto) {
        if (a.isUpdated(high)) ++ready;
        while (pipe.take()) ++taken;
    };
    startIdle();
    a.watch(high);
    ASSERT_TRUE(pipe.put());
    EXPECT_TRUE(eventually([&] { return ready == 1 && taken == 1; }));
    a.stop();
    ::close(high);
}

TEST_F(FileDescriptorActivityTest, ManyDescriptorsAreToldApart) {
    std::vector<std::unique_ptr<Pipe>> pipes;
    for (int i = 0; i < 40; ++i) pipes.emplace_back(new Pipe);
    std::vector<std::atomic<int>> got(pipes.size());
    r.onWork = [&](auto) {
        for (std::size_t i = 0; i < pipes.size(); ++i)
            if (a.isUpdated(pipes[i]->read))
                while (pipes[i]->take()) ++got[i];
    };
    for (const auto& each : pipes) a.watch(each->read);
    ASSERT_TRUE(a.start());
    for (std::size_t i = 0; i < pipes.size(); ++i) {
        ASSERT_TRUE(pipes[i]->put());
        ASSERT_TRUE(eventually([&] { return got[i] == 1; })) << i;
    }
    EXPECT_TRUE(a.stop());  // before the pipes are gone
}

TEST(FileDescriptorActivityStorm, StartStopTriggerAndWatchFromSeveralThreads) {
    Pipe pipe;
    CountingRunner r;
    FileDescriptorActivity a(ORO_SCHED_OTHER, 0, &r);
    std::atomic<bool> quit{false};
    std::vector<std::thread> threads;
    threads.emplace_back([&] {
        while (!quit) a.trigger(), a.timeout(), (void)a.isUpdated(pipe.read);
    });
    threads.emplace_back([&] {
        while (!quit) a.watch(pipe.read), a.setTimeout_us(100), a.clearAllWatches(), a.setTimeout(0);
    });
    threads.emplace_back([&] {
        while (!quit) a.start(), a.stop();
    });
    for (int i = 0; i < 200; ++i) {
        a.start();
        usleep(200);
        a.stop();
    }
    quit = true;
    for (std::thread& thread : threads) thread.join();
    EXPECT_TRUE(eventually([&] { return !a.isActive() || a.stop(); }));
    EXPECT_EQ(r.initialized, r.finalized);
    const int triggers = r.triggers;
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return r.triggers > triggers; }));
}
