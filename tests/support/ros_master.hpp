// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// A real ROS master for tests.
#ifndef OROFORGE_TESTS_SUPPORT_ROS_MASTER_HPP
#define OROFORGE_TESTS_SUPPORT_ROS_MASTER_HPP

#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <support/child_process.hpp>
#include <support/temp_dir.hpp>

namespace oroforge::test {

/// `rosmaster --core` on a port of its own of 127.0.0.1, with a folder of its own for what ROS writes. The constructor sets
/// the environment of this process, and so of its children, for nodes of this master, and puts the system's Python first. It
/// starts the master and waits until it answers, unless told otherwise.
class RosMaster {
public:
    enum class Start { Now, Later };
    explicit RosMaster(Start when = Start::Now);
    ~RosMaster();  ///< ends the master
    RosMaster(const RosMaster&) = delete;
    RosMaster& operator=(const RosMaster&) = delete;

    /// (Again) on the same port. False if it does not answer within 10 s.
    bool start();
    void stop();
    void send(int signal) { process_->send(signal); }
    const std::string& uri() const { return uri_; }
    std::string folder() const { return folder_.path().string(); }

    /// Runs one of the command-line tools of ROS, with its words: {"rostopic", "list"}. Killed after the limit.
    static Outcome tool(const std::vector<std::string>& words,
                        std::chrono::milliseconds limit = std::chrono::seconds(20));

private:
    TempDir folder_;
    int port_;
    std::string uri_;
    std::unique_ptr<ChildProcess> process_;
};

}  // namespace oroforge::test

#endif
