// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/extras/FileDescriptorSimulationActivity.hpp>

#include <climits>

namespace RTT::extras {

// Without a thread of its own, it needs no scheduler, priority, CPUs or name.
FileDescriptorSimulationActivity::FileDescriptorSimulationActivity(int, base::RunnableInterface* r, const std::string&)
    : SimulationActivity(0.0, r) {}
FileDescriptorSimulationActivity::FileDescriptorSimulationActivity(int, int, base::RunnableInterface* r,
                                                                   const std::string&)
    : SimulationActivity(0.0, r) {}
FileDescriptorSimulationActivity::FileDescriptorSimulationActivity(int, int, Seconds period, base::RunnableInterface* r,
                                                                   const std::string&)
    : SimulationActivity(period, r) {}
FileDescriptorSimulationActivity::FileDescriptorSimulationActivity(int, int, Seconds period, unsigned,
                                                                   base::RunnableInterface* r, const std::string&)
    : SimulationActivity(period, r) {}

FileDescriptorSimulationActivity::~FileDescriptorSimulationActivity() {
    closeGate();
    stop();
}

bool FileDescriptorSimulationActivity::isWatched(int) const { return false; }
bool FileDescriptorSimulationActivity::isUpdated(int) const { return lastReason_ == base::RunnableInterface::IOReady; }
bool FileDescriptorSimulationActivity::hasTimeout() const { return lastReason_ == base::RunnableInterface::TimeOut; }
bool FileDescriptorSimulationActivity::hasError() const { return false; }

void FileDescriptorSimulationActivity::setTimeout(int milliseconds) {
    if (milliseconds >= 0) timeoutUs_ = milliseconds > INT_MAX / 1000 ? INT_MAX : milliseconds * 1000;
}

void FileDescriptorSimulationActivity::setTimeout_us(int microseconds) {
    if (microseconds >= 0) timeoutUs_ = microseconds;
}

int FileDescriptorSimulationActivity::getTimeout() const { return timeoutUs_ / 1000; }
int FileDescriptorSimulationActivity::getTimeout_us() const { return timeoutUs_; }

void FileDescriptorSimulationActivity::work(base::RunnableInterface::WorkReason reason) {
    lastReason_ = reason;
    SimulationActivity::work(reason);
}

}  // namespace RTT::extras
