// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Messages as bytes, taken apart as their schema says.
#include "detail/limits.hpp"
#include "message_schema.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>

namespace oroforge::schema {
namespace {

class Walk {
public:
    Walk(const std::vector<Struct>& structs, const unsigned char* data, std::size_t size, bool isLittle,
         PartTaker& taker)
        : structs_(structs), data_(data), size_(size), isLittle_(isLittle), taker_(taker) {}

    bool all(const Struct& root, std::string& why) {
        const bool good = whole(root);
        if (good && size_ - at_ < 4) return true;  // some writers fill up the last word
        if (good) fail("there are " + std::to_string(size_ - at_) + " bytes more than the schema describes");
        why = "byte " + std::to_string(at_) + ": " + why_;
        return false;
    }

private:
    bool fail(const std::string& why) {
        why_ = why;
        return false;
    }

    bool whole(const Struct& one) {
        if (depth_ == kDeepest) return fail("structs nest too deeply");
        ++depth_;
        taker_.beginStruct();
        // ROS gives a struct without fields a byte. So each element has one, and no list outlasts the message.
        std::uint8_t filler = 0;
        if (one.hasByte && !take(filler)) return false;
        if (one.isUnion) {
            if (!chosen(one)) return false;
        } else {
            for (const Field& field : one.fields)
                if (!part(field)) return false;
        }
        taker_.endStruct();
        --depth_;
        return true;
    }

    bool chosen(const Struct& one) {
        std::int64_t label = 0;
        if (!takeLabel(one.discriminator, label)) return false;
        const Field* other = nullptr;
        for (const Field& field : one.fields) {
            if (std::find(field.labels.begin(), field.labels.end(), label) != field.labels.end()) return part(field);
            if (field.isDefault) other = &field;
        }
        return !other || part(*other);
    }

    bool takeLabel(Basic basic, std::int64_t& label) {
        switch (basic) {
            case Basic::Int8: return takeAs<std::uint8_t, std::int8_t>(label);
            case Basic::Int16: return takeAs<std::uint16_t, std::int16_t>(label);
            case Basic::Int32: return takeAs<std::uint32_t, std::int32_t>(label);
            case Basic::Bool:
            case Basic::UInt8: return takeAs<std::uint8_t, std::uint8_t>(label);
            case Basic::UInt16: return takeAs<std::uint16_t, std::uint16_t>(label);
            case Basic::UInt32: return takeAs<std::uint32_t, std::uint32_t>(label);
            default: return takeAs<std::uint64_t, std::int64_t>(label);
        }
    }

    template <class Bits, class Number>
    bool takeAs(std::int64_t& label) {
        Bits bits = 0;
        if (!take(bits)) return false;
        label = static_cast<Number>(bits);
        return true;
    }

    bool part(const Field& field) {
        taker_.field(field.name);
        return list(field, 0);
    }

    bool list(const Field& field, std::size_t level) {
        if (level == field.lists.size()) return value(field);
        std::size_t count = field.lists[level].count;
        if (field.lists[level].isSequence) {
            std::uint32_t given = 0;
            if (!take(given)) return false;
            count = given;
        }
        // Each element has a byte at least.
        if (count > size_ - at_)
            return fail("a list of " + std::to_string(count) + " elements is longer than the rest");
        taker_.beginList();
        for (std::size_t i = 0; i != count; ++i) {
            taker_.element(i);
            if (!list(field, level + 1)) return false;
        }
        taker_.endList();
        return true;
    }

    bool value(const Field& field) {
        switch (field.basic) {
            case Basic::Struct: return whole(structs_[field.structAt]);
            case Basic::Bool: {
                std::uint8_t byte = 0;
                if (!take(byte)) return false;
                taker_.typedNumber(field.basic, byte != 0 ? "true" : "false");
                return true;
            }
            case Basic::Int8: return number<std::int8_t, std::uint8_t>(field.basic);
            case Basic::UInt8: return number<std::uint8_t, std::uint8_t>(field.basic);
            case Basic::Int16: return number<std::int16_t, std::uint16_t>(field.basic);
            case Basic::UInt16: return number<std::uint16_t, std::uint16_t>(field.basic);
            case Basic::Int32: return number<std::int32_t, std::uint32_t>(field.basic);
            case Basic::UInt32: return number<std::uint32_t, std::uint32_t>(field.basic);
            case Basic::Int64: return number<std::int64_t, std::uint64_t>(field.basic);
            case Basic::UInt64: return number<std::uint64_t, std::uint64_t>(field.basic);
            case Basic::Float32: return number<float, std::uint32_t>(field.basic);
            case Basic::Float64: return number<double, std::uint64_t>(field.basic);
            case Basic::Text: return text();
            case Basic::WideText: return fail("texts of wide characters are not read");
        }
        return false;
    }

    /** Bits of a number, at a multiple of its size. */
    template <class Bits>
    bool take(Bits& bits) {
        const std::size_t begin = (at_ + sizeof bits - 1) / sizeof bits * sizeof bits;
        if (begin > size_ || size_ - begin < sizeof bits) return fail("the message ends within a field");
        unsigned char bytes[sizeof bits];
        std::copy_n(data_ + begin, sizeof bits, bytes);
        if (!isLittle_) std::reverse(std::begin(bytes), std::end(bytes));
        bits = 0;
        for (std::size_t i = sizeof bits; i-- > 0;) bits = static_cast<Bits>(std::uint64_t(bits) << 8U | bytes[i]);
        at_ = begin + sizeof bits;
        return true;
    }

    template <class Number, class Bits>
    bool number(Basic basic) {
        Bits bits = 0;
        if (!take(bits)) return false;
        Number number = 0;
        std::memcpy(&number, &bits, sizeof number);
        char text[32];
        const auto end = std::to_chars(std::begin(text), std::end(text), number).ptr;
        taker_.typedNumber(basic, {text, static_cast<std::size_t>(end - text)});
        return true;
    }

    bool text() {
        std::uint32_t size = 0;
        if (!take(size)) return false;
        if (size > size_ - at_) return fail("a text of " + std::to_string(size) + " bytes is longer than the rest");
        const char* const begin = reinterpret_cast<const char*>(data_ + at_);
        at_ += size;
        if (size != 0 && begin[size - 1] == '\0') --size;
        taker_.text({begin, size});
        return true;
    }

    const std::vector<Struct>& structs_;
    const unsigned char* const data_;
    const std::size_t size_;
    const bool isLittle_;
    PartTaker& taker_;
    std::size_t at_ = 0, depth_ = 0;
    std::string why_;
};

}  // namespace

bool MessageSchema::walk(const unsigned char* data, std::size_t size, PartTaker& taker, std::string& why) const {
    constexpr std::size_t kHead = 4;
    if (size < kHead || data[0] != 0 || data[1] > 1) {
        why = "byte 0: this is not plain CDR";
        return false;
    }
    // Places are counted from behind the head.
    return Walk(structs_, data + kHead, size - kHead, data[1] == 1, taker).all(root(), why);
}

}  // namespace oroforge::schema
