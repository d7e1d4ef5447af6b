// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Writes values, or counts their bytes.
#ifndef ORO_ENCODING_DETAIL_ENCODER_HPP
#define ORO_ENCODING_DETAIL_ENCODER_HPP

#include <rtt/encoding/Rules.hpp>
#include <rtt/encoding/detail/form.hpp>
#include <rtt/encoding/detail/walk.hpp>
#include <rtt/types/ShownTable.hpp>
#include <rtt/types/StructTable.hpp>
#include <rtt/types/VariantTable.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace RTT {
namespace encoding {
namespace detail {

/** Counts bytes. */
class ByteCount {
public:
    std::size_t position() const { return position_; }
    bool align(std::size_t to) {
        position_ = (position_ + to - 1) / to * to;
        return true;
    }
    bool bytes(const void*, std::size_t count) {
        position_ += count;
        return true;
    }

private:
    std::size_t position_ = 0;
};

/** Writes bytes into a buffer. Its functions return false if that has no room left. */
class ByteWriter {
public:
    ByteWriter(void* to, std::size_t room) : to_(static_cast<unsigned char*>(to)), room_(room) {}

    std::size_t position() const { return position_; }
    bool align(std::size_t to) {
        const std::size_t gap = (0 - position_) & (to - 1);
        if (gap == 0) return true;
        if (gap > room_ - position_) return false;
        std::memset(to_ + position_, 0, gap);
        position_ += gap;
        return true;
    }
    bool bytes(const void* from, std::size_t count) {
        if (count > room_ - position_) return false;
        if (count != 0) std::memcpy(to_ + position_, from, count);
        position_ += count;
        return true;
    }

private:
    unsigned char* const to_;
    const std::size_t room_;
    std::size_t position_ = 0;
};

/** Its functions return false if the value cannot be encoded, or `out` has no room. */
template <class Out>
class Encoder {
public:
    Encoder(Out& out, const Rules& rules) : out_(out), rules_(rules) {}

    bool put(const Form& form, const void* value) {
        if (form.isSolid && out_.position() % form.align == 0) return out_.bytes(value, form.size());
        switch (form.shape.kind) {
            case types::Shape::Kind::Number: return putNumbers(value, 1, form.size());
            case types::Shape::Kind::Enumeration: return putEnumerator(form, value);
            case types::Shape::Kind::Text: return putText(form.shape.text->get(value));
            case types::Shape::Kind::Struct: return putStruct(form, value);
            case types::Shape::Kind::Sequence: return putSequence(form, value);
            case types::Shape::Kind::Variant: return putVariant(form, value);
            case types::Shape::Kind::Shown: return putShown(form, value);
            case types::Shape::Kind::None: break;
        }
        return false;
    }

private:
    bool putNumbers(const void* first, std::size_t count, std::size_t size) {
        return out_.align(rules_.alignmentOf(size)) && out_.bytes(first, count * size);
    }
    bool putCount(std::size_t count) {
        const auto number = static_cast<std::uint32_t>(count);
        return number == count && putNumbers(&number, 1, sizeof number);
    }
    bool putEnumerator(const Form& form, const void* value) {
        if (form.isSolid) return putNumbers(value, 1, form.size());
        const std::vector<long long>& all = form.byRank;
        const auto found = std::find(all.begin(), all.end(), form.shape.numbers->get(value));
        const auto rank = static_cast<std::uint32_t>(found - all.begin());
        return found != all.end() && putNumbers(&rank, 1, sizeof rank);
    }
    bool putText(std::string_view text) {
        if (rules_.textEndsAtZero) text = text.substr(0, text.find('\0'));
        if (!rules_.textEndsWithZero) return putCount(text.size()) && out_.bytes(text.data(), text.size());
        return putCount(text.size() + 1) && out_.bytes(text.data(), text.size()) && out_.bytes("", 1);
    }

    bool putStruct(const Form& form, const void* value) {
        const auto* const begin = static_cast<const unsigned char*>(value);
        for (const FormStep& step : form.steps)
            if (!(step.field ? putField(*step.field, begin) : putStep(step, begin))) return false;
        return !form.steps.empty() || !rules_.emptyStructHasByte || out_.bytes("", 1);
    }
    bool putStep(const FormStep& step, const unsigned char* begin) {
        if (out_.position() % step.align == 0) return out_.bytes(begin + step.offset, step.bytes);
        for (const FormNumbers& numbers : step.numbers)
            if (!putNumbers(begin + numbers.offset, numbers.count, numbers.size)) return false;
        return true;
    }
    bool putField(const FormField& field, const unsigned char* begin) {
        if (!field.access) return putMany(*field.form, begin + field.offset, field.count ? field.count : 1);
        if (field.access->at) return put(*field.form, field.access->at(const_cast<unsigned char*>(begin), 0));
        return putPart(*field.form, *field.access, begin, 0);
    }
    bool putPart(const Form& form, const types::SequenceOps& ops, const void* whole, std::size_t index) {
        const Temporary part(*form.shape.ops);
        ops.load(whole, index, part.at());
        return put(form, part.at());
    }
    bool putMany(const Form& form, const void* first, std::size_t count) {
        if (form.isSolid && form.numberSize != 0) return putNumbers(first, count, form.size());
        const auto* at = static_cast<const unsigned char*>(first);
        for (; count != 0; --count, at += form.size()) {
            if (form.isSolid && out_.position() % form.align == 0) return out_.bytes(at, count * form.size());
            if (!put(form, at)) return false;
        }
        return true;
    }

    bool putSequence(const Form& form, const void* value) {
        const Deeper deeper(depth_);
        const types::SequenceOps& ops = *form.shape.elements;
        const std::size_t count = ops.size(value);
        if (!deeper || !(ops.resize ? putCount(count) : count == form.fixedCount)) return false;
        if (count == 0) return true;
        if (ops.data) return putMany(*form.element, ops.data(const_cast<void*>(value)), count);
        if (ops.visit) return visitWhile(ops, value, [&](const void* element) { return put(*form.element, element); });
        for (std::size_t i = 0; i != count; ++i) {
            const bool isPut = ops.at ? put(*form.element, ops.at(const_cast<void*>(value), i))
                                      : putPart(*form.element, ops, value, i);
            if (!isPut) return false;
        }
        return true;
    }
    bool putVariant(const Form& form, const void* value) {
        const Deeper deeper(depth_);
        const types::VariantOps& ops = *form.shape.variant;
        const std::size_t index = ops.index(value);
        if (!deeper || index >= form.fields.size() || !putCount(index)) return false;
        const Form* const chosen = form.fields[index].form;
        return !chosen || put(*chosen, ops.elements.at(const_cast<void*>(value), index));
    }
    bool putShown(const Form& form, const void* value) {
        const Temporary shown(*form.shown->shape.ops);
        form.shape.shown->show(value, shown.at());
        return put(*form.shown, shown.at());
    }

    Out& out_;
    const Rules rules_;
    unsigned depth_ = 0;
};

}  // namespace detail
}  // namespace encoding
}  // namespace RTT

#endif
