// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Brackets for C symbols of plugins that return C++ types. Caller and plugin are C++ of one ABI, so Clang's warning
// about such functions does not apply.
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
