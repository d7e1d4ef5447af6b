// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/message_format.hpp>

#include <rtt/encoding/Plan.hpp>
#include <rtt/types/Shape.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeInfoRepository.hpp>
#include <rtt_roscomm/detail/empty_struct.hpp>
#include <rtt_roscomm/message_table.hpp>

#include <cstdint>
#include <cstring>
#include <utility>

namespace rtt_roscomm {

namespace {

using RTT::encoding::ByteOrder;
using RTT::encoding::DecodeError;
using RTT::encoding::Plan;
using RTT::types::Shape;

bool beginsWithHeader(const Shape& shape) {
    if (shape.kind != Shape::Kind::Struct || shape.fields.empty() || shape.fields[0].name != "header") return false;
    const RTT::types::TypeInfo* const type = RTT::types::Types()->getTypeById(shape.fields[0].type);
    return type && type->getTypeName() == "/std_msgs/Header";
}

class ShapeFormat : public MessageFormat {
public:
    ShapeFormat(std::shared_ptr<const Plan> plan, const MessageEntry& entry, bool isEmpty, bool hasHeader)
        : plan_(std::move(plan)), entry_(entry), isEmpty_(isEmpty), hasHeader_(hasHeader) {}

    std::string message() const override { return entry_.message; }
    std::string md5() const override { return entry_.md5; }
    std::string definition() const override { return entry_.definition; }
    bool hasHeader() const override { return hasHeader_; }

    bool sizeOf(const void* sample, std::size_t& size) const override {
        size = plan_->sizeOf(sample);
        return size != 0 || isEmpty_;
    }
    bool write(const void* sample, void* to, std::size_t size) const override {
        return isEmpty_ || plan_->encode(sample, to, size) == size;
    }
    bool read(const void* from, std::size_t size, void* sample, std::string& why) const override {
        const DecodeError error = plan_->decode(from, size, ByteOrder::Little, sample);
        if (error) why = error.text();
        return !error;
    }

private:
    const std::shared_ptr<const Plan> plan_;
    const MessageEntry entry_;
    const bool isEmpty_, hasHeader_;
};

/** Numbers in a row as a MultiArray: its layout {dim[] {label, size, stride}, data_offset} in front. The layout of a
    received message is not looked at: which numbers it would leave out depends on more dimensions than one. */
class RowFormat final : public ShapeFormat {
public:
    RowFormat(std::shared_ptr<const Plan> plan, const MessageEntry& entry)
        : ShapeFormat(std::move(plan), entry, false, false) {}

    bool sizeOf(const void* sample, std::size_t& size) const override {
        const bool isFine = ShapeFormat::sizeOf(sample, size);
        size += kLayout;
        return isFine;
    }
    bool write(const void* sample, void* to, std::size_t size) const override {
        std::uint8_t* const at = static_cast<std::uint8_t*>(to);
        if (size < kLayout + sizeof(std::uint32_t) || !ShapeFormat::write(sample, at + kLayout, size - kLayout))
            return false;
        // One dimension without a label, of as many elements as follow, and no offset.
        std::uint32_t words[kLayout / 4] = {1, 0, 0, 0, 0};
        std::memcpy(&words[2], at + kLayout, sizeof(std::uint32_t));
        words[3] = words[2];
        std::memcpy(to, words, kLayout);
        return true;
    }
    bool read(const void* from, std::size_t size, void* sample, std::string& why) const override {
        const std::uint8_t* const at = static_cast<const std::uint8_t*>(from);
        std::size_t begin = 0;
        if (!skipLayout(at, size, begin)) {
            why = "its layout is longer than the message";
            return false;
        }
        return ShapeFormat::read(at + begin, size - begin, sample, why);
    }

private:
    static constexpr std::size_t kLayout = 20;
    static bool word(const std::uint8_t* from, std::size_t size, std::size_t& at, std::uint32_t& value) {
        if (size - at < sizeof value) return false;
        std::memcpy(&value, from + at, sizeof value);
        at += sizeof value;
        return true;
    }
    static bool skipLayout(const std::uint8_t* from, std::size_t size, std::size_t& at) {
        std::uint32_t dimensions = 0, value = 0;
        if (!word(from, size, at, dimensions)) return false;
        for (; dimensions != 0; --dimensions) {
            if (!word(from, size, at, value) || value > size - at) return false;
            at += value;  // the label
            if (!word(from, size, at, value) || !word(from, size, at, value)) return false;
        }
        return word(from, size, at, value);
    }
};

}  // namespace

std::shared_ptr<const MessageFormat> newMessageFormat(const RTT::types::TypeInfo& type, const MessageEntry& entry,
                                                      std::string& why) {
    std::shared_ptr<const Plan> plan = Plan::make(type, RTT::encoding::ros1Rules(), why);
    if (!plan) return nullptr;
    const Shape shape = type.shape();
    if (shape.kind == Shape::Kind::Sequence) return std::make_shared<RowFormat>(std::move(plan), entry);
    return std::make_shared<ShapeFormat>(std::move(plan), entry, detail::isEmptyStruct(type), beginsWithHeader(shape));
}

}  // namespace rtt_roscomm
