// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/encoding/detail/decoder.hpp>

#include <rtt/encoding/detail/walk.hpp>
#include <rtt/types/ShownTable.hpp>
#include <rtt/types/StructTable.hpp>
#include <rtt/types/VariantTable.hpp>

#include <algorithm>
#include <cstring>

namespace RTT::encoding::detail {

using types::Shape;

namespace {

constexpr const char* kTooDeep = "the value nests too deeply";
constexpr const char* kTooShort = "the bytes end within the value";

void reverseEach(unsigned char* at, std::size_t count, std::size_t size) {
    for (; count != 0; --count, at += size) std::reverse(at, at + size);
}

}  // namespace

bool Decoder::align(std::size_t to) {
    const std::size_t gap = (0 - position_) & (to - 1);
    if (gap > left()) return fail(kTooShort);
    position_ += gap;
    return true;
}

bool Decoder::bytes(void* to, std::size_t count) {
    if (count > left()) return fail(kTooShort);
    if (count != 0) std::memcpy(to, begin_ + position_, count);
    position_ += count;
    return true;
}

bool Decoder::getNumbers(void* first, std::size_t count, std::size_t size, bool areBools) {
    if (!align(rules_.alignmentOf(size))) return false;
    if (count > left() / size) return fail(kTooShort);
    if (areBools && std::any_of(begin_ + position_, begin_ + position_ + count, [](unsigned char b) { return b > 1; }))
        return fail("a bool is neither 0 nor 1");
    if (!bytes(first, count * size)) return false;
    if (swaps_ && size != 1) reverseEach(static_cast<unsigned char*>(first), count, size);
    return true;
}

bool Decoder::getCount(std::size_t& count) {
    std::uint32_t number = 0;
    if (!getNumbers(&number, 1, sizeof number, false)) return false;
    count = number;
    return true;
}

bool Decoder::get(const Form& form, void* value) {
    if (form.isSolid && isCopy(form.hasBool, form.align)) return bytes(value, form.size());
    switch (form.shape.kind) {
        case Shape::Kind::Number: return getNumbers(value, 1, form.size(), form.hasBool);
        case Shape::Kind::Enumeration: return getEnumerator(form, value);
        case Shape::Kind::Text: return getText(form, value);
        case Shape::Kind::Struct: return getStruct(form, value);
        case Shape::Kind::Sequence: return getSequence(form, value);
        case Shape::Kind::Variant: return getVariant(form, value);
        case Shape::Kind::Shown: return getShown(form, value);
        case Shape::Kind::None: break;
    }
    return fail("the type has no shape");
}

bool Decoder::getEnumerator(const Form& form, void* value) {
    if (form.isSolid) return getNumbers(value, 1, form.size(), form.hasBool);
    std::uint32_t rank = 0;
    if (!getNumbers(&rank, 1, sizeof rank, false)) return false;
    if (rank >= form.byRank.size()) return fail("an enumeration has fewer names");
    form.shape.numbers->set(value, form.byRank[rank]);
    return true;
}

bool Decoder::getText(const Form& form, void* value) {
    std::size_t size = 0;
    if (!getCount(size)) return false;
    if (size > left()) return fail("a text is longer than the bytes that are left");
    const auto* const letters = reinterpret_cast<const char*>(begin_ + position_);
    if (rules_.textEndsWithZero && (size == 0 || letters[size - 1] != '\0'))
        return fail("a text does not end with a zero byte");
    form.shape.text->set(value, letters, rules_.textEndsWithZero ? size - 1 : size);
    position_ += size;
    return true;
}

bool Decoder::getStruct(const Form& form, void* value) {
    auto* const begin = static_cast<unsigned char*>(value);
    for (const FormStep& step : form.steps)
        if (!(step.field ? getField(*step.field, begin) : getStep(step, begin))) return false;
    unsigned char nothing = 0;
    return !form.steps.empty() || !rules_.emptyStructHasByte || bytes(&nothing, 1);
}

bool Decoder::getStep(const FormStep& step, unsigned char* begin) {
    if (isCopy(step.hasBool, step.align)) return bytes(begin + step.offset, step.bytes);
    for (const FormNumbers& numbers : step.numbers)
        if (!getNumbers(begin + numbers.offset, numbers.count, numbers.size, numbers.isBool)) return false;
    return true;
}

bool Decoder::getField(const FormField& field, unsigned char* begin) {
    if (!field.access) return getMany(*field.form, begin + field.offset, field.count ? field.count : 1);
    if (field.access->at) return get(*field.form, field.access->at(begin, 0));
    return getPart(*field.form, *field.access, begin, 0);
}

bool Decoder::getPart(const Form& form, const types::SequenceOps& ops, void* whole, std::size_t index) {
    const Temporary part(*form.shape.ops);
    ops.load(whole, index, part.at());  // what does not travel stays as it is
    if (!get(form, part.at())) return false;
    ops.store(whole, index, part.at());
    return true;
}

bool Decoder::getMany(const Form& form, void* first, std::size_t count) {
    if (form.isSolid && form.numberSize != 0) return getNumbers(first, count, form.size(), form.hasBool);
    auto* at = static_cast<unsigned char*>(first);
    for (; count != 0; --count, at += form.size()) {
        if (form.isSolid && isCopy(form.hasBool, form.align)) return bytes(at, count * form.size());
        if (!get(form, at)) return false;
    }
    return true;
}

bool Decoder::getSequence(const Form& form, void* value) {
    const Deeper deeper(depth_);
    if (!deeper) return fail(kTooDeep);
    const types::SequenceOps& ops = *form.shape.elements;
    std::size_t count = form.fixedCount;
    if (!ops.resize) return getElements(form, value, count);
    if (!getCount(count)) return false;
    if (count > left() / form.element->least) return fail("a container has more elements than there are bytes for");
    if (ops.insert) return getInserted(form, value, count);
    if (form.hasRows) return getRows(form, value, count);
    if (!ops.resize(value, count)) return fail("a container cannot have so many elements");
    return getElements(form, value, count);
}

bool Decoder::getElements(const Form& form, void* value, std::size_t count) {
    const types::SequenceOps& ops = *form.shape.elements;
    if (count == 0) return true;
    if (ops.size(value) != count) return fail("a container does not have its number of elements");
    if (ops.data) return getMany(*form.element, ops.data(value), count);
    if (ops.at && ops.visit) return getLinked(form, value);
    for (std::size_t i = 0; i != count; ++i) {
        const bool isSet = ops.at ? get(*form.element, ops.at(value, i)) : getPart(*form.element, ops, value, i);
        if (!isSet) return false;
    }
    return true;
}

/** For a container in which an element is found by counting. */
bool Decoder::getLinked(const Form& form, void* value) {
    return visitWhile(*form.shape.elements, value,
                      [&](const void* element) { return get(*form.element, const_cast<void*>(element)); });
}

/** A matrix gets its size only when the bytes for all of its rows are known to be there. */
bool Decoder::getRows(const Form& form, void* value, std::size_t count) {
    const types::SequenceOps& ops = *form.shape.elements;
    const types::SequenceOps& numbers = *form.element->shape.elements;
    constexpr const char* kNoSuchSize = "a matrix cannot have this size";
    if (count == 0) return ops.resize(value, 0) || fail(kNoSuchSize);
    const Temporary row(*form.element->shape.ops);
    const std::size_t begin = position_;
    if (!get(*form.element, row.at())) return false;
    const std::size_t columns = numbers.size(row.at());
    // Each of the others has as many bytes, but for the padding: at most 3 before its count and 4 behind it.
    const std::size_t least = std::max<std::size_t>(form.element->least + 7, position_ - begin) - 7;
    if (count - 1 > left() / least) return fail("a matrix has more rows than there are bytes for");
    // A matrix may have a fixed number of rows.
    if (!ops.resize(value, 1) && ops.size(value) != count) return fail(kNoSuchSize);
    ops.store(value, 0, row.at());
    if (!ops.resize(value, count) || ops.size(value) != count) return fail(kNoSuchSize);
    ops.load(value, 0, row.at());
    if (numbers.size(row.at()) != columns) return fail(kNoSuchSize);
    for (std::size_t i = 1; i != count; ++i) {
        if (!get(*form.element, row.at())) return false;
        if (numbers.size(row.at()) != columns) return fail("the rows of a matrix have different lengths");
        ops.store(value, i, row.at());
    }
    return true;
}

bool Decoder::getInserted(const Form& form, void* value, std::size_t count) {
    const types::SequenceOps& ops = *form.shape.elements;
    if (!ops.resize(value, 0)) return fail("a container cannot be emptied");
    for (; count != 0; --count) {
        const Temporary element(*form.element->shape.ops);
        if (!get(*form.element, element.at())) return false;
        ops.insert(value, element.at());
    }
    return true;
}

bool Decoder::getVariant(const Form& form, void* value) {
    const Deeper deeper(depth_);
    if (!deeper) return fail(kTooDeep);
    std::size_t index = 0;
    if (!getCount(index)) return false;
    if (index >= form.fields.size()) return fail("a variant has no alternative of this number");
    const types::VariantOps& ops = *form.shape.variant;
    if (ops.index(value) != index) ops.choose(value, index);
    const Form* const chosen = form.fields[index].form;
    return !chosen || get(*chosen, ops.elements.at(value, index));
}

bool Decoder::getShown(const Form& form, void* value) {
    const Temporary shown(*form.shown->shape.ops);
    if (!get(*form.shown, shown.at())) return false;
    return form.shape.shown->take(shown.at(), value) || fail("the type has no such value");
}

}  // namespace RTT::encoding::detail
