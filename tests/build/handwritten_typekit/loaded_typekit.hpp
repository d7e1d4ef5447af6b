// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The built-in typekit and one more, and what its tests do with values.
#ifndef TESTS_BUILD_HANDWRITTEN_LOADED_TYPEKIT_HPP
#define TESTS_BUILD_HANDWRITTEN_LOADED_TYPEKIT_HPP

#include "unit/types/builtin_typekit.hpp"

#include <rtt/Property.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/marsh/PropertyDemarshaller.hpp>
#include <rtt/marsh/PropertyMarshaller.hpp>
#include <rtt/types/Operators.hpp>

#include <filesystem>
#include <unistd.h>

namespace types_test {

/** A fixture of tests that need the typekit in the file TYPEKIT_FILE, too. */
class WithLoadedTypekit : public WithBuiltinTypes {
protected:
    static void SetUpTestSuite() {
        WithBuiltinTypes::SetUpTestSuite();
        void* library = dlopen(TYPEKIT_FILE, RTLD_NOW | RTLD_LOCAL);
        ASSERT_NE(nullptr, library) << dlerror();
        auto* load = reinterpret_cast<bool (*)(RTT::TaskContext*)>(dlsym(library, "loadRTTPlugin"));
        ASSERT_NE(nullptr, load);
        ASSERT_TRUE(load(nullptr));
    }
    static SourcePtr make(const char* name, std::vector<SourcePtr> arguments) {
        return type(name)->construct(arguments);
    }
    static SourcePtr binary(const char* op, const SourcePtr& a, const SourcePtr& b) {
        return RTT::types::operators()->applyBinary(op, a.get(), b.get());
    }
    static SourcePtr unary(const char* op, const SourcePtr& a) {
        return RTT::types::operators()->applyUnary(op, a.get());
    }
    /** What a property file makes of the value. */
    template <class T>
    static T throughFile(const T& value) {
        const auto file = std::filesystem::temp_directory_path() / ("typekit_" + std::to_string(getpid()) + ".cpf");
        RTT::PropertyBag bag;
        bag.ownProperty(new RTT::Property<T>("value", "", value));
        { RTT::marsh::PropertyMarshaller(file.string()).serialize(bag); }
        RTT::PropertyBag read;
        EXPECT_TRUE(RTT::marsh::PropertyDemarshaller(file.string()).deserialize(read));
        std::filesystem::remove(file);
        RTT::Property<T> result("value", "");
        const auto* item = read.find("value");
        EXPECT_NE(nullptr, item);
        EXPECT_TRUE(item && result.update(item));
        return result.get();
    }
};

/** The text of a value, after evaluating it; "(null)" without one. */
inline std::string textOf(const SourcePtr& source) {
    if (!source) return "(null)";
    EXPECT_TRUE(source->evaluate());
    return source->toString();
}

}  // namespace types_test

#endif
