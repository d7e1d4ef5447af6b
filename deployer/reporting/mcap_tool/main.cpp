// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "commands.hpp"

#include <exception>
#include <iostream>

int main(int count, char** words) {
    using namespace oroforge::mcap;
    ToolOptions options;
    int status = kFailed;
    try {
        if (!readCommandLine(count, words, options, status)) return status;
        if (options.command == "info") status = info(options);
        if (options.command == "cat") status = cat(options);
        if (options.command == "diff") status = diff(options);
        if (options.command == "recover") status = recover(options);
        if (options.command == "convert") status = convert(options);
        std::cout.flush();
        if (std::cout) return status;
        std::cerr << "oro-mcap: error: standard output cannot be written\n";
    } catch (const std::exception& error) {
        std::cerr << "oro-mcap: error: " << error.what() << "\n";
    }
    return kFailed;
}
