// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/encoding/Stamp.hpp>

#include <rtt/encoding/Rules.hpp>
#include <rtt/encoding/detail/form.hpp>
#include <rtt/encoding/detail/form_builder.hpp>

#include <algorithm>
#include <cstring>
#include <string_view>
#include <vector>

namespace RTT::encoding {

using detail::Form;
using detail::FormField;
using types::Shape;

namespace {

constexpr std::size_t kDeepest = 8;

bool isMarked(const FormField& field) {
    constexpr std::string_view kWord = "@stamp";
    const std::string_view doc = field.doc;
    for (std::size_t at = doc.find(kWord); at != doc.npos; at = doc.find(kWord, at + 1)) {
        const auto isBlank = [&](std::size_t place) { return static_cast<unsigned char>(doc[place]) <= ' '; };
        const std::size_t end = at + kWord.size();
        if ((at == 0 || isBlank(at - 1)) && (end == doc.size() || isBlank(end))) return true;
    }
    return false;
}

bool isInteger(const Form& form) {
    if (form.shape.kind != Shape::Kind::Number) return false;
    switch (form.shape.number) {
        case Shape::Number::Int32:
        case Shape::Number::UInt32:
        case Shape::Number::Int64:
        case Shape::Number::UInt64: return true;
        default: return false;
    }
}

bool isOneOf(const std::string& name, std::initializer_list<const char*> names) {
    return std::any_of(names.begin(), names.end(), [&](const char* one) { return name == one; });
}

}  // namespace

class StampFinder {
public:
    explicit StampFinder(Stamp& stamp) : stamp_(stamp) {}

    /** The marked field, and in `offset` where it is; null if there is none. */
    const FormField* find(const Form& form, std::size_t& offset, std::size_t depth) {
        if (form.shape.kind != Shape::Kind::Struct || depth == kDeepest) return nullptr;
        for (const FormField& field : form.fields) {
            std::size_t within = offset + field.offset;
            const FormField* found = &field;
            // What is in a list or has no address is no part of memory that has a place.
            if (!isMarked(field))
                found = field.access || field.count != 0 ? nullptr : find(*field.form, within, depth + 1);
            if (!found) continue;
            offset = within;
            return found;
        }
        return nullptr;
    }

    bool take(const FormField& field, std::size_t offset) {
        if (field.access || field.count != 0) return false;
        const Form& form = *field.form;
        if (isInteger(form) && form.size() == sizeof(std::int64_t)) {
            stamp_.nanoseconds_ = part(form, offset);
            return true;
        }
        if (form.shape.kind != Shape::Kind::Struct) return false;
        for (const FormField& one : form.fields) {
            if (one.access || one.count != 0 || !isInteger(*one.form)) continue;
            if (isOneOf(one.name, {"sec", "secs", "seconds", "tv_sec"}))
                stamp_.seconds_ = part(*one.form, offset + one.offset);
            if (isOneOf(one.name, {"nanosec", "nsec", "nsecs", "nanoseconds", "tv_nsec"}))
                stamp_.nanoseconds_ = part(*one.form, offset + one.offset);
        }
        return stamp_.seconds_.size != 0 && stamp_.nanoseconds_.size != 0;
    }

private:
    static Stamp::Part part(const Form& form, std::size_t offset) {
        const Shape::Number number = form.shape.number;
        const bool isUnsigned = number == Shape::Number::UInt32 || number == Shape::Number::UInt64;
        return {offset, static_cast<std::uint8_t>(form.size()), isUnsigned};
    }

    Stamp& stamp_;
};

std::unique_ptr<const Stamp> Stamp::make(const types::TypeInfo& type, std::string& why) {
    why.clear();
    std::string other;
    const auto form = detail::buildForm(type, cdrRules(), detail::ReadOnly::Kept, other);
    if (!form) return nullptr;
    auto stamp = std::make_unique<Stamp>();
    StampFinder finder(*stamp);
    std::size_t offset = 0;
    const FormField* const field = finder.find(*form, offset, 0);
    if (!field) return nullptr;
    if (finder.take(*field, offset)) return stamp;
    why = "its field '" + field->name +
          "' is marked @stamp, but is neither an integer of 64 bits nor a struct with seconds and nanoseconds";
    return nullptr;
}

std::int64_t Stamp::numberAt(const Part& part, const void* value) const {
    const void* const at = static_cast<const unsigned char*>(value) + part.offset;
    if (part.size == sizeof(std::int64_t)) {
        std::int64_t number = 0;
        std::memcpy(&number, at, sizeof number);
        return number;
    }
    std::uint32_t bits = 0;
    if (part.size != 0) std::memcpy(&bits, at, sizeof bits);
    return part.isUnsigned ? static_cast<std::int64_t>(bits) : static_cast<std::int32_t>(bits);
}

std::uint64_t Stamp::read(const void* value) const {
    constexpr std::uint64_t kSecond = 1000000000, kMost = ~std::uint64_t(0) / kSecond - 1;
    const std::int64_t seconds = numberAt(seconds_, value), nanoseconds = numberAt(nanoseconds_, value);
    if (seconds_.size == 0 && nanoseconds_.isUnsigned) return static_cast<std::uint64_t>(nanoseconds);
    if (seconds < 0 || nanoseconds < 0) return 0;
    const auto many = static_cast<std::uint64_t>(seconds), few = static_cast<std::uint64_t>(nanoseconds);
    if (seconds_.size == 0) return few;
    return many > kMost || few > kSecond ? 0 : many * kSecond + few;
}

}  // namespace RTT::encoding
