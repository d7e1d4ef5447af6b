// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component that logs to a category, as its user writes it.
#include <ocl/Category.hpp>
#include <rtt/Component.hpp>
#include <rtt/TaskContext.hpp>

#include <log4cpp/Category.hh>

#include <atomic>
#include <string>
#include <unistd.h>

namespace loggertest {

class Worker : public RTT::TaskContext {
public:
    explicit Worker(const std::string& name)
        : RTT::TaskContext(name, PreOperational),
          plain_(log4cpp::Category::getInstance("demo.worker")),
          category_(dynamic_cast<OCL::logging::Category*>(&plain_)) {
        addProperty("events", events_).doc("How many events the component logs; all the time if it is negative.");
        addOperation("logged", &Worker::logged, this).doc("How many events has it logged?");
        setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0, 0, name));
    }

protected:
    bool configureHook() override { return category_ != nullptr; }
    bool startHook() override {
        plain_.error(std::string("by log4cpp"));
        return true;
    }
    void updateHook() override {
        logged_ = next_;
        if (next_ == events_) return;
        category_->getRTStream(log4cpp::Priority::DEBUG) << "event " << next_++;
        if (next_ % 200 == 0) usleep(1000);
        (void)trigger();
    }

private:
    int logged() { return logged_; }

    std::atomic<int> logged_{0};
    log4cpp::Category& plain_;
    OCL::logging::Category* const category_;
    int events_ = 0, next_ = 0;
};

}  // namespace loggertest

ORO_CREATE_COMPONENT(loggertest::Worker)
