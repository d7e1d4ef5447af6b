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
 * Stands in for a FileDescriptorActivity in a simulation: made with the same arguments, executed by the SimulationThread,
 * and never watches anything. Every step of the simulation looks like a timeout to the component; work(IOReady) makes
 * it look as if all its descriptors were ready.
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
    /** Only remembered. */
    void setTimeout(int milliseconds) override;
    void setTimeout_us(int microseconds) override;
    int getTimeout() const override;
    int getTimeout_us() const override;

    /** True: the next step is one. */
    bool timeout() override { return true; }

    /** For a test of a component, which calls it with the reason that it wants to play. */
    void work(base::RunnableInterface::WorkReason reason) override;

private:
    std::atomic<int> lastReason_{-1};
    std::atomic<int> timeoutUs_{0};
};

}  // namespace extras
}  // namespace RTT
#endif
