// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Values of every type of the golden typekits through a message queue.
#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include <rtt/ConnPolicy.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/encoding/Json.hpp>
#include <rtt/encoding/Plan.hpp>

#include <unistd.h>

#include "golden_typekit.hpp"
#include "value_filler.hpp"

using namespace oroforge;
using namespace RTT::encoding;
using RTT::types::TypeInfo;
using test::GoldenTypekit;

namespace {

typedef RTT::base::DataSourceBase::shared_ptr SourcePtr;

class QueuedValues : public GoldenTypekit {
protected:
    void crosses(const TypeInfo& type) const {
        SCOPED_TRACE(type.getTypeName());
        const SourcePtr value = type.buildValue(), back = type.buildValue();
        test::ValueFiller(model, 7).fill(value);
        RTT::ConnPolicy policy = RTT::ConnPolicy::buffer(2);
        policy.transport = 2;
        policy.name_id = "/oroforge_golden_" + std::to_string(getpid());
        policy.data_size = bytesOf(type, value);
        if (policy.data_size > 8192) return;  // the limit of most systems
        const std::unique_ptr<RTT::base::OutputPortInterface> out(type.outputPort("out"));
        const std::unique_ptr<RTT::base::InputPortInterface> in(type.inputPort("in"));
        ASSERT_TRUE(out && in);
        ASSERT_TRUE(out->createStream(policy));
        ASSERT_TRUE(in->createStream(policy));
        ASSERT_EQ(out->write(value), RTT::WriteSuccess);
        ASSERT_TRUE(isReadSoon(*in, back));
        std::string why;
        const auto json = Json::make(type, why);
        EXPECT_EQ(json->text(back->getRawConstPointer()), json->text(value->getRawConstPointer()));
    }

private:
    static int bytesOf(const TypeInfo& type, const SourcePtr& value) {
        std::string why;
        const auto plan = Plan::make(type, cdrRules(), why);
        EXPECT_TRUE(plan) << why;
        return plan ? static_cast<int>(plan->sizeOf(value->getRawConstPointer()) + 8) : 0;
    }
    static bool isReadSoon(RTT::base::InputPortInterface& port, const SourcePtr& sample) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
        while (port.read(sample, false) != RTT::NewData) {
            if (std::chrono::steady_clock::now() > end) return false;
            std::this_thread::yield();
        }
        return true;
    }
};

TEST_P(QueuedValues, ComeBack) {
    forEachAssignable([this](const TypeInfo& type) { crosses(type); });
}

INSTANTIATE_TEST_SUITE_P(Golden, QueuedValues, testing::ValuesIn(test::builtTypekits()), test::caseName);

}  // namespace
