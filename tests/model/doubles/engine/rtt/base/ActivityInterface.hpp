// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's header: an activity whose thread is one of the checker's. It sleeps and wakes by the real WakeWord.
#ifndef OROFORGE_MODEL_ACTIVITY_INTERFACE_HPP
#define OROFORGE_MODEL_ACTIVITY_INTERFACE_HPP

#include <rtt/base/RunnableInterface.hpp>
#include <rtt/os/detail/wake_word.hpp>

namespace RTT {
namespace os {
class ThreadInterface;
}
namespace base {

class ActivityInterface {
public:
    explicit ActivityInterface(RunnableInterface* r) : runner(r) { runner->setActivity(this); }
    ~ActivityInterface() {
        if (runner) runner->setActivity(nullptr);
    }
    /** By the runnable that is destroyed. */
    bool run(RunnableInterface*) {
        runner = nullptr;
        return true;
    }
    os::ThreadInterface* thread() { return nullptr; }
    bool start() { return active.exchange(true) == false; }
    bool stop() { return active.exchange(false); }
    bool isActive() const { return active.load(); }
    bool isSelf() const { return model::self() == executor.load(std::memory_order_relaxed); }
    enum class Direct { Refused, Granted, Entered };
    Direct beginDirect() { return isSelf() ? Direct::Granted : Direct::Refused; }
    Direct beginInStead() { return beginDirect(); }
    void endDirect() {}
    bool trigger() {
        if (!isActive()) return false;
        word.post(1);
        return true;
    }
    /** What its thread does, until end(). */
    void loop() {
        executor.store(model::self(), std::memory_order_relaxed);
        for (std::uint32_t reasons = 0; !(reasons & 2);) {
            reasons = word.wait(os::detail::kForever);
            if (reasons & 1 && isActive()) runner->work(RunnableInterface::Trigger);
        }
    }
    void end() { word.post(2); }

    RunnableInterface* runner;
    std::atomic<unsigned> executor{~0u};
    std::atomic<bool> active{true};
    os::detail::WakeWord word;
};

}  // namespace base
}  // namespace RTT
#endif
