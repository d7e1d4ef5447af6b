// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/encoding/Plan.hpp>

#include <rtt/encoding/detail/decoder.hpp>
#include <rtt/encoding/detail/encoder.hpp>
#include <rtt/encoding/detail/fingerprint.hpp>
#include <rtt/encoding/detail/form_builder.hpp>

#include <exception>
#include <utility>

namespace RTT::encoding {

std::string DecodeError::text() const { return problem ? "byte " + std::to_string(offset) + ": " + problem : ""; }

std::shared_ptr<const Plan> Plan::make(const types::TypeInfo& type, const Rules& rules, std::string& why) {
    std::shared_ptr<const detail::Form> form = detail::buildForm(type, rules, detail::ReadOnly::LeftOut, why);
    return form ? std::shared_ptr<const Plan>(new Plan(std::move(form), rules)) : nullptr;
}

Plan::Plan(std::shared_ptr<const detail::Form> form, const Rules& rules)
    : form_(std::move(form)), rules_(rules), fingerprint_(detail::fingerprintOf(*form_)) {}
Plan::~Plan() = default;

std::size_t Plan::sizeOf(const void* value) const {
    detail::ByteCount count;
    return isPut(count, value) ? count.position() : 0;
}

std::size_t Plan::encode(const void* value, void* to, std::size_t room) const {
    detail::ByteWriter writer(to, room);
    return isPut(writer, value) ? writer.position() : 0;
}

template <class Out>
bool Plan::isPut(Out& out, const void* value) const {
    try {
        return detail::Encoder<Out>(out, rules_).put(*form_, value);
    } catch (const std::exception&) {  // a function of the type, or of a container that it returns
        return false;
    }
}

DecodeError Plan::decode(const void* from, std::size_t size, ByteOrder order, void* value) const {
    detail::Decoder decoder(from, size, order != kNativeOrder, rules_);
    try {
        if (decoder.get(*form_, value)) (void)decoder.end();
    } catch (const std::exception&) {  // a container has no memory, or a function of the type does not take the value
        (void)decoder.fail("the type refuses the value with an exception");
    }
    return decoder.error();
}

std::size_t Plan::fixedSize() const {
    if (!form_->hasFixedSize || !form_->shape.ops->construct) return 0;
    const detail::Temporary value(*form_->shape.ops);
    return sizeOf(value.at());
}

}  // namespace RTT::encoding
