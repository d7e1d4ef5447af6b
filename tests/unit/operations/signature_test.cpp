// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/Service.hpp>
#include <rtt/internal/calls/operation_signature.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <gtest/gtest.h>

#include <string>

using namespace RTT;
using internal::OperationSignature;

namespace {

struct Spelling {
    const char *text, *typeName, *written;
    bool isConst, isReference, isPointer;
};

/** A part of a transport: it has names of types only. */
class ForeignPart final : public OperationInterfacePart {
public:
    std::string getName() const override { return "measure"; }
    std::string description() const override { return ""; }
    std::vector<ArgumentDescription> getArgumentList() const override {
        return {{"where", "the place", "string const&"}, {"value", "the reading", "double&"}, {"times", "", "int"}};
    }
    std::string resultType() const override { return "void"; }
    unsigned arity() const override { return 3; }
    const types::TypeInfo* getArgumentType(unsigned) const override { return nullptr; }
    unsigned collectArity() const override { return 1; }
    const types::TypeInfo* getCollectType(unsigned) const override { return nullptr; }
    base::DataSourceBase::shared_ptr produce(const Args&, ExecutionEngine*) const override { return nullptr; }
    base::DataSourceBase::shared_ptr produceSend(const Args&, ExecutionEngine*) const override { return nullptr; }
    base::DataSourceBase::shared_ptr produceHandle() const override { return nullptr; }
    base::DataSourceBase::shared_ptr produceCollect(const Args&,
                                                    internal::DataSource<bool>::shared_ptr) const override {
        return nullptr;
    }
};

int divide(int, double&, const std::string&) { return 0; }

}  // namespace

TEST(OperationSignature, ReadsHowTypesAreWritten) {
    for (const Spelling& spelling : {
             Spelling{"double", "double", "double", false, false, false},
             Spelling{"double&", "double", "double &", false, true, false},
             Spelling{"double &", "double", "double &", false, true, false},
             Spelling{"double const&", "double", "double const&", true, true, false},
             Spelling{"double const &", "double", "double const&", true, true, false},
             Spelling{"const double&", "double", "double const&", true, true, false},
             Spelling{"double const", "double", "double const", true, false, false},
             Spelling{"double*", "double", "double*", false, false, true},
             Spelling{"/my/constant&", "/my/constant", "/my/constant &", false, true, false},
             Spelling{"const", "const", "const", false, false, false},
             Spelling{"", "", "", false, false, false},
         }) {
        const auto value = OperationSignature::Value::parsed(spelling.text);
        EXPECT_EQ(value.typeName, spelling.typeName) << spelling.text;
        EXPECT_EQ(value.text(), spelling.written) << spelling.text;
        EXPECT_EQ(value.isConst, spelling.isConst) << spelling.text;
        EXPECT_EQ(value.isReference, spelling.isReference) << spelling.text;
        EXPECT_EQ(value.isPointer, spelling.isPointer) << spelling.text;
        EXPECT_EQ(value.isOutput(), spelling.isReference && !spelling.isConst) << spelling.text;
    }
}

TEST(OperationSignature, HasTypesAndNames) {
    const Service::shared_ptr service = Service::Create("calculator");
    service->addOperation("divide", &divide).doc("Divides.").arg("a", "the first").arg("rest", "what is left");
    const OperationSignature signature = service->getOperation("divide")->signature();
    EXPECT_EQ(*signature.result.id, typeid(int));
    ASSERT_EQ(signature.arguments.size(), 3u);
    EXPECT_EQ(signature.arguments[0].name + ": " + signature.arguments[0].description, "a: the first");
    EXPECT_EQ(*signature.arguments[1].id, typeid(double));
    EXPECT_TRUE(signature.arguments[1].isOutput());
    EXPECT_EQ(signature.arguments[2].name, "arg3");
    EXPECT_EQ(*signature.arguments[2].id, typeid(std::string));
    EXPECT_FALSE(signature.arguments[2].isOutput());
    const auto collected = signature.collected();
    ASSERT_EQ(collected.size(), 2u);
    EXPECT_EQ(collected[0], &signature.result);
    EXPECT_EQ(collected[1], &signature.arguments[1]);
}

TEST(OperationSignature, OfAnOtherPartFollowsFromItsWords) {
    const OperationSignature signature = ForeignPart().signature();
    EXPECT_TRUE(signature.result.isVoid());
    ASSERT_EQ(signature.arguments.size(), 3u);
    EXPECT_EQ(signature.arguments[0].typeName, "string");
    EXPECT_EQ(signature.arguments[1].description, "the reading");
    ASSERT_EQ(signature.collected().size(), 1u);
    EXPECT_EQ(signature.collected()[0], &signature.arguments[1]);
}
