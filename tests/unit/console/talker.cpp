// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component that writes from its own thread while somebody types.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

class Talker : public RTT::TaskContext {
public:
    explicit Talker(const std::string& name) : TaskContext(name) {
        addOperation("talk", &Talker::talk, this, RTT::OwnThread).doc("Writes the text once there is a file 'go'");
        addOperation("block", &Talker::block, this, RTT::ClientThread)
            .doc("Returns once there is a file 'go'; by whoever calls it");
        addOperation("begin", &Talker::begin, this, RTT::ClientThread).doc("Writes that something begins");
    }
    ~Talker() override { stop(); }

protected:
    void stopHook() override { close(creat("stopped", 0600)); }

private:
    void begin() { std::cout << "begun" << std::endl; }
    void block() {
        begin();
        while (access("go", F_OK) != 0) usleep(1000);
        unlink("go");
    }
    void talk(const std::string& how, const std::string& text) {
        if (how == "wait") begin();
        while (access("go", F_OK) != 0) usleep(1000);
        if (how == "log") RTT::log(RTT::Error) << text << RTT::endlog();
        if (how == "out") std::cout << text << " and " << text.size() << " letters" << std::endl;
        if (how == "err") std::cerr << text << " and " << text.size() << " letters\n";
        if (how == "begin") std::cout << text << std::flush;
        if (how == "letters")
            for (const char letter : text) std::cout.put(letter).flush(), usleep(2000);
        if (how == "flood")
            for (int i = 0; i != 300; ++i) std::cout << text << ' ' << i << std::endl;
        if (how == "ever")
            while (access("enough", F_OK) != 0) std::cout << text << std::endl;
        if (how == "abort") std::abort();
        if (how == "segv") raise(SIGSEGV);
        if (how == "die") {
            std::cout << text << std::endl;
            _exit(7);
        }
        if (how == "fork") {
            const pid_t child = fork();
            if (child == 0 && text == "abort") std::abort();
            if (child == 0) {
                std::cout << text << std::endl;
                _exit(0);
            }
            waitpid(child, nullptr, 0);
        }
        unlink("go");
        if (how == "throw") throw std::runtime_error(text);
        if (how == "throw a number") throw 3;
    }
};

}  // namespace

ORO_CREATE_COMPONENT(Talker)
