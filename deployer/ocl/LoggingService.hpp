// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_LOGGING_SERVICE_HPP
#define ORO_OCL_LOGGING_SERVICE_HPP

#include <ocl/OCL.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/TaskContext.hpp>

#include <memory>
#include <string>

namespace OCL {
namespace logging {

/**
 * Sets priorities of categories and connects them to appenders, which are its peers. configure() reads:
 *
 *   Levels       strings named as categories: EMERG, FATAL, ALERT, CRIT, ERROR, WARN, NOTICE, INFO, DEBUG or NOTSET
 *   Additivity   booleans named as categories: do their events also go to the appenders of their parents?
 *   Appenders    strings named as categories, as often as needed: the name of an appender
 *   RuntimeCategory   a category that gets the lines of the runtime's log (RTT::Logger), too; empty: none
 *
 * The category "" is the root of all. Categories that do not exist are made. Categories stay connected when the service
 * is stopped or destroyed; cleanup() and a second configure() disconnect them. The runtime's log goes to its category
 * until cleanup() or the end of the service. All operations may be called from any
 * thread, take locks and allocate.
 */
class OCL_API LoggingService : public RTT::TaskContext {
public:
    explicit LoggingService(std::string name);
    ~LoggingService() override;

    /** Writes all categories, their priorities and where their events go to the log, at level Info. */
    void logCategories();
    /** False if there is no such category or priority. */
    bool setCategoryPriority(const std::string& category, int priority);
    /** "UNKNOWN CATEGORY" if there is none, "UNKNOWN PRIORITY" if its priority has no name. */
    std::string getCategoryPriorityName(const std::string& category);
    /** Events that the connected appenders had no room for, and messages for which there was no memory. */
    unsigned int droppedEvents();

protected:
    bool configureHook() override;
    void cleanupHook() override;

private:
    struct Impl;
    const std::unique_ptr<Impl> impl_;
};

}  // namespace logging
}  // namespace OCL

#endif
