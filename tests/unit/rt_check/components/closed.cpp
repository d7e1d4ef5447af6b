// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A library that is closed before anybody asks what was called from it.
#include <cstdlib>

extern "C" void* allocateInClosedLibrary() {
    void* volatile block = std::malloc(10);
    return block;
}
