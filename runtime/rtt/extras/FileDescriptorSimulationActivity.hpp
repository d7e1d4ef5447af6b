// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXTRAS_FILE_DESCRIPTOR_SIMULATION_ACTIVITY_HPP
#define ORO_EXTRAS_FILE_DESCRIPTOR_SIMULATION_ACTIVITY_HPP

#include <rtt/extras/FileDescriptorActivityInterface.hpp>
#include <rtt/extras/SimulationActivity.hpp>

#include <string>

namespace RTT {
namespace extras {

/**
 * Replaces a FileDescriptorActivity in a simulation: it has the same arguments, is executed by the SimulationThread,
 * and watches nothing. To the component, each step of the simulation looks like a timeout; with work(IOReady), all
 * descriptors look ready.
 */
class RTT_API FileDescriptorSimulationActivity : public SimulationActivity, public FileDescriptorActivityInterface {
public:
    explicit FileDescriptorSimulationActivity(int priority, base::RunnableInterface* r = nullptr,
                                              const std::string& name = "FileDescriptorSimulationActivity");
    FileDescriptorSimulationActivity(int scheduler, int priority, base::RunnableInterface* r = nullptr,
                                     const std::string& name = "FileDescriptorSimulationActivity");
    FileDescriptorSimulationActivity(int scheduler, int priority, Seconds period, base::RunnableInterface* r = nullptr,
                                     const std::string& name = "FileDescriptorSimulationActivity");
    FileDescriptorSimulationActivity(int scheduler, int priority, Seconds period, unsigned cpuAffinity,
                                     base::RunnableInterface* r = nullptr,
                                     const std::string& name = "FileDescriptorSimulationActivity");
    ~FileDescriptorSimulationActivity() override;

    void watch(int) override {}
    void unwatch(int) override {}
    void clearAllWatches() override {}
    /** Always false. */
    bool isWatched(int fd) const override;
    /** True for every descriptor if the last reason of work() was IOReady. */
    bool isUpdated(int fd) const override;
    /** True if the last reason of work() was TimeOut. */
    bool hasTimeout() const override;
    /** Always false. */
    bool hasError() const override;
    /** Has no effect except on getTimeout(). */
    void setTimeout(int milliseconds) override;
    void setTimeout_us(int microseconds) override;
    int getTimeout() const override;
    int getTimeout_us() const override;

    /** Always true, because the next step is a timeout. */
    bool timeout() override { return true; }

    /** For tests, which call it with the reason to simulate. */
    void work(base::RunnableInterface::WorkReason reason) override;

private:
    std::atomic<int> lastReason_{-1};
    std::atomic<int> timeoutUs_{0};
};

}  // namespace extras
}  // namespace RTT
#endif
