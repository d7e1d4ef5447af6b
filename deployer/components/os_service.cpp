// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The service `os`, for scripts: environment, arguments, pauses and commands.
#include <rtt/os/startstop.h>
#include <rtt/plugin/ServicePlugin.hpp>

#include <cstdlib>
#include <ctime>
#include <string>
#include <sys/wait.h>
#include <vector>

namespace OCL {

class OSService : public RTT::Service {
public:
    explicit OSService(RTT::TaskContext* owner) : RTT::Service("os", owner) {
        doc("The operating system: environment, arguments of the program, pauses and commands.");
        const char* const name = "Name of the variable";
        addOperation("getenv", &OSService::getenv, this)
            .doc("The value of an environment variable; empty if it is not set.")
            .arg("name", name);
        addOperation("isenv", &OSService::isenv, this).doc("Is an environment variable set?").arg("name", name);
        addOperation("setenv", &OSService::setenv, this)
            .doc("Sets an environment variable of this process.")
            .arg("name", name)
            .arg("value", "Its new value");
        addOperation("argc", &OSService::argc, this).doc("The number of arguments of the program, with its name.");
        addOperation("argv", &OSService::argv, this).doc("The arguments of the program, its name first.");
        addOperation("sleep", &OSService::sleep, this).doc("Pauses the calling thread.").arg("seconds", "How long");
        addOperation("millisleep", &OSService::millisleep, this)
            .doc("Pauses the calling thread.")
            .arg("milliseconds", "How long");
        addOperation("usleep", &OSService::usleep, this)
            .doc("Pauses the calling thread.")
            .arg("microseconds", "How long");
        addOperation("nanosleep", &OSService::nanosleep, this)
            .doc("Pauses the calling thread.")
            .arg("seconds", "How long")
            .arg("nanoseconds", "And how much longer");
        addOperation("execute", &OSService::execute, this)
            .doc(
                "Executes a command of the shell and waits for its end. Returns its exit status; -1 if it did not end "
                "by itself.")
            .arg("command", "The command");
    }

private:
    std::string getenv(const std::string& name) {
        const char* const value = ::getenv(name.c_str());
        return value ? value : "";
    }
    bool isenv(const std::string& name) { return ::getenv(name.c_str()) != nullptr; }
    bool setenv(const std::string& name, const std::string& value) {
        return ::setenv(name.c_str(), value.c_str(), 1) == 0;
    }
    int argc() { return __os_main_argc(); }
    std::vector<std::string> argv() {
        char** const words = __os_main_argv();
        return std::vector<std::string>(words, words + __os_main_argc());
    }
    int sleep(unsigned seconds) { return nanosleep(seconds, 0); }
    int millisleep(unsigned milliseconds) { return nanosleep(milliseconds / 1000, milliseconds % 1000 * 1000000); }
    int usleep(unsigned microseconds) { return nanosleep(microseconds / 1000000, microseconds % 1000000 * 1000); }
    /** As ::nanosleep(). */
    int nanosleep(unsigned seconds, unsigned nanoseconds) {
        timespec rest{static_cast<time_t>(seconds), static_cast<long>(nanoseconds)};
        return ::nanosleep(&rest, nullptr);
    }
    int execute(const std::string& command) {
        const int status = std::system(command.c_str());
        return status != -1 && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
};

}  // namespace OCL

ORO_SERVICE_NAMED_PLUGIN(OCL::OSService, "os")
