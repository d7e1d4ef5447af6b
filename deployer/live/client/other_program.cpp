// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "other_program.hpp"

#include "failure.hpp"
#include "session.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <unistd.h>

namespace oroforge::live_client {

void runOther(const std::string& program, const std::vector<std::string>& words) {
    std::error_code error;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
    const std::string path = (self.parent_path() / program).string();
    std::vector<char*> arguments{const_cast<char*>(program.c_str())};
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    // An ignored signal would be ignored by that program, too.
    std::signal(SIGPIPE, SIG_DFL);
    (void)::execv(path.c_str(), arguments.data());
    const int why = errno;
    std::signal(SIGPIPE, SIG_IGN);
    if (why == ENOENT)
        throw Failure(Status::Usage,
                      "there is no program '" + path +
                          "': the toolchain was built without recordings, for which it needs libzstd-dev "
                          "or liblz4-dev");
    throw Failure(Status::Usage, "cannot run '" + path + "': " + std::strerror(why));
}

/** Reached only with options in front of the command. */
void readRecording(Session&) {
    throw Failure(Status::Usage, "'oro mcap' takes no options of oro in front of it; 'oro mcap --help' explains it");
}

}  // namespace oroforge::live_client
