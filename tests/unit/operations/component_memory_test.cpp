// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a component costs in resident memory.
#include <rtt/TaskContext.hpp>
#include <rtt/extras/SequentialActivity.hpp>

#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

using namespace RTT;

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kMeasurable = false;
#else
constexpr bool kMeasurable = true;
#endif
constexpr int kComponents = 1000;

long residentBytes() {
    long total = 0, resident = 0;
    if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(file, "%ld %ld", &total, &resident) != 2) resident = 0;
        std::fclose(file);
    }
    return resident * sysconf(_SC_PAGESIZE);
}

long bytesPerComponent(bool sequential) {
    std::vector<std::unique_ptr<TaskContext>> components;
    const auto add = [&] {
        components.push_back(std::make_unique<TaskContext>("component" + std::to_string(components.size())));
        if (sequential) components.back()->setActivity(new extras::SequentialActivity);
    };
    add();  // what is made once for all of them
    const long before = residentBytes();
    for (int i = 0; i != kComponents; ++i) add();
    usleep(300000);  // the threads have come to sleep
    return (residentBytes() - before) / kComponents;
}

/** In a process of its own, which has freed nothing yet. */
long measure(bool sequential) {
    int ends[2];
    if (pipe(ends) != 0) return -1;
    const pid_t child = fork();
    if (child == 0) {
        const long bytes = bytesPerComponent(sequential);
        _exit(write(ends[1], &bytes, sizeof bytes) == sizeof bytes ? 0 : 1);
    }
    long bytes = -1;
    close(ends[1]);
    if (read(ends[0], &bytes, sizeof bytes) != sizeof bytes) bytes = -1;
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return bytes;
}

TEST(ComponentMemory, WithASequentialActivityIsAtMost25Kilobytes) {
    if (!kMeasurable) GTEST_SKIP() << "sanitizers have memory of their own";
    const long bytes = measure(true);
    RecordProperty("bytes", static_cast<int>(bytes));
    EXPECT_GT(bytes, 0);
    EXPECT_LE(bytes, 25 * 1000);
}

TEST(ComponentMemory, WithAnIdleThreadIsAtMost45Kilobytes) {
    if (!kMeasurable) GTEST_SKIP() << "sanitizers have memory of their own";
    const long bytes = measure(false);
    RecordProperty("bytes", static_cast<int>(bytes));
    EXPECT_GT(bytes, 0);
    EXPECT_LE(bytes, 45 * 1000);
}

}  // namespace
