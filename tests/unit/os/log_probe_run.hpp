// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Runs log_probe in a folder of its own.
#ifndef OROFORGE_TESTS_LOG_PROBE_RUN_HPP
#define OROFORGE_TESTS_LOG_PROBE_RUN_HPP

#include <support/child_process.hpp>
#include <support/temp_dir.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace os_test {

using Environment = std::map<std::string, std::string>;

inline std::string contentOf(const std::filesystem::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

inline std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++found;
    return found;
}

/** With the default of each variable that is not given. */
inline oroforge::test::Command probeCommand(const std::filesystem::path& folder, Environment environment,
                                            std::vector<std::string> arguments) {
    for (const char* name : {"ORO_LOGLEVEL", "ORO_LOGFILE", "ORO_LOGTIME", "ORO_LOGFILE_KEEP", "ORO_LOGFILE_MAX"})
        environment.emplace(name, "");
    oroforge::test::Command command;
    command.program = LOG_PROBE;
    command.arguments = std::move(arguments);
    command.directory = folder;
    command.environment = std::move(environment);
    return command;
}

struct Probe {
    oroforge::test::TempDir directory;
    oroforge::test::Outcome outcome;
    std::string file;

    explicit Probe(Environment environment = {}, std::vector<std::string> arguments = {}) {
        run(std::move(environment), std::move(arguments));
    }
    /** Once more in the same folder. */
    void run(Environment environment = {}, std::vector<std::string> arguments = {}) {
        outcome = oroforge::test::run(probeCommand(directory.path(), std::move(environment), std::move(arguments)));
        file = read("orocos.log");
    }
    std::string read(const std::string& name) const { return contentOf(directory.path() / name); }
    bool exists(const std::string& name) const { return std::filesystem::exists(directory.path() / name); }
    /** Names of all files. */
    std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(directory.path()))
            names.push_back(entry.path().filename().string());
        return names;
    }
};

}  // namespace os_test

#endif
