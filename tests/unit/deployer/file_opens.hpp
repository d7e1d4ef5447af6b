// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_FILE_OPENS_HPP
#define OROFORGE_TESTS_FILE_OPENS_HPP

#include <gtest/gtest.h>

#include <string>

#include <sys/inotify.h>
#include <unistd.h>

namespace deployer_test {

/** Counts how often any process opens a file. */
class FileOpens {
public:
    // Equal events that follow each other are one: those of closing are between those of opening.
    explicit FileOpens(const std::string& file) : events_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
        EXPECT_GE(inotify_add_watch(events_, file.c_str(), IN_OPEN | IN_CLOSE), 0) << file;
    }
    FileOpens(const FileOpens&) = delete;
    FileOpens& operator=(const FileOpens&) = delete;
    ~FileOpens() { close(events_); }

    /** Since the last call. */
    int count() {
        int opens = 0;
        inotify_event events[64];  // without names: a file is watched, no directory
        for (ssize_t size; (size = read(events_, events, sizeof events)) > 0;)
            for (const inotify_event* event = events; event != events + size / static_cast<ssize_t>(sizeof *event);
                 ++event)
                opens += (event->mask & IN_OPEN) != 0;
        return opens;
    }

private:
    const int events_;
};

}  // namespace deployer_test

#endif
