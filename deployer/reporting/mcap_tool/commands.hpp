// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What the program oro-mcap does. Each returns its exit status.
#ifndef OROFORGE_MCAP_TOOL_COMMANDS_HPP
#define OROFORGE_MCAP_TOOL_COMMANDS_HPP

#include <string>
#include <vector>

namespace oroforge::mcap {

constexpr int kGood = 0;
constexpr int kDamaged = 1;  ///< part of a file cannot be read, or two files differ
constexpr int kFailed = 2;   ///< the command line, or a file that cannot be read or written at all

struct ToolOptions {
    std::string command;
    std::vector<std::string> files;
    std::vector<std::string> topics;
    std::string output;
    std::string format;
};

int info(const ToolOptions& options);
int cat(const ToolOptions& options);
int diff(const ToolOptions& options);
int recover(const ToolOptions& options);
int convert(const ToolOptions& options);
int convertToTable(const ToolOptions& options);
int convertToNetcdf(const ToolOptions& options);

/** False if the program is to end with this status. */
bool readCommandLine(int count, char** words, ToolOptions& options, int& status);

}  // namespace oroforge::mcap

#endif
