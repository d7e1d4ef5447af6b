// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Any bytes are decoded as a value of any type of a typekit: what is read can be written and read again.
#include "fuzzing.hpp"

#include <rtt/encoding/Json.hpp>
#include <rtt/encoding/Plan.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeOps.hpp>
#include <rtt/types/Types.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

using namespace RTT;
using namespace RTT::encoding;

namespace {

struct Coded {
    const types::TypeInfo* type;
    std::shared_ptr<const Plan> plan;
    std::shared_ptr<const Json> json;
};

const std::vector<Coded>& all() {
    static const std::vector<Coded> known = [] {
        std::vector<Coded> result;
        for (const std::string& name : types::Types()->getTypes()) {
            const types::TypeInfo* const type = types::Types()->type(name);
            std::string why;
            auto plan = Plan::make(*type, cdrRules(), why);
            if (plan) result.push_back({type, plan, Json::make(*type, why)});
        }
        return result;
    }();
    return known;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    loadTypekit(RTT_TYPEKIT_FILE);
    loadTypekit(GOLDEN_TYPEKIT_FILE);
    require(all().size() > 50, "the types have plans");
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 2) return 0;
    const Coded& coded = all()[data[0] % all().size()];
    const ByteOrder order = data[1] % 2 == 0 ? ByteOrder::Little : ByteOrder::Big;
    const auto value = coded.type->buildValue(), back = coded.type->buildValue();
    const DecodeError error = coded.plan->decode(data + 2, size - 2, order, value->getRawPointer());
    // Also after an error it is some value.
    std::string bytes(coded.plan->sizeOf(value->getRawConstPointer()), '\0');
    const std::size_t written = coded.plan->encode(value->getRawConstPointer(), &bytes[0], bytes.size());
    require(written == bytes.size(), "the size is that of the bytes", coded.type->getTypeName());
    if (error) return 0;
    require(written != 0, "what was decoded can be encoded", coded.type->getTypeName());
    require(!coded.plan->decode(bytes.data(), bytes.size(), kNativeOrder, back->getRawPointer()),
            "what was encoded can be decoded", coded.type->getTypeName());
    const std::string text = coded.json->text(value->getRawConstPointer());
    require(coded.json->parse(text, back->getRawPointer()).empty(), "JSON can be read", text);
    return 0;
}
