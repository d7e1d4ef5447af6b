// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Brackets around the C symbols of plugins that return C++ types. Both sides are C++ of the same ABI, so Clang's
// warning about it says nothing here.
#ifndef ORO_PLUGIN_C_LINKAGE_HPP
#define ORO_PLUGIN_C_LINKAGE_HPP

#if defined(__clang__)
#define ORO_PLUGIN_C_LINKAGE_BEGIN_ \
    _Pragma("clang diagnostic push") _Pragma("clang diagnostic ignored \"-Wreturn-type-c-linkage\"") extern "C" {
#define ORO_PLUGIN_C_LINKAGE_END_ \
    }                             \
    _Pragma("clang diagnostic pop")
#else
#define ORO_PLUGIN_C_LINKAGE_BEGIN_ extern "C" {
#define ORO_PLUGIN_C_LINKAGE_END_ }
#endif

#endif
