// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A deployer as the target of attacks.
#ifndef OROFORGE_TEST_LIVE_TARGET_HPP
#define OROFORGE_TEST_LIVE_TARGET_HPP

#include "raw_client.hpp"

#include <support/child_process.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <netinet/in.h>
#include <sys/stat.h>

namespace live_test {

namespace fs = std::filesystem;
using oroforge::test::ChildProcess;

inline const std::string kToken = "0123456789abcdef0123456789abcdef";

inline unsigned freePort() {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    const int probe = ::socket(AF_INET, SOCK_STREAM, 0);
    (void)::bind(probe, reinterpret_cast<sockaddr*>(&address), size);
    (void)::getsockname(probe, reinterpret_cast<sockaddr*>(&address), &size);
    (void)::close(probe);
    return ntohs(address.sin_port);
}

/** A deployer that has nothing to do. */
class Target {
public:
    explicit Target(std::vector<std::string> words = {}, bool web = true) {
        const fs::path token = directory.write("token", kToken + "\n");
        (void)::chmod(token.c_str(), 0600);
        oroforge::test::Command command;
        command.program = DEPLOYER_PROGRAM;
        command.arguments = std::move(words);
        if (web) {
            command.arguments.push_back("--web=" + std::to_string(port));
            command.arguments.push_back("--web-token-file=" + token.string());
        }
        command.directory = directory.path();
        command.environment = {{"XDG_RUNTIME_DIR", directory.path().string()}, {"ORO_LOGFILE", "/dev/null"}};
        command.inputStaysOpen = true;
        command.timeout = std::chrono::seconds(30);
        child = std::make_unique<ChildProcess>(command);
        if (web) EXPECT_TRUE(child->waitForOutput("live window", std::chrono::seconds(20)));
        for (int i = 0; i < 1000 && !hasConsole(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    /** Then it has started. */
    bool hasConsole() const {
        std::error_code none;
        for (const auto& task : fs::directory_iterator("/proc/" + std::to_string(child->pid()) + "/task", none)) {
            std::string name;
            std::ifstream file(task.path() / "comm");
            if (std::getline(file, name) && name == "TaskBrowser") return true;
        }
        return false;
    }
    std::string socketFile() const {
        const fs::path folder = directory / "oroforge";
        std::error_code none;
        for (const auto& entry : fs::directory_iterator(folder, none)) return entry.path();
        return "";
    }
    RawClient local() const { return RawClient::unixSocket(socketFile()); }
    RawClient web() const { return RawClient::tcp(port); }
    static std::string target() { return "/?token=" + kToken; }
    /** It still answers, on both doors. */
    void expectHealth(const std::string& after) const {
        RawClient one = local();
        EXPECT_TRUE(one.open()) << after;
        EXPECT_TRUE(one.say({{"op", "oro.hello"}, {"id", 1}}));
        EXPECT_EQ("Deployer", one.hear("oro.answer").value("/result/name"_json_pointer, "")) << after;
        RawClient other = web();
        EXPECT_TRUE(other.open("oro.v1", target())) << after;
        EXPECT_TRUE(other.say({{"op", "oro.hello"}, {"id", 1}}));
        EXPECT_EQ(nlohmann::json::array(), other.hear("oro.answer")["result"]["allow"]) << after;
    }

    oroforge::test::TempDir directory;
    const unsigned port = freePort();
    std::unique_ptr<ChildProcess> child;
};

}  // namespace live_test

#endif
