// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The option --record: what the components of a replay send.
#ifndef OROFORGE_DEPLOYER_REPLAY_RECORD_HPP
#define OROFORGE_DEPLOYER_REPLAY_RECORD_HPP

#include <ocl/DeploymentComponent.hpp>

#include <string>

namespace OCL::schedule {
class Schedule;
}

namespace OCL::deploy {

/** Records all output ports of the components that run, by an OCL::McapReporting in the schedule. Nothing in the file
    depends on the computer or its clock. */
class ReplayRecord {
public:
    /** Begins the file anew; `error` if that is impossible (RPL007). */
    ReplayRecord(const std::string& file, DeploymentComponent& deployer, schedule::Schedule& schedule,
                 std::string& error);
    ~ReplayRecord();
    ReplayRecord(const ReplayRecord&) = delete;
    ReplayRecord& operator=(const ReplayRecord&) = delete;

    /** Ends the file. False, with an error in the log, if something is missing in it. */
    bool finish();

private:
    RTT::TaskContext* recorder_ = nullptr;
};

}  // namespace OCL::deploy

#endif
