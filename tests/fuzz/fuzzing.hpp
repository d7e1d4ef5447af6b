// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What the fuzzers share.
#ifndef TESTS_FUZZ_FUZZING_HPP
#define TESTS_FUZZ_FUZZING_HPP

#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <string>

namespace RTT {
class TaskContext;
}

/// Ends the program, which libFuzzer takes for a finding.
inline void require(bool condition, const char* what, const std::string& text = "") {
    if (condition) return;
    std::fprintf(stderr, "does not hold: %s\n%s\n", what, text.c_str());
    std::abort();
}

/// Loads the plugin with the standard types.
inline void loadTypekit(const char* file) {
    void* library = dlopen(file, RTLD_NOW);
    require(library != nullptr, "the typekit is there");
    require(reinterpret_cast<bool (*)(RTT::TaskContext*)>(dlsym(library, "loadRTTPlugin"))(nullptr),
            "the typekit is loaded");
}

#endif
