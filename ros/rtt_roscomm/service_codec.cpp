// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/service_codec.hpp>

#include <rtt/encoding/Plan.hpp>
#include <rtt/types/TypeOps.hpp>
#include <rtt/types/Types.hpp>
#include <rtt_roscomm/detail/empty_struct.hpp>

#include <boost/core/demangle.hpp>

#include <stdexcept>
#include <utility>

namespace rtt_roscomm {

namespace {

using RTT::encoding::Plan;
typedef RTT::base::DataSourceBase::shared_ptr Source;

class PlanCodec final : public MessageCodec {
public:
    PlanCodec(const RTT::types::TypeInfo& info, std::shared_ptr<const Plan> plan, Source blank)
        : info_(info),
          plan_(std::move(plan)),
          blank_(std::move(blank)),
          is_empty_(detail::isEmptyStruct(info)) {}

    const std::type_info& type() const override { return *info_.getTypeId(); }
    const RTT::types::TypeInfo* info() const override { return &info_; }
    Source makeVariable() const override { return info_.buildValue(); }
    void clear(void* value) const override { info_.getOps()->assign(value, blank_->getRawConstPointer()); }

    std::size_t size(const void* value) const override {
        if (is_empty_) return 0;
        const std::size_t bytes = plan_->sizeOf(value);
        if (bytes == 0) throw std::runtime_error("a value of type " + typeName() + " cannot be encoded");
        return bytes;
    }
    void encode(const void* value, std::uint8_t* to, std::size_t room) const override {
        if (!is_empty_ && plan_->encode(value, to, room) != room)
            throw std::runtime_error("a value of type " + typeName() + " was changed while it was encoded");
    }
    void decode(const std::uint8_t* from, std::size_t size, void* value) const override {
        if (const auto error = plan_->decode(from, size, RTT::encoding::ByteOrder::Little, value))
            throw std::runtime_error("the bytes are no " + typeName() + ": " + error.text());
    }

private:
    const RTT::types::TypeInfo& info_;
    const std::shared_ptr<const Plan> plan_;
    const Source blank_;
    const bool is_empty_;
};

}  // namespace

MessageCodec::~MessageCodec() = default;

std::string MessageCodec::typeName() const {
    return info() ? info()->getTypeName() : boost::core::demangle(type().name());
}

Codec registeredCodec(const std::string& type, std::string& why) {
    const RTT::types::TypeInfo* const info = RTT::types::Types()->type(type);
    if (!info) {
        why = "type '" + type + "' is in no typekit that is loaded";
        return nullptr;
    }
    std::shared_ptr<const Plan> plan = Plan::make(*info, RTT::encoding::ros1Rules(), why);
    if (!plan) return nullptr;
    Source blank = info->buildValue();
    if (!blank || !blank->getRawConstPointer() || !info->getOps() || !info->getTypeId()) {
        why = "type '" + type + "' has no variables";
        return nullptr;
    }
    return std::make_shared<PlanCodec>(*info, std::move(plan), std::move(blank));
}

}  // namespace rtt_roscomm
