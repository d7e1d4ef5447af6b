// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_MCAP_REPORTING_HPP
#define ORO_OCL_MCAP_REPORTING_HPP

#include <ocl/ReportingComponent.hpp>

#include <string>

namespace OCL {
namespace recording {
class Recording;
}

/**
 * Records all samples of output ports, and changes of properties and attributes, to an MCAP file, which Foxglove,
 * PlotJuggler and the tools of ROS 2 open. start() begins the file anew and stop() completes it.
 *
 * Each port has its own buffer, of the size in ReportPolicy, which this component empties in each cycle. It never waits
 * for the disk: a thread compresses and writes. What is lost is counted: in the log, as gaps in the sequence numbers of
 * the messages, and in the metadata of the file. If the process is killed, all but the last ChunkTime seconds can be
 * read.
 *
 * A component that writes to a recorded port has one connection more, and does not wait for this one. With Reproducible
 * this component waits for the disk; if all run in one thread of simulated time, so do they.
 */
class OCL_API McapReporting : public ReportingComponent {
public:
    explicit McapReporting(const std::string& name = "McapReporting");
    ~McapReporting() override;

    /** With the property Ring: writes the last seconds to a file, and waits for that. False, with an error in the log,
        if it fails, there is no Ring, or the component does not run. Any thread may call it; not real-time. */
    bool save();

protected:
    bool startHook() override;
    void stopHook() override;
    void dataOnPortCallback(RTT::base::PortInterface* port) override;

private:
    recording::Recording* running_ = nullptr;  // while this component runs
    std::string reportFile_ = "recording.mcap";
    std::string compression_, split_, ringSize_ = "1 GB", clock_ = "realtime", schema_ = "auto";
    unsigned int chunkSize_ = 1U << 20;
    double chunkTime_ = 0.5, ring_ = 0;
    bool reproducible_ = false, rosNames_ = false, states_ = true, log_ = true;
};

}  // namespace OCL

#endif
