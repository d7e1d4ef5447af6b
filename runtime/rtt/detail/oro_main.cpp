// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/main.h>

#include <rtt/Logger.hpp>

#include <cstdio>
#include <cstring>
#include <exception>
#include <string>

/** @file The function behind the macro ORO_main. It is not in os/, because it logs. */
namespace {

bool startsWith(const char* text, const char* start) { return std::strncmp(text, start, std::strlen(start)) == 0; }

/** Looks for --nocatch; removes it only if no other argument changes its position. */
bool takeNoCatch(int& argc, char** argv) {
    for (int i = 1; i < argc; ++i)
        if (startsWith(argv[i], "--nocatch") || startsWith(argv[i], "--no-catch")) {
            if (i == argc - 1) --argc;
            return true;
        }
    return false;
}

void reportFailure(const char* what) {
    std::fprintf(stderr,
                 "ORO_main() was left by an exception: %s\n"
                 "  to find where it was thrown, run the program in a debugger with the argument --nocatch\n",
                 what);
}

int runCatching(int argc, char** argv, int (*body)(int, char**)) {
    try {
        return body(argc, argv);
    } catch (const std::exception& e) {
        reportFailure(e.what());
    } catch (...) {
        reportFailure("not a std::exception");
    }
    return -1;
}

}  // namespace

int __os_run_main(int argc, char** argv, int (*body)(int, char**)) {
    int result = __os_init(argc, argv);
    if (result != 0) {
        std::fprintf(stderr, "the runtime does not start: a start function returned %d\n", result);
    } else {
        RTT::Logger::In in(std::string(argc > 0 ? argv[0] : "") + "::main()");
        result = takeNoCatch(argc, argv) ? body(argc, argv) : runCatching(argc, argv, body);
    }
    __os_exit();
    return result;
}
