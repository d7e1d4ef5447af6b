// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_END_NOTICE_HPP
#define OROFORGE_CONSOLE_END_NOTICE_HPP

#include <atomic>
#include <thread>

namespace OCL::console {

/** Tells whoever presses Ctrl-C during a command that it was seen: the console ends after the command, which may take long. */
class EndNotice {
public:
    /** Watches that descriptor, which can be read once the console is to end. */
    explicit EndNotice(int endsOn);
    ~EndNotice();
    EndNotice(const EndNotice&) = delete;
    EndNotice& operator=(const EndNotice&) = delete;

    /** A command begins or is done. */
    void executing(bool yes);

private:
    void watch(int endsOn);
    void tell();

    int over_;
    std::atomic<bool> executing_{false}, ends_{false}, told_{false};
    std::thread thread_;
};

}  // namespace OCL::console

#endif
