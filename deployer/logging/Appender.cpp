// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/Appender.hpp>

#include "dropped_events.hpp"
#include "layouts.hpp"
#include "line_appender.hpp"

#include <ocl/Category.hpp>
#include <rtt/Logger.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <utility>

namespace OCL::logging {
namespace {

constexpr int kMostPerCycle = 10000;  // so that a category that never pauses cannot prevent a stop
constexpr std::chrono::seconds kMostTimeToDrain{5};
constexpr std::size_t kCategoryRoom = 64, kMessageRoom = 1024;  // for which no memory is needed later

}  // namespace

struct Appender::Impl {
    Impl(const std::string& name, const RTT::base::InputPortInterface& port) : dropped(name, port) {}

    /** Gives an event to the appender of log4cpp. */
    void append(Appender& self, const log4cpp::LoggingEvent& given) {
        try {
            self.appender->doAppend(given);
        } catch (const std::exception& thrown) {
            lostByException.fetch_add(1);
            if (std::exchange(throws, true)) return;
            RTT::log(RTT::Error) << "appender '" << self.getName() << "' cannot write an event: " << thrown.what()
                                 << "; such events are counted and lost" << RTT::endlog();
        }
    }
    void append(Appender& self) {
        log4cpp::LoggingEvent given = event.toLog4cpp();
        if (takesControls ||
            (isPrintable(given.message) && isPrintable(given.threadName) && isPrintable(given.categoryName)))
            return append(self, given);
        LoggingEvent clean;
        const auto set = [](RTT::rt_string& to, const std::string& text) {
            const std::string shown = printable(text);
            to.assign(shown.data(), shown.size());
        };
        try {
            set(clean.categoryName, given.categoryName);
            set(clean.message, given.message);
            set(clean.threadName, given.threadName);
            clean.priority = event.priority;
            clean.timeStamp = event.timeStamp;
            append(self, clean.toLog4cpp());
        } catch (const std::bad_alloc&) {
            append(self, given);
        }
    }
    /** Tells the most events of a cycle. */
    void appendMost(Appender& self) {
        LoggingEvent most;
        try {
            most.categoryName = "OCL.logging.Appender";
        } catch (const std::bad_alloc&) {
            // The line does without.
        }
        const std::string text = "# countMaxPopped=" + std::to_string(self.countMaxPopped);
        most.setMessage(text.data(), text.size());
        most.priority = log4cpp::Priority::DEBUG;
        most.setOrigin();
        append(self, most.toLog4cpp());
    }
    /** `empty`: no more events may come for long, so what was dropped is looked up now. */
    void endCycle(bool final, bool empty = true) {
        if (lines) lines->flush();
        dropped.look(final || empty);
        dropped.report(final);
        if (lines) lost = formerLost + lines->lostEvents();
    }
    unsigned long lostEvents() const { return lost + lostByException; }

    DroppedEvents dropped;
    LoggingEvent event;
    std::unique_ptr<LineAppender> lines;
    bool takesControls = false;  // the layout writes control characters so that they do no harm
    bool throws = false;
    unsigned long formerLost = 0;
    std::atomic<unsigned long> lost{0}, lostByException{0};
};

Appender::Appender(std::string name)
    : RTT::TaskContext(name, PreOperational),
      log_port("LogPort", RTT::ConnPolicy::buffer(100)),
      layoutName_prop("LayoutName", "The form of a line: basic, simple, pattern or json; basic if it is empty."),
      layoutPattern_prop("LayoutPattern", "For the layout pattern: a conversion pattern of log4cpp."),
      impl_(new Impl(name, log_port)) {
    try {
        impl_->event.reserve(kCategoryRoom, kMessageRoom);
    } catch (const std::bad_alloc&) {
        // Messages are then cut, counted and reported.
    }
    (void)addLoggingTypes();
    addEventPort(log_port).doc("Events of the categories.");
    addProperty(layoutName_prop);
    addProperty(layoutPattern_prop);
    addOperation("droppedEvents", &Appender::droppedEvents, this)
        .doc("How many events were dropped because buffers were full?");
    addOperation("droppedOf", &Appender::droppedOf, this)
        .doc("How many events of a category were dropped because its buffer was full?")
        .arg("category", "Name of the category");
    addOperation("lostEvents", &Appender::lostEvents, this)
        .doc("How many events could not be written, as on a full disk?");
}

Appender::~Appender() { stopForGood(); }

unsigned int Appender::droppedEvents() { return static_cast<unsigned int>(impl_->dropped.all()); }
unsigned int Appender::droppedOf(const std::string& category) {
    return static_cast<unsigned int>(impl_->dropped.of(category));
}
unsigned int Appender::lostEvents() { return static_cast<unsigned int>(impl_->lostEvents()); }

void Appender::hold(std::unique_ptr<LineAppender> lines) {
    if (impl_->lines) impl_->formerLost += impl_->lines->lostEvents();
    appender = lines.get();
    impl_->lines = std::move(lines);
}

LineAppender* Appender::held() const { return impl_->lines.get(); }

bool Appender::configureLayout() {
    if (!appender) return false;
    const std::string name = layoutName_prop.get();
    std::string reason;
    std::unique_ptr<log4cpp::Layout> layout = makeLayout(name, layoutPattern_prop.get(), reason);
    if (!layout) {
        RTT::log(RTT::Error) << "Invalid layout '" << name << "' in configuration for category: " << getName() << " ("
                             << reason << ")" << RTT::endlog();
        return false;
    }
    impl_->takesControls = name == "json";
    appender->setLayout(layout.release());
    return true;
}

bool Appender::isMaxEvents(int n) const {
    if (n >= 0) return true;
    RTT::log(RTT::Error) << "Invalid maxEventsPerCycle value of " << n << ". Value must be >= 0." << RTT::endlog();
    return false;
}

bool Appender::startHook() {
    if (!appender) {
        RTT::log(RTT::Error) << "appender '" << getName() << "' has nothing to write to" << RTT::endlog();
        return false;
    }
    impl_->throws = false;
    return true;
}

void Appender::processEvents(int n) {
    if (!appender) return;
    const int most = n == 0 ? kMostPerCycle : n;
    int popped = 0;
    while (popped < most && log_port.read(impl_->event, false) == RTT::NewData) {
        ++popped;
        impl_->append(*this);
    }
    countMaxPopped = std::max(countMaxPopped, static_cast<unsigned int>(popped));
    impl_->endCycle(false, popped < most);
    if (popped == most) (void)trigger();  // there may be more
}

void Appender::drainBuffer() {
    if (!appender) return;
    const auto end = std::chrono::steady_clock::now() + kMostTimeToDrain;
    // The time first: what was read must be written.
    while (std::chrono::steady_clock::now() < end && log_port.read(impl_->event, false) == RTT::NewData)
        impl_->append(*this);
}

void Appender::stopHook() {
    drainBuffer();
    if (appender) impl_->appendMost(*this);
    impl_->endCycle(true);
    if (impl_->lines) impl_->lines->reportLost();
}

void Appender::cleanupHook() {
    if (impl_->lines) hold(nullptr);
}

}  // namespace OCL::logging
