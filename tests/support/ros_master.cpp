// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <support/ros_master.hpp>

#include <cstdlib>
#include <stdexcept>
#include <thread>

#include <arpa/inet.h>
#include <csignal>
#include <sys/socket.h>
#include <unistd.h>

namespace oroforge::test {

namespace {

sockaddr_in local(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    return address;
}

int freePort() {
    const int fd = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address = local(0);
    socklen_t size = sizeof(address);
    const bool isBound = bind(fd, reinterpret_cast<sockaddr*>(&address), size) == 0 &&
                         getsockname(fd, reinterpret_cast<sockaddr*>(&address), &size) == 0;
    close(fd);
    if (!isBound) throw std::runtime_error("no free port");
    return ntohs(address.sin_port);
}

bool answers(int port) {
    const int fd = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const sockaddr_in address = local(port);
    const bool isThere = connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
    close(fd);
    return isThere;
}

}  // namespace

RosMaster::RosMaster(Start when) : port_(freePort()), uri_("http://127.0.0.1:" + std::to_string(port_)) {
    setenv("ROS_MASTER_URI", uri_.c_str(), 1);
    setenv("ROS_IP", "127.0.0.1", 1);
    setenv("ROS_HOME", folder().c_str(), 1);
    const char* const path = std::getenv("PATH");
    setenv("PATH", ("/usr/bin:" + std::string(path ? path : "/bin")).c_str(), 1);
    if (when == Start::Now && !start()) throw std::runtime_error("rosmaster does not answer at " + uri_);
}

RosMaster::~RosMaster() { stop(); }

bool RosMaster::start() {
    Command command;
    command.program = "rosmaster";
    command.arguments = {"--core", "-p", std::to_string(port_)};
    command.inputStaysOpen = true;
    command.timeout = std::chrono::minutes(10);
    process_ = std::make_unique<ChildProcess>(command);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (std::chrono::steady_clock::now() < end) {
        if (answers(port_)) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return false;
}

void RosMaster::stop() {
    if (!process_) return;
    process_->send(SIGTERM);
    process_->finish();
    process_.reset();
}

Outcome RosMaster::tool(const std::vector<std::string>& words, std::chrono::milliseconds limit) {
    Command command;
    command.program = words.at(0);
    command.arguments.assign(words.begin() + 1, words.end());
    command.timeout = limit;
    return run(command);
}

}  // namespace oroforge::test
