// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_UNIT_OS_FILE_DESCRIPTOR_TEST_HPP
#define OROFORGE_TESTS_UNIT_OS_FILE_DESCRIPTOR_TEST_HPP

#include "os_test.hpp"

#include <rtt/extras/FileDescriptorActivity.hpp>

#include <fcntl.h>

namespace oroforge::test {

struct Pipe {
    int read = -1, write = -1;
    Pipe() {
        int ends[2] = {-1, -1};
        if (::pipe2(ends, O_CLOEXEC | O_NONBLOCK) == 0) {
            read = ends[0];
            write = ends[1];
        }
    }
    ~Pipe() {
        closeRead();
        closeWrite();
    }
    void closeRead() { closeEnd(read); }
    void closeWrite() { closeEnd(write); }
    bool put() const { return ::write(write, "x", 1) == 1; }
    bool take() const {
        char c = 0;
        return ::read(read, &c, 1) == 1;
    }

private:
    static void closeEnd(int& fd) {
        if (fd >= 0) ::close(fd);
        fd = -1;
    }
};

/** A runner whose step takes a character out of the pipe, and the activity that watches it. */
struct FileDescriptorActivityTest : testing::Test {
    Pipe pipe;
    std::atomic<int> taken{0}, updated{0}, hadTimeout{0}, hadError{0};
    CountingRunner r;
    RTT::extras::FileDescriptorActivity a{ORO_SCHED_OTHER, 0, &r, "io"};

    FileDescriptorActivityTest() {
        r.onWork = [this](auto) {
            if (pipe.read >= 0 && a.isUpdated(pipe.read)) ++updated;
            if (a.hasTimeout()) ++hadTimeout;
            if (a.hasError()) ++hadError;
            if (pipe.read >= 0 && pipe.take()) ++taken;  // one, so that what is put meanwhile has its own step
        };
    }
    ~FileDescriptorActivityTest() override { a.stop(); }
    void startIdle() {
        ASSERT_TRUE(a.start());
        ASSERT_TRUE(eventually([&] { return r.worked == 1; }));  // the end of what start() itself executes
    }
};

}  // namespace oroforge::test
#endif
