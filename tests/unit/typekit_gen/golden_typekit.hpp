// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// A typekit of tests/golden/{typekit,typekit_view}, compiled and loaded, with what typegen reads from its headers.
#ifndef OROFORGE_TESTS_GOLDEN_TYPEKIT_HPP
#define OROFORGE_TESTS_GOLDEN_TYPEKIT_HPP

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <model/type_model.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <support/golden.hpp>

namespace oroforge::test {

/// Names of the cases that this build has made plugins of: all, or a few in sanitizer builds.
std::vector<std::string> builtTypekits();

class GoldenTypekit : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override;

    /// Throws if there is none.
    static const RTT::types::TypeInfo& typeOf(const std::string& name);
    /// Calls `each(type)` for all types whose values can be made and assigned.
    template <class Each>
    void forEachAssignable(Each each) const {
        for (const auto& type : model.structs)
            if (type.assignable && type.make.empty()) each(typeOf(type.name));
        for (const auto& type : model.enums) each(typeOf(type.name));
        for (const auto& type : model.library) each(typeOf(type.name));
    }

    std::string name;
    model::TypeModel model;
};

}  // namespace oroforge::test

#endif
