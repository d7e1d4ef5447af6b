// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A typekit with one type, TYPE_NAME, a struct of the class TYPE_CLASS.
#include <rtt/types/TemplateTypeInfo.hpp>
#include <rtt/types/TypekitPlugin.hpp>

struct TYPE_CLASS {
    double metres = 0;
};

namespace {

class OneType : public RTT::types::TypekitPlugin {
public:
    bool loadTypes() override {
        return RTT::types::Types()->addType(new RTT::types::TemplateTypeInfo<TYPE_CLASS, false>(TYPE_NAME));
    }
    bool loadConstructors() override { return true; }
    bool loadOperators() override { return true; }
    std::string getName() override { return TYPE_NAME; }
};

}  // namespace

ORO_TYPEKIT_PLUGIN(OneType)
