// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Components that do, ten times each, one thing that a real-time component must not do; and one that does nothing of it.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>
#include <rtt/os/oro_malloc.h>

#include <atomic>
#include <condition_variable>
#include <cstdlib>
#include <fcntl.h>
#include <iostream>
#include <mutex>
#include <poll.h>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

namespace plantedfaults {

constexpr int kCycles = 10;
std::atomic<int> started{0}, finished{0};

/** Does something in each of ten updates. */
class Working : public RTT::TaskContext {
public:
    explicit Working(const std::string& name) : RTT::TaskContext(name) {}

protected:
    virtual bool prepare() { return true; }
    virtual void work() = 0;
    int cycle() const { return cycle_; }

private:
    bool startHook() override { return prepare() && ++started; }
    void updateHook() override {
        if (cycle_ == kCycles) return;
        work();
        if (++cycle_ == kCycles) ++finished;
    }
    int cycle_ = 0;
};

/** Blocks that the compiler cannot do without. */
void* volatile kept;

class Allocator : public Working {
    using Working::Working;
    void work() override { kept = new int(cycle()); }
};

class Releaser : public Working {
public:
    explicit Releaser(const std::string& name) : Working(name) {
        for (void*& block : blocks_) block = std::malloc(100);
    }

private:
    void work() override { std::free(blocks_[cycle()]); }
    void* blocks_[kCycles];
};

class Locker : public Working {
    using Working::Working;
    void work() override { const std::lock_guard<std::mutex> lock(mutex_); }
    std::mutex mutex_;
};

/** Does the same in two places. */
class TwoPlaces : public Working {
    using Working::Working;
    [[gnu::noinline]] void one() { mutex_.lock(), mutex_.unlock(); }
    [[gnu::noinline]] void other() { mutex_.lock(), mutex_.unlock(); }
    void work() override { one(), other(); }
    std::mutex mutex_;
};

/** Has its mutex locked by others, so that only the wait is its own. */
class ConditionWaiter : public Working {
    using Working::Working;
    void work() override {
        std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
        condition_.wait_for(lock, std::chrono::microseconds(100));
    }
    std::mutex mutex_;
    std::condition_variable condition_;
};

class Sleeper : public Working {
    using Working::Working;
    void work() override { usleep(100); }
};

class Writer : public Working {
    using Working::Working;
    void work() override {
        if (write(file_, "x", 1) != 1) error();
    }
    const int file_ = open("/dev/null", O_WRONLY | O_CLOEXEC);
};

class Opener : public Working {
    using Working::Working;
    void work() override {
        const int file = open("/dev/null", O_WRONLY | O_CLOEXEC);
        close(file);
    }
};

class Printer : public Working {
    using Working::Working;
    void work() override { std::cout << "printed\n"; }
};

/** Calls an operation that the thread of another component executes. */
class Caller : public Working {
    using Working::Working;
    bool prepare() override {
        answer_ = getPeer("teller")->getOperation("answer");
        answer_.setCaller(engine());
        return answer_.ready();
    }
    void work() override { answer_(); }
    RTT::OperationCaller<int()> answer_{"answer"};
};

/** Executes a slave, which may be started later, as long as it runs. */
class Master : public RTT::TaskContext {
    using RTT::TaskContext::TaskContext;
    bool startHook() override { return (slave_ = getPeer("locker")) != nullptr; }
    void updateHook() override { slave_->update(); }
    RTT::TaskContext* slave_ = nullptr;
};

/** Takes a lock in whatever its thread executes, but for updateHook(). */
class EachPlace : public RTT::TaskContext {
public:
    explicit EachPlace(const std::string& name) : RTT::TaskContext(name) {
        addEventPort("in", in_, [this](RTT::base::PortInterface*) { inCallback(); });
        addOperation("inOperation", &EachPlace::inOperation, this, RTT::OwnThread);
        addOperation("inScript", &EachPlace::inScript, this, RTT::ClientThread);
    }

private:
    void lock() { mutex_.lock(), mutex_.unlock(); }
    [[gnu::noinline]] void inCallback() { lock(), ++done_; }
    [[gnu::noinline]] void inOperation() { lock(), ++done_; }
    [[gnu::noinline]] bool inScript() { return lock(), true; }
    bool startHook() override { return ++started; }
    void updateHook() override {
        if (done_ > 2 * kCycles && ++updates_ == 1) error();
    }
    void errorHook() override {
        lock();
        if (!std::exchange(told_, true)) ++finished;
    }
    RTT::InputPort<int> in_;
    std::mutex mutex_;
    int done_ = 0, updates_ = 0;
    bool told_ = false;
};

/** Has the others of its peers do something. */
class Mover : public RTT::TaskContext {
public:
    explicit Mover(const std::string& name) : RTT::TaskContext(name) { addPort("out", out_); }

private:
    void updateHook() override {
        out_.write(1);
        for (const std::string& peer : getPeerList()) {
            RTT::OperationCaller<void()> operation(getPeer(peer)->getOperation("inOperation"), engine());
            operation();
        }
    }
    RTT::OutputPort<int> out_;
};

/** Throws, which allocates; what the runtime does about it is not its fault. */
class Thrower : public RTT::TaskContext {
    using RTT::TaskContext::TaskContext;
    bool startHook() override { return ++started, true; }
    void updateHook() override { throw 1; }
    void exceptionHook() override { ++finished; }
};

/** Ports, operations, real-time memory, the log, and what only looks as if it blocked. */
class Clean : public Working {
public:
    explicit Clean(const std::string& name) : Working(name), twice_("twice") {
        addPort("in", in_);
        addPort("out", out_);
        addOperation("twice", &Clean::twice, this, RTT::ClientThread);
        addAttribute("count", count_);
        out_.setDataSample(0);
        if (pipe2(pipe_, O_NONBLOCK | O_CLOEXEC) != 0) pipe_[0] = -1;
        twice_ = getOperation("twice");
        twice_.setCaller(engine());
    }

private:
    int twice(int number) { return 2 * number; }
    void work() override {
        int number = 0;
        in_.read(number);
        out_.write(twice_(number) + 1);
        void* const block = oro_rt_malloc(100);
        oro_rt_free(block);
        if (mutex_.try_lock()) mutex_.unlock();
        char byte = 0;
        pollfd polled = {pipe_[0], POLLIN, 0};
        if (poll(&polled, 1, 0) != 0 || read(pipe_[0], &byte, 1) != -1) error();
        if (cycle() == 0) RTT::log(RTT::Error) << "logged by " << getName() << RTT::endlog();
        trigger();
        ++count_;
    }

    RTT::InputPort<int> in_;
    RTT::OutputPort<int> out_;
    RTT::OperationCaller<int(int)> twice_;
    std::mutex mutex_;
    int pipe_[2] = {-1, -1};
    int count_ = 0;
};

/** Tells when all have done their work. It is no real-time component and may do what it does. */
class Teller : public RTT::TaskContext {
public:
    explicit Teller(const std::string& name) : RTT::TaskContext(name) {
        addOperation("answer", &Teller::answer, this, RTT::OwnThread);
    }

private:
    int answer() { return usleep(1000), 42; }
    // What programs get that a component starts.
    bool startHook() override { return system("echo preloaded: \"$LD_PRELOAD\"; env | grep -c RT_CHECK") != -1; }
    void updateHook() override {
        const std::lock_guard<std::mutex> lock(mutex_);
        texts_.push_back(std::string(100, 'x'));
        if (finished == started) std::cout << "all is done" << std::endl;
    }
    std::mutex mutex_;
    std::vector<std::string> texts_;
};

}  // namespace plantedfaults

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(plantedfaults::Allocator)
ORO_LIST_COMPONENT_TYPE(plantedfaults::Releaser)
ORO_LIST_COMPONENT_TYPE(plantedfaults::Locker)
ORO_LIST_COMPONENT_TYPE(plantedfaults::TwoPlaces)
ORO_LIST_COMPONENT_TYPE(plantedfaults::ConditionWaiter)
ORO_LIST_COMPONENT_TYPE(plantedfaults::Sleeper)
ORO_LIST_COMPONENT_TYPE(plantedfaults::Writer)
ORO_LIST_COMPONENT_TYPE(plantedfaults::Opener)
ORO_LIST_COMPONENT_TYPE(plantedfaults::Printer)
ORO_LIST_COMPONENT_TYPE(plantedfaults::Caller)
ORO_LIST_COMPONENT_TYPE(plantedfaults::Master)
ORO_LIST_COMPONENT_TYPE(plantedfaults::EachPlace)
ORO_LIST_COMPONENT_TYPE(plantedfaults::Mover)
ORO_LIST_COMPONENT_TYPE(plantedfaults::Thrower)
ORO_LIST_COMPONENT_TYPE(plantedfaults::Clean)
ORO_LIST_COMPONENT_TYPE(plantedfaults::Teller)
