// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/any_codec.hpp>

#include <rtt/transports/corba/detail/type_codes.hpp>

#include <omniORB4/anyStream.h>

#include <utility>
#include <vector>

namespace RTT::corba::detail {

namespace {

struct Bytes {
    const CORBA::Octet* data;
    std::size_t size;
};

// The stream in an Any begins at a multiple of 8, as the bytes of a Plan do.
void insert(CORBA::Any& any, CORBA::TypeCode_ptr type, Bytes bytes) {
    any.PR_insert(
        type,
        [](cdrStream& stream, void* all) {
            const auto* const written = static_cast<const Bytes*>(all);
            stream.put_octet_array(written->data, static_cast<int>(written->size), omni::ALIGN_8);
        },
        &bytes);
}

/** Any bytes of the right number are a value of these. */
bool isNumber(CORBA::TCKind kind) {
    switch (kind) {
        case CORBA::tk_short:
        case CORBA::tk_ushort:
        case CORBA::tk_long:
        case CORBA::tk_ulong:
        case CORBA::tk_longlong:
        case CORBA::tk_ulonglong:
        case CORBA::tk_float:
        case CORBA::tk_double: return true;
        default: return false;
    }
}

}  // namespace

std::shared_ptr<const AnyCodec> AnyCodec::make(const types::TypeInfo& type, CORBA::ORB_ptr orb, std::string& why) {
    auto plan = encoding::Plan::make(type, encoding::corbaRules(), why);
    if (!plan) return nullptr;
    CORBA::TypeCode_var typeCode = typeCodeOf(type, orb, why);
    if (CORBA::is_nil(typeCode)) return nullptr;
    return std::shared_ptr<const AnyCodec>(new AnyCodec(std::move(plan), typeCode));
}

AnyCodec::AnyCodec(std::shared_ptr<const encoding::Plan> plan, CORBA::TypeCode_var typeCode)
    : plan_(std::move(plan)),
      typeCode_(typeCode),
      fixedSize_(plan_->fixedSize()),
      isNumber_(detail::isNumber(typeCode_->kind())) {}

bool AnyCodec::put(const void* value, CORBA::Any& any) const {
    const std::size_t size = fixedSize_ ? fixedSize_ : plan_->sizeOf(value);
    CORBA::Octet few[128];
    std::vector<CORBA::Octet> many(size > sizeof few ? size : 0);
    CORBA::Octet* const bytes = many.empty() ? few : many.data();
    if (size == 0 || plan_->encode(value, bytes, size) != size) return false;
    insert(any, typeCode_.in(), {bytes, size});
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
