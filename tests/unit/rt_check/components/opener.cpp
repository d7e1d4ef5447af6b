// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A library that knows where another one is.
#include <dlfcn.h>

extern "C" void* openOtherLibrary() {
    void* volatile library = dlopen("librt_check_closed.so", RTLD_NOW | RTLD_LOCAL);
    return library;
}
