// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What configure() and cleanup() of a LoggingService do with categories and appenders.
#include "event_pool.hpp"
#include "logging_state.hpp"
#include "priorities.hpp"

#include <ocl/Appender.hpp>
#include <rtt/Logger.hpp>
#include <rtt/Property.hpp>
#include <rtt/internal/flow/buffer_parts.hpp>
#include <rtt/os/oro_malloc.h>
#include <rtt/os/tlsf/tlsf.h>

#include <boost/core/demangle.hpp>

#include <exception>
#include <typeinfo>

namespace OCL::logging {
namespace {

using RTT::endlog;
using RTT::log;

constexpr int kMostEvents = 1000000;
constexpr int kMostCharacters = 1000000;
constexpr int kWriters = RTT::internal::kThreadsOfParts;  // inside log() of one category at once

/** The value of an entry of a bag. Logs an error and returns null if it has another type. */
template <class T>
const T* valueOf(const RTT::base::PropertyBase* entry, const char* bag, const char* type, T& value) {
    const auto* const typed = dynamic_cast<const RTT::Property<T>*>(entry);
    if (!typed) {
        log(RTT::Error) << bag << ": the entry '" << entry->getName() << "' is a " << entry->getType()
                        << ", expected a " << type << endlog();
        return nullptr;
    }
    value = typed->get();
    return &value;
}

/** The category, made if need be. Null, with an error logged, if it is none of ours. */
Category* categoryOf(const std::string& name) {
    log4cpp::Category& found = log4cpp::Category::getInstance(name);
    if (auto* const own = dynamic_cast<Category*>(&found)) return own;
    log(RTT::Error) << "Category '" << name << "' is not an OCL category: type is '"
                    << boost::core::demangle(typeid(found).name())
                    << "'; it was made before the factory: let the program call "
                       "OCL::logging::Category::installFactory() before anything uses log4cpp"
                    << endlog();
    return nullptr;
}

}  // namespace

std::string described(const std::string& category) {
    return category.empty() ? std::string("the root category") : "category '" + category + "'";
}

bool LoggingService::Impl::checkSizes() const {
    if (bufferSize > 0 && bufferSize <= kMostEvents && messageSize >= 0 && messageSize <= kMostCharacters) return true;
    log(RTT::Error) << "'" << self.getName() << "': BufferSize is " << bufferSize << " and MessageSize is "
                    << messageSize << "; expected 1 to " << kMostEvents << " events and 0 to " << kMostCharacters
                    << " characters" << endlog();
    return false;
}

bool LoggingService::Impl::setLevels() const {
    bool good = true;
    for (const RTT::base::PropertyBase* entry : levels.getProperties()) {
        std::string level;
        if (!valueOf(entry, "Levels", "string", level)) {
            good = false;
            continue;
        }
        const std::string category = entry->getName();
        const auto priority = priorityOf(level);
        if (!priority) {
            log(RTT::Error) << "Bad level name: " << level << " (of " << described(category)
                            << "; expected EMERG, FATAL, ALERT, CRIT, ERROR, WARN, NOTICE, INFO, DEBUG or NOTSET)"
                            << endlog();
            good = false;
            continue;
        }
        try {
            log4cpp::Category::getInstance(category).setPriority(*priority);
        } catch (const std::exception& thrown) {
            log(RTT::Error) << described(category) << " does not take the level " << level << ": " << thrown.what()
                            << endlog();
            good = false;
        }
    }
    return good;
}

bool LoggingService::Impl::setAdditivity() const {
    bool good = true;
    for (const RTT::base::PropertyBase* entry : additivity.getProperties()) {
        bool value = true;
        if (valueOf(entry, "Additivity", "boolean", value))
            log4cpp::Category::getInstance(entry->getName()).setAdditivity(value);
        else
            good = false;
    }
    return good;
}

bool LoggingService::Impl::connectAppenders() {
    bool good = true;
    for (const RTT::base::PropertyBase* entry : appenders.getProperties()) {
        std::string appender;
        good = valueOf(entry, "Appenders", "string", appender) && connect(entry->getName(), appender) && good;
    }
    return good;
}

bool LoggingService::Impl::connectRuntimeLog() {
    runtimeLog.reset();
    if (runtimeCategory.empty()) return true;
    Category* const category = categoryOf(runtimeCategory);
    if (category) runtimeLog.reset(new RuntimeLog(*category));
    return category != nullptr;
}

bool LoggingService::Impl::hasMemory(const std::string& category) const {
    oro_rt_free(oro_rt_malloc(1));  // the first call makes the pool
    constexpr std::size_t kBlock = 32;
    const std::size_t event = static_cast<std::size_t>(messageSize) + category.size() + 2 * kBlock;
    const std::size_t needed = event * RTT::internal::bufferElements(static_cast<std::size_t>(bufferSize), kWriters);
    const std::size_t free = get_pool_size_mp() - get_used_size_mp();
    if (needed <= free) return true;
    log(RTT::Error) << "no real-time memory for the events of " << described(category) << ": " << bufferSize
                    << " events of " << messageSize << " characters need " << needed / 1024 + 1 << " KiB, and "
                    << free / 1024
                    << " KiB are left; the deployers take --rtalloc-mem-size, and the properties BufferSize "
                    << "and MessageSize can be smaller" << endlog();
    return false;
}

bool LoggingService::Impl::connect(const std::string& name, const std::string& appender) {
    Category* const category = categoryOf(name);
    RTT::TaskContext* const peer = self.getPeer(appender);
    if (!peer)
        log(RTT::Error) << "Could not find appender '" << appender << "'; it must be a peer of '" << self.getName()
                        << "'" << endlog();
    if (!category || !peer) return false;
    RTT::base::PortInterface* const port = peer->getPort("LogPort");
    RTT::base::InputPortInterface* const input = port ? port->asInput() : nullptr;
    if (!input) {
        log(RTT::Error) << "Failed to find log port in appender '" << appender << "'" << endlog();
        return false;
    }
    if (category->log_port.connectedTo(input)) {
        log(RTT::Warning) << described(name) << " is connected to appender '" << appender << "' already" << endlog();
        return true;
    }
    if (!hasMemory(name)) return false;
    (void)EventPool::instance();  // made here, before a real-time thread needs it
    try {
        if (!category->log_port.connected()) {
            LoggingEvent sample;
            sample.categoryName = category->rtName_;
            sample.message.assign(static_cast<std::size_t>(messageSize), ' ');
            category->log_port.setDataSample(sample);
        }
        RTT::ConnPolicy policy = RTT::ConnPolicy::buffer(bufferSize, RTT::ConnPolicy::LOCK_FREE, false);
        policy.max_threads = kWriters;
        policy.mandatory = false;
        if (category->log_port.connectTo(input, policy)) {
            connections.push_back({name, appender});
            return true;
        }
    } catch (const std::bad_alloc&) {
        log(RTT::Error) << "memory is used up" << endlog();
    }
    log(RTT::Error) << "Failed to connect port to appender '" << appender << "'" << endlog();
    return false;
}

void LoggingService::Impl::disconnect() {
    for (const Connection& connection : connections) {
        RTT::TaskContext* const peer = self.getPeer(connection.appender);
        RTT::base::PortInterface* const port = peer ? peer->getPort("LogPort") : nullptr;
        auto* const category = dynamic_cast<Category*>(log4cpp::Category::exists(connection.category));
        if (port && category) category->log_port.disconnect(port);
    }
    connections.clear();
}

}  // namespace OCL::logging
