// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Values of every type of the golden typekits as bytes and as JSON, and back.
#include <memory>
#include <string>

#include <rtt/encoding/Json.hpp>
#include <rtt/encoding/Plan.hpp>
#include <rtt/types/TypeOps.hpp>

#include "../encoding/reference_cdr.hpp"
#include "golden_typekit.hpp"
#include "value_filler.hpp"

using namespace oroforge;
using namespace RTT::encoding;
using RTT::types::TypeInfo;
using test::GoldenTypekit;

namespace {

typedef RTT::base::DataSourceBase::shared_ptr SourcePtr;

class EncodedValues : public GoldenTypekit {
protected:
    void comesBack(const TypeInfo& type, unsigned seed) const {
        SCOPED_TRACE(type.getTypeName());
        std::string why;
        const auto plan = Plan::make(type, cdrRules(), why);
        ASSERT_TRUE(plan) << why;
        const auto json = Json::make(type, why);
        ASSERT_TRUE(json) << why;
        const SourcePtr value = type.buildValue();
        test::ValueFiller(model, seed).fill(value);
        const std::string bytes = encoded(*plan, value);
        const std::string text = json->text(value->getRawConstPointer());
        test::ReferenceCdr reference(kNativeOrder);
        reference.put(type, value->getRawConstPointer());
        EXPECT_EQ(bytes, reference.bytes());
        returnsFromBytes(type, *plan, *json, bytes, kNativeOrder, text);
        const ByteOrder other = kNativeOrder == ByteOrder::Little ? ByteOrder::Big : ByteOrder::Little;
        test::ReferenceCdr swapped(other);
        swapped.put(type, value->getRawConstPointer());
        returnsFromBytes(type, *plan, *json, swapped.bytes(), other, text);
        refusesEveryTruncation(type, *plan, bytes);
        const SourcePtr fromText = type.buildValue();
        EXPECT_EQ(json->parse(text, fromText->getRawPointer()), "") << text;
        EXPECT_EQ(json->text(fromText->getRawConstPointer()), text);
    }

private:
    static std::string encoded(const Plan& plan, const SourcePtr& value) {
        std::string bytes(plan.sizeOf(value->getRawConstPointer()), 'x');
        EXPECT_EQ(plan.encode(value->getRawConstPointer(), &bytes[0], bytes.size()), bytes.size());
        EXPECT_EQ(plan.encode(value->getRawConstPointer(), &bytes[0], bytes.size() - 1), 0U);
        EXPECT_EQ(plan.encode(value->getRawConstPointer(), &bytes[0], bytes.size()), bytes.size());
        return bytes;
    }
    static void returnsFromBytes(const TypeInfo& type, const Plan& plan, const Json& json, const std::string& bytes,
                                 ByteOrder order, const std::string& text) {
        const SourcePtr back = type.buildValue();
        const DecodeError error = plan.decode(bytes.data(), bytes.size(), order, back->getRawPointer());
        EXPECT_FALSE(error) << error.text();
        EXPECT_EQ(json.text(back->getRawConstPointer()), text);
        const std::string longer = bytes + '\0';
        EXPECT_TRUE(plan.decode(longer.data(), longer.size(), order, back->getRawPointer()));
    }
    static void refusesEveryTruncation(const TypeInfo& type, const Plan& plan, const std::string& bytes) {
        const SourcePtr back = type.buildValue();
        for (std::size_t size = 0; size != bytes.size(); ++size) {
            const std::unique_ptr<char[]> part(new char[size]);  // without a byte behind it, for AddressSanitizer
            std::copy_n(bytes.begin(), size, part.get());
            EXPECT_TRUE(plan.decode(part.get(), size, kNativeOrder, back->getRawPointer())) << size;
        }
    }
};

TEST_P(EncodedValues, ComeBack) {
    for (const unsigned seed : {0U, 7U}) forEachAssignable([&](const TypeInfo& type) { comesBack(type, seed); });
}

INSTANTIATE_TEST_SUITE_P(Golden, EncodedValues, testing::ValuesIn(test::builtTypekits()), test::caseName);

}  // namespace
