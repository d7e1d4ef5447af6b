// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Values of every type of the golden typekits in a CORBA::Any, through a message of either byte order.
#include <string>

#include <rtt/encoding/Json.hpp>
#include <rtt/transports/corba/detail/any_codec.hpp>

#include "../corba/any_wire.hpp"
#include "golden_typekit.hpp"
#include "value_filler.hpp"

using namespace oroforge;
using RTT::corba::detail::AnyCodec;
using RTT::types::TypeInfo;
using test::GoldenTypekit;

namespace {

typedef RTT::base::DataSourceBase::shared_ptr SourcePtr;

class AnyValues : public GoldenTypekit {
protected:
    void crosses(const TypeInfo& type) const {
        SCOPED_TRACE(type.getTypeName());
        std::string why;
        const auto codec = AnyCodec::make(type, corba_test::orb(), why);
        ASSERT_TRUE(codec) << why;
        const auto json = RTT::encoding::Json::make(type, why);
        const SourcePtr value = type.buildValue();
        test::ValueFiller(model, 7).fill(value);
        CORBA::Any any;
        ASSERT_TRUE(codec->put(value->getRawConstPointer(), any));
        const std::string text = json->text(value->getRawConstPointer());
        for (const bool little : {true, false}) {
            const SourcePtr back = type.buildValue();
            ASSERT_TRUE(codec->get(*corba_test::sent(any, little), back->getRawPointer(), why)) << why;
            EXPECT_EQ(json->text(back->getRawConstPointer()), text);
        }
    }
};

TEST_P(AnyValues, ComeBack) {
    forEachAssignable([this](const TypeInfo& type) { crosses(type); });
}

INSTANTIATE_TEST_SUITE_P(Golden, AnyValues, testing::ValuesIn(test::builtTypekits()), test::caseName);

}  // namespace
