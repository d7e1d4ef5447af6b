// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "transcoder.hpp"

#include "cdr_parts.hpp"
#include "type_difference.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace OCL::replay {
namespace {

using oroforge::schema::Basic;
using oroforge::schema::Field;
using oroforge::schema::MessageSchema;
using oroforge::schema::Struct;

constexpr unsigned kDeepest = 200;
constexpr std::size_t kLargest = std::size_t(1) << 30;

std::size_t sizeOf(Basic basic) {
    switch (basic) {
        case Basic::Bool:
        case Basic::Int8:
        case Basic::UInt8: return 1;
        case Basic::Int16:
        case Basic::UInt16: return 2;
        case Basic::Int32:
        case Basic::UInt32:
        case Basic::Float32: return 4;
        case Basic::Int64:
        case Basic::UInt64:
        case Basic::Float64: return 8;
        default: return 0;
    }
}

std::int64_t labelOf(Basic discriminator, const unsigned char* bytes) {
    const auto as = [bytes](auto number) {
        std::memcpy(&number, bytes, sizeof number);
        return static_cast<std::int64_t>(number);
    };
    switch (discriminator) {
        case Basic::Int8: return as(std::int8_t());
        case Basic::Int16: return as(std::int16_t());
        case Basic::Int32: return as(std::int32_t());
        case Basic::Int64: return as(std::int64_t());
        case Basic::UInt16: return as(std::uint16_t());
        case Basic::UInt32: return as(std::uint32_t());
        case Basic::UInt64: return as(std::uint64_t());
        default: return as(std::uint8_t());
    }
}

/** The alternative of a union; null if that label has none. */
const Field* chosenBy(const Struct& its, std::int64_t label) {
    const Field* other = nullptr;
    for (const Field& field : its.fields) {
        if (std::find(field.labels.begin(), field.labels.end(), label) != field.labels.end()) return &field;
        if (field.isDefault) other = &field;
    }
    return other;
}

/** Passes over parts. */
class Skip {
public:
    Skip(const MessageSchema& schema, CdrReader& from) : structs_(schema.structs()), from_(from) {}

    bool field(const Field& one, std::size_t level = 0) {
        const std::size_t size = sizeOf(one.basic);
        if (level == one.lists.size()) return size != 0 ? from_.numbers(1, size) : value(one);
        std::size_t count = one.lists[level].count;
        if (one.lists[level].isSequence) {
            std::uint32_t given = 0;
            if (!from_.count(given)) return false;
            count = given;
        }
        if (count > from_.left()) return from_.fail("the message ends within a list");
        if (level + 1 == one.lists.size() && size != 0) return from_.numbers(count, size);
        for (; count != 0; --count)
            if (!field(one, level + 1)) return false;
        return true;
    }

private:
    bool value(const Field& one) {
        if (one.basic == Basic::Struct) return whole(structs_[one.structAt]);
        std::uint32_t size = 0;
        if (one.basic == Basic::WideText) return from_.fail("texts of wide characters are not read");
        return from_.count(size) && from_.numbers(size, 1);
    }
    bool whole(const Struct& one) {
        if (depth_ == kDeepest) return from_.fail("structs nest too deeply");
        ++depth_;
        if (one.hasByte && !from_.numbers(1, 1)) return false;
        if (one.isUnion) {
            unsigned char bytes[8];
            if (!from_.numbers(1, sizeOf(one.discriminator), bytes)) return false;
            const Field* const chosen = chosenBy(one, labelOf(one.discriminator, bytes));
            if (chosen && !field(*chosen)) return false;
        } else {
            for (const Field& part : one.fields)
                if (!field(part)) return false;
        }
        --depth_;
        return true;
    }

    const std::vector<Struct>& structs_;
    CdrReader& from_;
    unsigned depth_ = 0;
};

/** Copies what both types have. */
class Convert {
public:
    Convert(const MessageSchema& was, const MessageSchema& is, const Transcoder::Defaults& defaults, CdrReader& from,
            CdrWriter& to)
        : was_(was), is_(is), defaults_(defaults), from_(from), to_(to) {}

    bool whole(const Struct& was, const Struct& is) {
        if (depth_ == kDeepest) return from_.fail("structs nest too deeply");
        ++depth_;
        if (was.hasByte && !from_.numbers(1, 1)) return false;
        if (is.hasByte) *to_.numbers(1, 1) = 0;
        const bool good = was.isUnion ? alternative(was, is) : fields(was, is);
        --depth_;
        return good;
    }

private:
    bool fields(const Struct& was, const Struct& is) {
        std::vector<std::size_t> places;
        places.reserve(was.fields.size());
        Skip skip(was_, from_);
        for (const Field& one : was.fields) {
            places.push_back(from_.at());
            if (!skip.field(one)) return false;
        }
        const std::size_t end = from_.at();
        for (const Field& one : is.fields) {
            const auto same = std::find_if(was.fields.begin(), was.fields.end(), [&](const Field& other) {
                return other.name == one.name && fits(other, one);
            });
            if (same == was.fields.end()) {
                if (!addDefault(is, one)) return false;
                continue;
            }
            from_.moveTo(places[static_cast<std::size_t>(same - was.fields.begin())]);
            if (!field(*same, one, 0)) return false;
        }
        from_.moveTo(end);
        return true;
    }

    bool fits(const Field& was, const Field& is) const {
        if (!isSameKind(was, is) || is.basic == Basic::WideText) return false;
        if (is.basic != Basic::Struct) return true;
        const Struct &before = was_.structs()[was.structAt], &now = is_.structs()[is.structAt];
        return before.isUnion == now.isUnion && (!now.isUnion || before.discriminator == now.discriminator);
    }

    bool addDefault(const Struct& its, const Field& missing) {
        // Elements of a byte each may become large ones.
        if (to_.size() > kLargest) return from_.fail("the message becomes too large");
        const auto found = defaults_.find(its.name);
        if (found == defaults_.end()) return from_.fail("'" + its.name + "' has no default value");
        CdrReader reader(found->second.data(), found->second.size(), false);
        Skip skip(is_, reader);
        if (its.hasByte && !reader.numbers(1, 1)) return false;
        for (const Field& one : its.fields) {
            if (&one == &missing) {
                if (Convert(is_, is_, defaults_, reader, to_).field(one, one, 0)) return true;
                break;
            }
            if (!skip.field(one)) break;
        }
        return from_.fail("'" + its.name + "' has no default value");
    }

    bool alternative(const Struct& was, const Struct& is) {
        const std::size_t size = sizeOf(was.discriminator);
        unsigned char bytes[8];
        if (!from_.numbers(1, size, bytes)) return false;
        std::memcpy(to_.numbers(1, size), bytes, size);
        const std::int64_t label = labelOf(was.discriminator, bytes);
        const Field *const before = chosenBy(was, label), *const now = chosenBy(is, label);
        if (!before && !now) return true;
        if (!before || !now || !fits(*before, *now) || before->name != now->name)
            return from_.fail("the loaded type does not have this alternative" +
                              (before ? " '" + before->name + "'" : std::string()));
        return field(*before, *now, 0);
    }

    bool field(const Field& was, const Field& is, std::size_t level) {
        const std::size_t size = sizeOf(is.basic);
        if (level == is.lists.size()) {
            if (size != 0) return from_.numbers(1, size, to_.numbers(1, size));
            if (is.basic == Basic::Struct) return whole(was_.structs()[was.structAt], is_.structs()[is.structAt]);
            return list(1);
        }
        std::size_t count = is.lists[level].count;
        if (is.lists[level].isSequence) {
            if (level + 1 == is.lists.size() && size != 0) return list(size);
            std::uint32_t given = 0;
            if (!from_.count(given)) return false;
            to_.count(given);
            count = given;
        }
        if (count > from_.left()) return from_.fail("the message ends within a list");
        for (; count != 0; --count)
            if (!field(was, is, level + 1)) return false;
        return true;
    }

    /** A text, or a sequence of numbers. */
    bool list(std::size_t size) {
        std::uint32_t count = 0;
        if (!from_.count(count)) return false;
        if (count > from_.left() / size) return from_.fail("the message ends within a list");
        to_.count(count);
        return from_.numbers(count, size, to_.numbers(count, size));
    }

    const MessageSchema& was_;
    const MessageSchema& is_;
    const Transcoder::Defaults& defaults_;
    CdrReader& from_;
    CdrWriter& to_;
    unsigned depth_ = 0;
};

}  // namespace

bool Transcoder::convert(const unsigned char* data, std::size_t size, bool swaps, std::vector<unsigned char>& to,
                         std::string& why) const {
    to.clear();
    CdrReader from(data, size, swaps);
    CdrWriter writer(to);
    if (!Convert(recorded_, loaded_, defaults_, from, writer).whole(recorded_.root(), loaded_.root())) {
        why = from.problem();
        return false;
    }
    constexpr std::size_t kPadding = 4;  // some writers fill up the last word
    if (from.left() < kPadding) return true;
    why = "there are " + std::to_string(from.left()) + " bytes more than its type has";
    return false;
}

}  // namespace OCL::replay
