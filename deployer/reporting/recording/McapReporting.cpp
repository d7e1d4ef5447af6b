// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/McapReporting.hpp>

#include "options.hpp"
#include "recording.hpp"

#include <rtt/Logger.hpp>
#include <rtt/ConnPolicy.hpp>
#include <rtt/Property.hpp>

#include <utility>

namespace OCL {
namespace {

namespace mcap = oroforge::mcap;

/** Samples of one port between two cycles: 200 ms at 1 kHz. */
constexpr int kBuffer = 200;

}  // namespace

McapReporting::McapReporting(const std::string& name) : ReportingComponent(name) {
    compression_ = mcap::hasCompression(mcap::Compression::Zstd) ? "zstd" : "lz4";
    addProperty("ReportFile", reportFile_).doc("The file to write to; it begins anew with each start.");
    addProperty("Compression", compression_).doc("How chunks are compressed: zstd, lz4 or none.");
    addProperty("ChunkSize", chunkSize_)
        .doc("Messages are compressed and written together, as many as fit in here. [B]");
    addProperty("ChunkTime", chunkTime_)
        .doc("The longest time that a message waits for others to be written with. [s]");
    addProperty("Split", split_)
        .doc("When a file ends and the next one begins, such as '500 MB' or '60 s'. Empty: never.");
    addProperty("Ring", ring_)
        .doc("Keeps so many seconds in memory and writes them when save() is called. 0: everything is written. [s]");
    addProperty("RingSize", ringSize_)
        .doc("The memory that Ring may take, such as '500 MB'. If that is not enough, it keeps fewer seconds.");
    addProperty("States", states_).doc("Record the states of all peers to the topic /oroforge/states.");
    addProperty("Log", log_).doc("Record the lines of the log to the topic /rosout; not with Reproducible.");
    addProperty("Clock", clock_)
        .doc("The times of messages: realtime, since 1970, or component, that of the TimeService.");
    addProperty("Reproducible", reproducible_)
        .doc(
            "Record nothing of the host, the process and the time of day, and wait for the disk instead of losing "
            "messages: the same run in simulated time gives the same file. Needs Clock=component.");
    addProperty("RosNames", rosNames_).doc("Give fields names that ROS takes, such as angle_rad instead of angleRad.");
    addProperty("Schema", schema_)
        .doc("How types are described: ros2msg, omgidl, or auto: ros2msg if ROS takes all their names.");
    // What only tables have.
    for (const char* const table : {"WriteHeader", "RepeatHeader", "Decompose", "ComplexDecompose", "Snapshot",
                                    "Synchronize", "ReportOnlyNewData", "Precision"})
        if (RTT::base::PropertyBase* const property = getProperty(table)) properties()->removeProperty(property);
    RTT::ConnPolicy policy = RTT::ConnPolicy::circularBuffer(kBuffer);
    policy.mandatory = false;  // a component is not told that this one is late
    if (auto* const property = dynamic_cast<RTT::Property<RTT::ConnPolicy>*>(getProperty("ReportPolicy")))
        property->set(policy);
    addOperation("save", &McapReporting::save, this)
        .doc("Writes the last seconds to a file, with the property Ring, and waits for that.");
}

McapReporting::~McapReporting() { stopForGood(); }

bool McapReporting::startHook() {
    recording::RecordingOptions options;
    std::string why;
    const recording::OptionTexts texts = {compression_, split_,     ringSize_, clock_,       schema_,
                                          chunkSize_,   chunkTime_, ring_,     reproducible_};
    if (!recording::readOptions(texts, options, why)) {
        RTT::log(RTT::Error) << "'" << getName() << "' does not start: " << why << RTT::endlog();
        return false;
    }
    options.component = getName();
    options.file = reportFile_;
    options.sources.rosNames = rosNames_;
    if (states_) options.peers = getPeerGates();
    // When a line comes depends on another thread.
    options.hasLog = log_ && !reproducible_;
    reportBy([this, options](const reporting::Sources& sources, const reporting::ReportOptions& general) {
        recording::RecordingOptions all = options;
        all.onFailure = general.onFailure;
        std::unique_ptr<recording::Recording> made = recording::Recording::make(sources, all);
        running_ = made.get();
        return std::unique_ptr<reporting::Report>(std::move(made));
    });
    return ReportingComponent::startHook();
}

void McapReporting::stopHook() {
    running_ = nullptr;
    ReportingComponent::stopHook();
}

// Only while this component runs, in its own thread.
void McapReporting::dataOnPortCallback(RTT::base::PortInterface* port) {
    if (running_) running_->hasData(port);
    ReportingComponent::dataOnPortCallback(port);
}

bool McapReporting::save() {
    bool good = false, hasRing = false;
    withReport([&](reporting::Report* report) {
        auto* const recording = static_cast<recording::Recording*>(report);
        hasRing = recording && recording->hasRing();
        good = hasRing && recording->save();  // reports why it fails
    });
    if (!hasRing)
        RTT::log(RTT::Error) << "'" << getName() << "' saved nothing: it must run, with the property Ring larger than 0"
                             << RTT::endlog();
    return good;
}

}  // namespace OCL
