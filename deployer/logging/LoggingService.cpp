// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The interface of the component; logging_setup.cpp sets up categories.
#include <ocl/LoggingService.hpp>

#include "logging_state.hpp"
#include "priorities.hpp"

#include <ocl/Appender.hpp>
#include <rtt/Logger.hpp>

#include <exception>
#include <memory>
#include <set>
#include <sstream>
#include <vector>

namespace OCL::logging {

LoggingService::LoggingService(std::string name) : RTT::TaskContext(name, Stopped), impl_(new Impl(*this)) {
    (void)Category::installFactory();
    (void)addLoggingTypes();
    addProperty("Levels", impl_->levels)
        .doc("Priorities: strings named as categories, such as DEBUG or ERROR. An empty name is the root of all.");
    addProperty("Additivity", impl_->additivity)
        .doc("Booleans named as categories: do their events also go to the appenders of the parents?");
    addProperty("Appenders", impl_->appenders)
        .doc("Strings named as categories: the names of appenders, which must be peers. A category may have several.");
    addProperty("BufferSize", impl_->bufferSize)
        .doc("How many events wait for an appender at most, for each category.");
    addProperty("MessageSize", impl_->messageSize)
        .doc("How many characters of a message each of these events has room for. Longer ones allocate.");
    addProperty("RuntimeCategory", impl_->runtimeCategory)
        .doc("A category that gets the lines of the runtime's log, too, such as org.orocos.rtt. Empty: none.");
    for (const NamedPriority& priority : kPriorities) addConstant(priority.name, static_cast<int>(priority.value));

    addOperation("logCategories", &LoggingService::logCategories, this)
        .doc("Writes all categories and where their events go to the log, at level Info.");
    addOperation("setCategoryPriority", &LoggingService::setCategoryPriority, this)
        .doc("Changes the priority of a category. False if there is no such category or priority.")
        .arg("name", "Name of the category")
        .arg("priority", "One of the attributes, such as DEBUG");
    addOperation("getCategoryPriorityName", &LoggingService::getCategoryPriorityName, this)
        .doc("The name of a category's own priority.")
        .arg("name", "Name of the category");
    addOperation("droppedEvents", &LoggingService::droppedEvents, this)
        .doc("How many events found no room in a buffer, and how many messages found no memory?");
}

LoggingService::~LoggingService() { stopForGood(); }

bool LoggingService::configureHook() {
    const std::lock_guard<std::mutex> lock(impl_->mutex);
    if (!impl_->connections.empty()) {
        RTT::log(RTT::Warning) << "'" << getName() << "' is configured again, and disconnects its "
                               << impl_->connections.size() << " connections to appenders" << RTT::endlog();
        impl_->disconnect();
    }
    bool good = impl_->checkSizes();
    good = impl_->setLevels() && good;
    good = impl_->setAdditivity() && good;
    good = good && impl_->connectAppenders() && impl_->connectRuntimeLog();
    if (!good) impl_->disconnect();
    return good;
}

void LoggingService::cleanupHook() {
    const std::lock_guard<std::mutex> lock(impl_->mutex);
    impl_->runtimeLog.reset();
    impl_->disconnect();
}

void LoggingService::logCategories() {
    const std::unique_ptr<std::vector<log4cpp::Category*>> all(log4cpp::Category::getCurrentCategories());
    const std::lock_guard<std::mutex> lock(impl_->mutex);
    for (log4cpp::Category* const category : *all) {
        const char* const own = nameOf(category->getPriority());
        const char* const chained = nameOf(category->getChainedPriority());
        std::ostringstream line;
        line << described(category->getName()) << ": level " << (own ? own : "UNKNOWN PRIORITY") << ", in effect "
             << (chained ? chained : "UNKNOWN PRIORITY") << ", additivity "
             << (category->getAdditivity() ? "on" : "off");
        if (!dynamic_cast<Category*>(category)) line << ", not an OCL category";
        for (const Impl::Connection& connection : impl_->connections) {
            if (connection.category != category->getName()) continue;
            line << ", appender '" << connection.appender << "'";
            if (auto* const appender = dynamic_cast<Appender*>(getPeer(connection.appender)))
                line << " (" << appender->droppedOf(connection.category) << " dropped)";
        }
        RTT::log(RTT::Info) << line.str() << RTT::endlog();
    }
}

bool LoggingService::setCategoryPriority(const std::string& name, int priority) {
    log4cpp::Category* const category = log4cpp::Category::exists(name);
    if (!category || !nameOf(priority)) {
        RTT::log(RTT::Error) << "cannot set the priority of " << described(name) << " to " << priority
                             << ": there is no such " << (category ? "priority" : "category") << RTT::endlog();
        return false;
    }
    try {
        category->setPriority(priority);
        return true;
    } catch (const std::exception& thrown) {
        RTT::log(RTT::Error) << described(name) << " does not take this priority: " << thrown.what() << RTT::endlog();
        return false;
    }
}

std::string LoggingService::getCategoryPriorityName(const std::string& name) {
    log4cpp::Category* const category = log4cpp::Category::exists(name);
    if (!category) return "UNKNOWN CATEGORY";
    const char* const priority = nameOf(category->getPriority());
    return priority ? priority : "UNKNOWN PRIORITY";
}

unsigned int LoggingService::droppedEvents() {
    const std::lock_guard<std::mutex> lock(impl_->mutex);
    std::set<std::string> names;
    for (const Impl::Connection& connection : impl_->connections) names.insert(connection.appender);
    unsigned long sum = Category::lostMessages() + LoggingEvent::cutTexts();
    for (const std::string& name : names)
        if (auto* const appender = dynamic_cast<Appender*>(getPeer(name))) sum += appender->droppedEvents();
    return static_cast<unsigned int>(sum);
}

}  // namespace OCL::logging
