// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "commands.hpp"
#include "plain_text.hpp"

#include <csignal>
#include <exception>
#include <iostream>
#include <optional>

#include <unistd.h>

int main(int count, char** words) {
    using namespace oroforge::mcap;
    // As `oro`: nothing is wrong if the reader of the output has seen enough.
    std::signal(SIGPIPE, [](int) { _exit(0); });
    ToolOptions options;
    int status = kFailed;
    const PlainText errors(std::cerr);
    std::optional<PlainText> output;
    try {
        if (!readCommandLine(count, words, options, status)) return status;
        // Programs get the data as it is.
        const bool isData = options.command == "cat" || options.command == "convert";
        if (!isData || isatty(STDOUT_FILENO)) output.emplace(std::cout);
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
