// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/LoggingEvent.hpp>

#include "origin.hpp"

#include <rtt/os/oro_malloc.h>
#include <rtt/types/GeneratedTypekit.hpp>
#include <rtt/types/Types.hpp>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <memory>
#include <new>
#include <string_view>

namespace OCL::logging {
namespace {

std::atomic<unsigned long> cut{0};

/** Whether the pool has a block of that size now. Asked before a text grows: an exception would allocate. */
bool hasRealTimeMemory(std::size_t size) noexcept {
    void* const block = oro_rt_malloc(size);
    oro_rt_free(block);
    return block != nullptr;
}

constexpr char kNote[] = "... (%zu characters; real-time memory is used up)";
constexpr std::string_view kNoteBegin("... (");
constexpr std::string_view kNoteEnd("; real-time memory is used up)");

/** The note at the end of a text that was cut before; empty if it was not. */
std::string_view noteOf(std::string_view text) noexcept {
    const bool hasNote = text.size() >= kNoteEnd.size() && text.substr(text.size() - kNoteEnd.size()) == kNoteEnd;
    const std::size_t begin = hasNote ? text.rfind(kNoteBegin) : text.npos;
    return begin == text.npos ? std::string_view() : text.substr(begin);
}

void assignCut(RTT::rt_string& to, const char* text, std::size_t size) noexcept {
    std::string_view note = noteOf({text, size});
    char own[80];
    if (note.empty()) {
        cut.fetch_add(1, std::memory_order_relaxed);
        note = {own, static_cast<std::size_t>(std::snprintf(own, sizeof own, kNote, size))};
    }
    const std::size_t room = to.capacity();
    if (room < 2 * note.size()) {
        to.assign(text, std::min(size, room));
        return;
    }
    to.assign(text, room - note.size());
    to.append(note.data(), note.size());
}

void assign(RTT::rt_string& to, const char* text, std::size_t size) noexcept {
    if (size == to.size()) {  // mostly so for the names of category and thread
        std::memcpy(&to[0], text, size);
        return;
    }
    // A string grows to at least twice its capacity.
    if (size > to.capacity() && !hasRealTimeMemory(std::max(size, 2 * to.capacity()) + 1))
        return assignCut(to, text, size);
    try {
        to.assign(text, size);
    } catch (const std::exception&) {
        assignCut(to, text, size);
    }
}

void assign(RTT::rt_string& to, const RTT::rt_string& from) noexcept { assign(to, from.data(), from.size()); }

std::string plain(const RTT::rt_string& text) { return std::string(text.data(), text.size()); }

double secondsOf(const log4cpp::TimeStamp& time) { return time.getSeconds() + time.getMicroSeconds() * 1e-6; }

namespace t = RTT::types;

constexpr t::SequenceOps kTimeAccess = t::memberAccess(
    [](const void* event, std::size_t, void* seconds) {
        *static_cast<double*>(seconds) = secondsOf(static_cast<const LoggingEvent*>(event)->timeStamp);
    },
    nullptr);

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Winvalid-offsetof"
constexpr t::Member kMembers[] = {
    {"categoryName", offsetof(LoggingEvent, categoryName), &t::typeRef<RTT::rt_string>, 0, "Name of the category", ""},
    {"message", offsetof(LoggingEvent, message), &t::typeRef<RTT::rt_string>, 0, "What is logged", ""},
    {"ndc", offsetof(LoggingEvent, ndc), &t::typeRef<RTT::rt_string>, 0, "Nested diagnostic context", ""},
    {"priority", offsetof(LoggingEvent, priority), &t::typeRef<int>, 0, "From 0, EMERG, to 800, NOTSET", ""},
    {"threadName", offsetof(LoggingEvent, threadName), &t::typeRef<RTT::rt_string>, 0, "Name of the thread", ""},
    {"timeStamp", 0, &t::typeRef<double>, 0, "Since 1970", "s", nullptr, &kTimeAccess},
};
#pragma GCC diagnostic pop

}  // namespace

LoggingEvent::LoggingEvent(const RTT::rt_string& category, const RTT::rt_string& text, const RTT::rt_string& context,
                           log4cpp::Priority::Value level)
    : categoryName(category), message(text), ndc(context), priority(level) {
    setOrigin();
}

LoggingEvent& LoggingEvent::operator=(const LoggingEvent& other) noexcept {
    if (this == &other) return *this;
    assign(categoryName, other.categoryName);
    assign(message, other.message);
    assign(ndc, other.ndc);
    priority = other.priority;
    assign(threadName, other.threadName);
    timeStamp = other.timeStamp;
    return *this;
}

void LoggingEvent::reserve(std::size_t category, std::size_t text) {
    categoryName.reserve(category);
    message.reserve(text);
}

void LoggingEvent::setCategory(const RTT::rt_string& name) noexcept { assign(categoryName, name); }
void LoggingEvent::setMessage(const char* text, std::size_t size) noexcept { assign(message, text, size); }

void LoggingEvent::setOrigin() noexcept {
    const char* const name = origin().name;
    threadName.assign(name, ::strnlen(name, sizeof Origin::name - 1));  // fits into the string itself
    timespec now{};
    ::clock_gettime(CLOCK_REALTIME, &now);
    timeStamp = log4cpp::TimeStamp(static_cast<unsigned>(now.tv_sec), static_cast<unsigned>(now.tv_nsec / 1000));
}

log4cpp::LoggingEvent LoggingEvent::toLog4cpp() const {
    log4cpp::LoggingEvent event(plain(categoryName), plain(message), plain(ndc), priority);
    event.timeStamp = timeStamp;
    // The constructor of log4cpp names the present thread, and the member is const: another object takes its place.
    std::string* const thread = const_cast<std::string*>(&event.threadName);
    std::string name = plain(threadName);
    std::destroy_at(thread);
    new (thread) std::string(std::move(name));
    return event;
}

unsigned long LoggingEvent::cutTexts() noexcept { return cut.load(std::memory_order_relaxed); }

bool addLoggingTypes() {
    const char* const name = "LoggingEvent";
    if (t::Types()->type(name)) return true;
    return t::addType(t::makeStructType<LoggingEvent>(name, kMembers, std::size(kMembers), "a message to a category"));
}

}  // namespace OCL::logging
