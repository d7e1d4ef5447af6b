// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/any_codec.hpp>

#include <rtt/transports/corba/detail/type_codes.hpp>

#include <omniORB4/anyStream.h>

#include <utility>
#include <vector>

namespace RTT::corba::detail {

std::shared_ptr<const AnyCodec> AnyCodec::make(const types::TypeInfo& type, CORBA::ORB_ptr orb, std::string& why) {
    auto plan = encoding::Plan::make(type, encoding::corbaRules(), why);
    if (!plan) return nullptr;
    CORBA::TypeCode_var typeCode = typeCodeOf(type, orb, why);
    if (CORBA::is_nil(typeCode)) return nullptr;
    return std::shared_ptr<const AnyCodec>(new AnyCodec(std::move(plan), typeCode));
}

AnyCodec::AnyCodec(std::shared_ptr<const encoding::Plan> plan, CORBA::TypeCode_var typeCode)
    : plan_(std::move(plan)), typeCode_(typeCode) {}

bool AnyCodec::put(const void* value, CORBA::Any& any) const {
    std::vector<CORBA::Octet> bytes(plan_->sizeOf(value));
    if (bytes.empty() || plan_->encode(value, bytes.data(), bytes.size()) != bytes.size()) return false;
    // The stream in an Any begins at a multiple of 8, as the bytes of a Plan do.
    any.PR_insert(
        typeCode_.in(),
        [](cdrStream& stream, void* all) {
            const auto& written = *static_cast<const std::vector<CORBA::Octet>*>(all);
            stream.put_octet_array(written.data(), static_cast<int>(written.size()), omni::ALIGN_8);
        },
        &bytes);
    return true;
}

bool AnyCodec::get(const CORBA::Any& any, void* value, std::string& why) const {
    try {
        const CORBA::TypeCode_ptr found = any.NP_type();
        if (!found->equivalent(typeCode_.in())) {
            why = "it has another type";
            return false;
        }
        cdrAnyMemoryStream& stream = any.PR_streamToRead();
        const auto order = stream.unmarshal_byte_swap()
                               ? (encoding::kNativeOrder == encoding::ByteOrder::Little ? encoding::ByteOrder::Big
                                                                                        : encoding::ByteOrder::Little)
                               : encoding::kNativeOrder;
        const encoding::DecodeError error = plan_->decode(stream.bufPtr(), stream.bufSize(), order, value);
        if (error) why = error.text();
        return !error;
    } catch (const CORBA::Exception& error) {
        why = error._name();
        return false;
    }
}

}  // namespace RTT::corba::detail
