// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_APPENDER_HPP
#define ORO_OCL_APPENDER_HPP

#include <log4cpp/Appender.hh>
#include <ocl/LoggingEvent.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/Property.hpp>
#include <rtt/TaskContext.hpp>

#include <memory>
#include <string>

namespace OCL {
namespace logging {

class LineAppender;

/**
 * A component that takes events from its port LogPort and gives them to an appender of log4cpp. A LoggingService
 * connects categories to the port. Events that come before start() wait in the connection's buffer; stop() takes all
 * that are there.
 *
 * The component writes in its own thread, which should not be a real-time one: writing waits for files and terminals.
 *
 * Derive from it to write elsewhere: configureHook() sets `appender` and calls configureLayout(), updateHook() calls
 * processEvents().
 */
class OCL_API Appender : public RTT::TaskContext {
public:
    explicit Appender(std::string name);
    ~Appender() override;

    /** Events that were dropped because the buffers of all connections so far were full. Any thread; takes a lock. */
    unsigned int droppedEvents();
    /** The same for those of one category. */
    unsigned int droppedOf(const std::string& category);
    /** Events that could not be written. Any thread. */
    unsigned int lostEvents();

protected:
    /** Gives `appender` the layout that LayoutName and LayoutPattern describe. False, and an error, for others. */
    virtual bool configureLayout();
    bool startHook() override;
    void stopHook() override;
    void cleanupHook() override;

    /** Takes at most `n` events, all if it is 0. If more are left, an activity that is not periodic runs again. */
    virtual void processEvents(int n);
    /** Takes all events that are there. */
    void drainBuffer();
    /** False, and an error, if it is negative. */
    bool isMaxEvents(int n) const;

    RTT::InputPort<LoggingEvent> log_port;
    RTT::Property<std::string> layoutName_prop;
    RTT::Property<std::string> layoutPattern_prop;
    /** Where events go. A derived class that sets it deletes it; those of this library use hold(). */
    log4cpp::Appender* appender = nullptr;
    unsigned int countMaxPopped = 0;  ///< the most events that one cycle took

    /** Makes it the appender, which this class then owns. */
    void hold(std::unique_ptr<LineAppender> lines);
    LineAppender* held() const;

private:
    friend class LoggingService;
    struct Impl;
    const std::unique_ptr<Impl> impl_;
};

}  // namespace logging
}  // namespace OCL

#endif
