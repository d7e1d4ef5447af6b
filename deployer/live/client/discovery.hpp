// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Which deployments run on this computer.
#ifndef OROFORGE_LIVE_CLIENT_DISCOVERY_HPP
#define OROFORGE_LIVE_CLIENT_DISCOVERY_HPP

#include <string>
#include <vector>

#include <sys/types.h>

namespace oroforge::live_client {

/** A running deployment, as the name of its socket says. */
struct Deployment {
    pid_t pid = 0;
    std::string name;
    std::string socket;  ///< path of the socket
};

/** Where sockets are: the folder of this session, or one in /tmp for sessions without XDG_RUNTIME_DIR. */
std::string socketFolder();

/** Pid and name of a socket `<pid>-<name>.sock`; pid 0 if the file has another name. */
Deployment fromFileName(const std::string& folder, const std::string& file);

/** The deployments whose processes exist, by name and pid. Removes the sockets of processes that have died. A folder of
    another user is left out, because anyone could have planted its sockets. */
std::vector<Deployment> runningDeployments();

/** The deployment of that name, pid or path of a socket; without a word, the only one. Throws a Failure that lists the
    deployments if there is none or more than one. */
Deployment chosenDeployment(const std::string& wanted);

/** Whether the process is stopped, as by SIGSTOP. */
bool isStopped(pid_t pid);
/** Whether there is no such process any more, or only its exit status. */
bool hasEnded(pid_t pid);

}  // namespace oroforge::live_client

#endif
