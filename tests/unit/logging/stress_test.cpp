// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Many threads log while appenders write, are changed, and go.
#include "logging_fixture.hpp"

#include <rtt/Activity.hpp>

#include <algorithm>
#include <atomic>
#include <ctime>
#include <map>
#include <set>
#include <functional>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace {

using namespace logging_test;
using log4cpp::Priority;

#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
constexpr int kEvents = 2000;
#else
constexpr int kEvents = 100000;
#endif
constexpr int kThreads = 8;

class Stress : public Logging {
protected:
    static void SetUpTestSuite() {
        static std::vector<char> memory(64 << 20);
        ASSERT_NE(0u, init_memory_pool(memory.size(), memory.data()));
        Logging::SetUpTestSuite();
    }
    void begin(OCL::logging::FileAppender& file, const std::string& of) {
        property<std::string>(file, "Filename") = (folder / (file.getName() + ".log")).string();
        property<std::string>(file, "LayoutName") = "pattern";
        property<std::string>(file, "LayoutPattern") = "%m%n";
        property<int>(file, "MaxEventsPerCycle") = 0;
        file.setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0.0));
        connect(of, file);
        ASSERT_TRUE(service->configure());
        ASSERT_TRUE(file.configure());
        ASSERT_TRUE(file.start());
    }
    static constexpr std::size_t kRecord = 55;
    static std::string messageOf(int thread, int i) {
        char text[kRecord];
        std::snprintf(text, sizeof text, "t%d %06d %s end", thread, i,
                      std::string(40, static_cast<char>('a' + i % 26)).c_str());
        return text;
    }
    /** Messages of one size, each of which a torn one would show. */
    static void logFrom(int thread, Category& to, int events, const std::function<void()>& between, int first = 0) {
        for (int i = first; i < first + events; ++i) {
            to.info(messageOf(thread, i).c_str());
            between();
        }
    }
    static void inThreads(const std::function<void(int)>& work) {
        std::vector<std::thread> threads;
        for (int t = 0; t < kThreads; ++t) threads.emplace_back(work, t);
        for (std::thread& thread : threads) thread.join();
    }
    /** Checks each line; how many there are of each thread, in order and none twice. */
    std::size_t whole(const std::string& file) {
        std::map<int, int> last;
        std::size_t lines = 0;
        for (const std::string& line : linesOf(oroforge::test::readFile(folder / file))) {
            if (line.compare(0, 2, "# ") == 0) continue;
            int thread = -1, number = -1;
            EXPECT_EQ(2, std::sscanf(line.c_str(), "t%d %d", &thread, &number)) << line;
            EXPECT_EQ(messageOf(thread, number), line);
            const auto before = last.find(thread);
            if (before != last.end()) {
                EXPECT_LT(before->second, number);
            }
            last[thread] = number;
            ++lines;
            if (testing::Test::HasFailure()) break;
        }
        return lines;
    }
};

TEST_F(Stress, NothingIsLostOrTornWhereThereIsRoom) {
    property<int>(*service, "BufferSize") = 20000;
    OCL::logging::FileAppender file("all");
    begin(file, "stress.all");
    Category& to = category("stress.all");
    // Fast enough: nobody is further ahead of the appender than the buffer allows.
    std::atomic<int> logged{0};
    const std::string path = (folder / "all.log").string();
    const auto written = [&] {
        struct stat status {};
        return stat(path.c_str(), &status) == 0 ? static_cast<int>(status.st_size / static_cast<off_t>(kRecord)) : 0;
    };
    inThreads([&](int thread) {
        logFrom(thread, to, kEvents, [&] {
            // A pause when half of the buffer may be full.
            if (++logged % 1000 != 0) return;
            while (logged - written() > 8000) usleep(500);
        });
    });
    file.stop();
    EXPECT_EQ(0u, file.droppedEvents());
    EXPECT_EQ(static_cast<std::size_t>(kThreads) * kEvents, whole("all.log"));
}

TEST_F(Stress, WhatIsDroppedIsCountedExactly) {
    property<int>(*service, "BufferSize") = 100;
    OCL::logging::FileAppender file("some");
    begin(file, "stress.some");
    Category& to = category("stress.some");
    inThreads([&](int thread) { logFrom(thread, to, kEvents, [] {}); });
    file.stop();
    const std::size_t dropped = file.droppedEvents();
    EXPECT_EQ(static_cast<std::size_t>(kThreads) * kEvents, whole("some.log") + dropped + Category::lostMessages());
}

TEST_F(Stress, AppendersComeAndGoWhileEventsFlow) {
    std::atomic<bool> done{false};
    Category& to = category("stress.changing");
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&, t] {
            for (int first = 0; !done && first < 999900; first += 100)
                logFrom(
                    t, to, 100, [] {}, first);
        });
    for (int round = 0; round < 30; ++round) {
        const std::string name = "round" + std::to_string(round);
        OCL::logging::FileAppender file(name);
        property<RTT::PropertyBag>(*service, "Appenders").clear();
        begin(file, "stress.changing");
        usleep(2000);
        if (round % 2 == 0) file.stop();
        service->removePeer(name);
    }  // destroyed while it runs, and while it is connected
    done = true;
    for (std::thread& thread : threads) thread.join();
    for (int round = 0; round < 30; ++round) (void)whole("round" + std::to_string(round) + ".log");
}

TEST_F(Stress, CategoriesAreMadeByManyThreads) {
    inThreads([](int thread) {
        for (int i = 0; i < 200; ++i) {
            const std::string name = "made." + std::to_string(i % 50) + "." + std::to_string((i + thread) % 7);
            EXPECT_NE(nullptr, dynamic_cast<Category*>(&log4cpp::Category::getInstance(name)));
        }
    });
}

}  // namespace
