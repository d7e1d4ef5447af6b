// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a category does with a message. category_factory.cpp makes categories.
#include <ocl/Category.hpp>

#include "event_pool.hpp"

#include <rtt/Logger.hpp>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>

namespace OCL::logging {
namespace {

std::atomic<unsigned long> lost{0};

std::string portName(std::string category) {
    for (char& c : category)
        if (c == '.') c = '_';
    return category;
}

}  // namespace

Category::Port::Port(const std::string& of)
    : RTT::OutputPort<LoggingEvent>(portName(of), /*keep_last_written_value=*/false), category(of) {}

Category::Category(const std::string& name, log4cpp::Category* parent, log4cpp::Priority::Value priority)
    : log4cpp::Category(name, parent, priority),
      log_port(name),
      parent_(dynamic_cast<Category*>(parent)),
      rtName_(name.data(), name.size()) {}

Category::~Category() = default;

log4cpp::Category* Category::createOCLCategory(const std::string& name, log4cpp::Category* parent,
                                               log4cpp::Priority::Value priority) {
    return new Category(name, parent, priority);
}

bool Category::isHeard() const noexcept {
    for (const Category* category = this; category; category = category->parent_) {
        if (category->log_port.connected()) return true;
        if (!category->getAdditivity()) break;
    }
    return false;
}

void Category::log(log4cpp::Priority::Value priority, const char* text, std::size_t size) noexcept {
    if (!isPriorityEnabled(priority) || !isHeard()) return;
    const EventPool::Claim event(EventPool::instance());
    if (!event) {
        lost.fetch_add(1, std::memory_order_relaxed);
        return;
    }
    event->setCategory(rtName_);
    event->priority = priority;
    event->setOrigin();
    event->setMessage(text, size);
    callAppenders(*event);
}

void Category::log(log4cpp::Priority::Value priority, const RTT::rt_string& message) noexcept {
    log(priority, message.data(), message.size());
}

void Category::log(log4cpp::Priority::Value priority, const char* message) noexcept {
    if (message) log(priority, message, std::strlen(message));
}

void Category::log(log4cpp::Priority::Value priority, const std::string& message) noexcept {
    log4cpp::Category::log(priority, message);
}

CategoryStream Category::getRTStream(log4cpp::Priority::Value priority) noexcept {
    return CategoryStream(this, isPriorityEnabled(priority)
                                    ? priority
                                    : static_cast<log4cpp::Priority::Value>(log4cpp::Priority::NOTSET));
}

unsigned long Category::lostMessages() noexcept { return lost.load(std::memory_order_relaxed); }

void Category::callAppenders(const LoggingEvent& event) noexcept {
    for (Category* category = this; category; category = category->parent_) {
        (void)category->log_port.write(event);
        if (!category->getAdditivity()) break;
    }
}

void Category::_logUnconditionally(log4cpp::Priority::Value priority, const char* format, va_list arguments) noexcept {
    va_list again;
    va_copy(again, arguments);
    try {
        char text[512];
        const int size = std::vsnprintf(text, sizeof text, format, arguments);
        std::string message(text,
                            size < 0 ? 0 : std::min<std::size_t>(static_cast<std::size_t>(size), sizeof text - 1));
        if (size >= static_cast<int>(sizeof text)) {
            message.resize(static_cast<std::size_t>(size) + 1);
            (void)std::vsnprintf(&message[0], message.size(), format, again);
            message.resize(static_cast<std::size_t>(size));
        }
        _logUnconditionally2(priority, message);
    } catch (const std::exception&) {
        lost.fetch_add(1, std::memory_order_relaxed);
    }
    va_end(again);
}

void Category::_logUnconditionally2(log4cpp::Priority::Value priority, const std::string& message) noexcept {
    log4cpp::Category::_logUnconditionally2(priority, message);
    log(priority, message.data(), message.size());
}

}  // namespace OCL::logging
