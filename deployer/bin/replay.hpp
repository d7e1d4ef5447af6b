// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What --replay and the options that go with it ask for.
#ifndef OROFORGE_DEPLOYER_REPLAY_HPP
#define OROFORGE_DEPLOYER_REPLAY_HPP

#include "deployer_options.hpp"

#include <ocl/DeploymentComponent.hpp>

#include <memory>

namespace RTT::os {
class SignalCatcher;
}

namespace OCL::deploy {

class ProgramReport;

/** Stops the time of the process, before the first line of the log: lines do not tell how fast the computer is. */
void standStill();

/** A replay: while it exists, time stands, and recorded components are replaced. It exists longer than the deployer. */
class Replay {
public:
    /** Opens the recording that the options name. Null, with an error reported, if it cannot be replayed. */
    static std::unique_ptr<Replay> open(const Options& options, ProgramReport& report);
    ~Replay();
    Replay(const Replay&) = delete;
    Replay& operator=(const Replay&) = delete;

    /** Replays all of it, in the calling thread, or until a signal comes, and writes a line that tells how much that
        was. False, with an error reported, if it did not get to the end, or cannot be recorded. */
    bool run(DeploymentComponent& deployer, RTT::os::SignalCatcher& ending);

private:
    struct Impl;
    explicit Replay(std::unique_ptr<Impl> impl);
    const std::unique_ptr<Impl> impl_;
};

}  // namespace OCL::deploy

#endif
