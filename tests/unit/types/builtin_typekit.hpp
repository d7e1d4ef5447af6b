// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Loads the built-in typekit, and helpers that make sources of values.
#ifndef TESTS_UNIT_TYPES_BUILTIN_TYPEKIT_HPP
#define TESTS_UNIT_TYPES_BUILTIN_TYPEKIT_HPP

#include <rtt/TaskContext.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/types/Types.hpp>

#include <gtest/gtest.h>

#include <dlfcn.h>
#include <string>

namespace types_test {

using RTT::base::DataSourceBase;
using SourcePtr = DataSourceBase::shared_ptr;

/** A fixture of tests that need the built-in types; the plugin stays loaded. */
class WithBuiltinTypes : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        void* library = dlopen(RTT_TYPEKIT_FILE, RTLD_NOW | RTLD_LOCAL);
        ASSERT_NE(nullptr, library) << dlerror();
        using Load = bool (*)(RTT::TaskContext*);
        auto load = reinterpret_cast<Load>(dlsym(library, "loadRTTPlugin"));
        ASSERT_NE(nullptr, load);
        ASSERT_TRUE(load(nullptr));
    }
};

template <class T>
boost::intrusive_ptr<RTT::internal::ValueDataSource<T>> variable(const T& value) {
    return new RTT::internal::ValueDataSource<T>(value);
}

inline boost::intrusive_ptr<RTT::internal::ValueDataSource<std::string>> variable(const char* text) {
    return variable(std::string(text));
}

/** The value of a source that must be of type T. */
template <class T>
T valueOf(const SourcePtr& source) {
    auto* typed = RTT::internal::DataSource<T>::narrow(source.get());
    EXPECT_NE(nullptr, typed) << "source is of type " << (source ? source->getType() : "(null)");
    return typed ? typed->get() : T();
}

inline RTT::types::TypeInfo* type(const std::string& name) { return RTT::types::Types()->type(name); }

}  // namespace types_test

#endif
