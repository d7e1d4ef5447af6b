// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_MCAP_REPLAY_HPP
#define ORO_OCL_MCAP_REPLAY_HPP

#include <ocl/OCL.hpp>
#include <rtt/TaskContext.hpp>

#include <memory>
#include <string>

namespace OCL {

/**
 * Repeats the ports of a recording, which McapReporting or another recorder has written to an MCAP file.
 *
 * configure() opens the file and makes an output port for each recorded one, with its type, in a service with the name
 * of the recorded component: `Camera.image`. It fails, with the reason in the log, if the file cannot be read, or a
 * type is not loaded or has other fields than the recorded one. cleanup() removes the ports, and with them their
 * connections.
 *
 * From start() to stop() each sample is written when its time has come, counted from start() and divided by Speed. A
 * periodic activity writes in each cycle what has become due. Without a period, a thread with the scheduler and
 * priority of the activity wakes the component for each sample. At the end the component stops, or begins again if Loop
 * is set. If it is late, samples are written late, and none is left out.
 *
 * Not real-time: it reads the file, decompresses and allocates. Components that read its ports are not affected.
 *
 * The operations may be called by any thread. They wait for a cycle of the component to end, and seek() also for the
 * file.
 */
class OCL_API McapReplay : public RTT::TaskContext {
public:
    explicit McapReplay(const std::string& name = "McapReplay");
    ~McapReplay() override;

    /** Goes on at that time, in seconds from the begin of the recording. If the component does not run, its next
        start() begins there instead of at the property Start. False if it is not configured, or the time is not
        between Start and End. */
    bool seek(double seconds);
    /** Stands still until resume(). False if the component does not run. */
    bool pause();
    /** Goes on where pause() or step() stopped. False if the component does not stand still. */
    bool resume();
    /** While it stands still: writes all samples with the next recorded time. False if it does not stand still. */
    bool step();

protected:
    bool configureHook() override;
    bool startHook() override;
    void updateHook() override;
    void stopHook() override;
    void cleanupHook() override;

private:
    struct Impl;
    const std::unique_ptr<Impl> impl_;
};

}  // namespace OCL

#endif
