// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/encoding/detail/json_reader.hpp>

#include <rtt/encoding/detail/walk.hpp>
#include <rtt/types/ShownTable.hpp>
#include <rtt/types/StructTable.hpp>
#include <rtt/types/VariantTable.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace RTT::encoding::detail {

using types::Shape;

bool JsonReader::fail(const std::string& problem) {
    if (error_.empty()) error_ = path_.empty() ? problem : path_ + ": " + problem;
    return false;
}

bool JsonReader::expected(const char* what, const Json& found) {
    const std::string text =
        found.is_structured() ? found.type_name() : found.dump(-1, ' ', false, Json::error_handler_t::replace);
    return fail("found " + text + ", expected " + what);
}

/** Calls `get`, whose errors are those of a part of the value. */
template <class Get>
bool JsonReader::within(const std::string& part, Get get) {
    const std::size_t length = path_.size();
    path_ += path_.empty() && part[0] == '.' ? part.substr(1) : part;
    const bool isSet = get();
    path_.resize(length);
    return isSet;
}

template <class Get>
bool JsonReader::nested(Get get) {
    const Deeper deeper(depth_);
    return deeper ? get() : fail("the value nests too deeply");
}

bool JsonReader::get(const Form& form, const Json& from, void* value) {
    switch (form.shape.kind) {
        case Shape::Kind::Number: return getNumber(form.shape.number, from, value);
        case Shape::Kind::Enumeration: return getEnumerator(form, from, value);
        case Shape::Kind::Text: return getText(form, from, value);
        case Shape::Kind::Struct: return getStruct(form, from, value);
        case Shape::Kind::Sequence: return nested([&] { return getSequence(form, from, value); });
        case Shape::Kind::Variant: return nested([&] { return getVariant(form, from, value); });
        case Shape::Kind::Shown: return getShown(form, from, value);
        case Shape::Kind::None: break;
    }
    return fail("the type has no shape");
}

bool JsonReader::getNumber(Shape::Number number, const Json& from, void* value) {
    switch (number) {
        case Shape::Number::Bool: {
            if (!from.is_boolean()) return expected("true or false", from);
            const bool isTrue = from.get<bool>();
            std::memcpy(value, &isTrue, sizeof isTrue);
            return true;
        }
        case Shape::Number::Char: {
            if (!from.is_string()) return getWhole<char>(from, value);
            const std::string& letters = from.get_ref<const std::string&>();
            if (letters.size() != 1) return expected("a text of one letter, or a number", from);
            std::memcpy(value, letters.data(), 1);
            return true;
        }
        case Shape::Number::Int8: return getWhole<std::int8_t>(from, value);
        case Shape::Number::UInt8: return getWhole<std::uint8_t>(from, value);
        case Shape::Number::Int16: return getWhole<std::int16_t>(from, value);
        case Shape::Number::UInt16: return getWhole<std::uint16_t>(from, value);
        case Shape::Number::Int32: return getWhole<std::int32_t>(from, value);
        case Shape::Number::UInt32: return getWhole<std::uint32_t>(from, value);
        case Shape::Number::Int64: return getWhole<std::int64_t>(from, value);
        case Shape::Number::UInt64: return getWhole<std::uint64_t>(from, value);
        case Shape::Number::Float32: return getReal<float>(from, value);
        case Shape::Number::Float64: return getReal<double>(from, value);
    }
    return false;
}

template <class Whole>
bool JsonReader::getWhole(const Json& from, void* value) {
    if (!from.is_number_integer()) return expected("a whole number", from);
    typedef std::numeric_limits<Whole> Limits;
    bool fits = false;
    if (from.is_number_unsigned()) {
        fits = from.get<std::uint64_t>() <= static_cast<std::uint64_t>(Limits::max());
    } else {
        const auto number = from.get<std::int64_t>();
        fits = number >= (std::is_signed_v<Whole> ? static_cast<std::int64_t>(Limits::min()) : 0);
    }
    if (!fits)
        return expected(
            ("a number from " + std::to_string(Limits::min()) + " to " + std::to_string(Limits::max())).c_str(), from);
    const auto number = from.get<Whole>();
    std::memcpy(value, &number, sizeof number);
    return true;
}

template <class Real>
bool JsonReader::getReal(const Json& from, void* value) {
    typedef std::numeric_limits<Real> Limits;
    constexpr double most = static_cast<double>(Limits::max());
    Real number = 0;
    const double exact = from.is_number() ? from.get<double>() : 0;
    // The shortest text of the largest float, 3.4028235e+38, is a little more than it.
    if (std::abs(exact) > most && std::abs(exact) - most >= most * static_cast<double>(Limits::epsilon()) / 4)
        return expected("a number that is not so large", from);
    if (from.is_number())
        number = std::abs(exact) > most ? std::copysign(Limits::max(), static_cast<Real>(exact > 0 ? 1 : -1))
                                        : from.get<Real>();
    else if (from == "NaN")
        number = Limits::quiet_NaN();
    else if (from == "Infinity")
        number = Limits::infinity();
    else if (from == "-Infinity")
        number = -Limits::infinity();
    else
        return expected("a number", from);
    std::memcpy(value, &number, sizeof number);
    return true;
}

bool JsonReader::getEnumerator(const Form& form, const Json& from, void* value) {
    const types::EnumOps& ops = *form.shape.numbers;
    if (from.is_number_integer()) {
        const auto number =
            from.is_number_unsigned() ? static_cast<long long>(from.get<std::uint64_t>()) : from.get<long long>();
        ops.set(value, number);
        return ops.get(value) == number || expected("a number that the enumeration can have", from);
    }
    std::string names;
    for (const Shape::Enumerator& one : form.shape.enumerators) {
        if (from == one.name) {
            ops.set(value, one.value);
            return true;
        }
        names += (names.empty() ? "" : ", ") + one.name;
    }
    return expected(("one of: " + names).c_str(), from);
}

bool JsonReader::getText(const Form& form, const Json& from, void* value) {
    std::string letters;
    if (from.is_string()) {
        letters = from.get<std::string>();
    } else if (from.is_array()) {
        for (const Json& byte : from) {
            if (!byte.is_number_unsigned() || byte.get<std::uint64_t>() > 255) return expected("a byte", byte);
            letters += static_cast<char>(byte.get<unsigned char>());
        }
    } else {
        return expected("a text", from);
    }
    form.shape.text->set(value, letters.data(), letters.size());
    return true;
}

bool JsonReader::getStruct(const Form& form, const Json& from, void* value) {
    if (!from.is_object()) return expected("an object", from);
    for (const auto& [name, part] : from.items()) {
        const auto field = std::find_if(form.fields.begin(), form.fields.end(),
                                        [&name = name](const FormField& one) { return one.name == name; });
        if (field == form.fields.end()) return fail("there is no field '" + name + "'");
        if (!field->isReadOnly() && !within("." + name, [&, &part = part] { return getField(*field, part, value); }))
            return false;
    }
    return true;
}

bool JsonReader::getField(const FormField& field, const Json& from, void* value) {
    if (field.access && field.access->at) return get(*field.form, from, field.access->at(value, 0));
    if (field.access) return getPart(*field.form, *field.access, from, value, 0);
    void* const at = static_cast<unsigned char*>(value) + field.offset;
    return field.count == 0 ? get(*field.form, from, at) : getArray(field, from, at);
}

bool JsonReader::getArray(const FormField& field, const Json& from, void* first) {
    if (!from.is_array() || from.size() != field.count)
        return expected(("an array of " + std::to_string(field.count) + " elements").c_str(), from);
    for (std::size_t i = 0; i != field.count; ++i) {
        void* const at = static_cast<unsigned char*>(first) + i * field.form->size();
        if (!within("[" + std::to_string(i) + "]", [&] { return get(*field.form, from[i], at); })) return false;
    }
    return true;
}

bool JsonReader::getPart(const Form& form, const types::SequenceOps& ops, const Json& from, void* whole,
                         std::size_t index) {
    const Temporary part(*form.shape.ops);
    ops.load(whole, index, part.at());  // fields that the text lacks keep their values
    if (!get(form, from, part.at())) return false;
    ops.store(whole, index, part.at());
    return true;
}

bool JsonReader::getSequence(const Form& form, const Json& from, void* value) {
    const types::SequenceOps& ops = *form.shape.elements;
    if (!from.is_array()) return expected("an array", from);
    // The first row of a matrix decides how long all are.
    const bool isMatrix = form.hasRows && !from.empty();
    const auto isOther = [&](const Json& row) { return row.size() != from[0].size(); };
    if (isMatrix && std::any_of(from.begin(), from.end(), isOther)) return fail("the rows have different lengths");
    const auto refused = [&] {
        return fail("found " + std::to_string(from.size()) + " elements, which the container cannot have");
    };
    if (isMatrix && !ops.resize(value, 1) && ops.size(value) != from.size()) return refused();
    if (isMatrix && !within("[0]", [&] { return getElement(form, from[0], value, 0); })) return false;
    const bool fits = !ops.resize  ? from.size() == form.fixedCount
                      : ops.insert ? ops.resize(value, 0)
                                   : ops.resize(value, from.size()) && ops.size(value) == from.size();
    if (!fits) return refused();
    if (ops.at && ops.visit) return getLinked(form, from, value);
    for (std::size_t i = 0; i != from.size(); ++i)
        if (!within("[" + std::to_string(i) + "]", [&] { return getElement(form, from[i], value, i); })) return false;
    return true;
}

/** For a container in which an element is found by counting. */
bool JsonReader::getLinked(const Form& form, const Json& from, void* value) {
    std::size_t index = 0;
    return visitWhile(*form.shape.elements, value, [&](const void* element) {
        const Json& part = from[index];
        return within("[" + std::to_string(index++) + "]",
                      [&] { return get(*form.element, part, const_cast<void*>(element)); });
    });
}

bool JsonReader::getElement(const Form& form, const Json& from, void* value, std::size_t index) {
    const types::SequenceOps& ops = *form.shape.elements;
    if (!ops.insert)
        return ops.at ? get(*form.element, from, ops.at(value, index))
                      : getPart(*form.element, ops, from, value, index);
    const Temporary element(*form.element->shape.ops);
    if (!get(*form.element, from, element.at())) return false;
    ops.insert(value, element.at());
    return true;
}

bool JsonReader::getVariant(const Form& form, const Json& from, void* value) {
    const types::VariantOps& ops = *form.shape.variant;
    const auto name = from.is_object() ? from.find("alternative") : from.end();
    if (!from.is_object() || name == from.end()) return expected("an object with the field 'alternative'", from);
    std::size_t index = 0;
    while (index != form.fields.size() && *name != form.fields[index].name) ++index;
    if (index == form.fields.size()) return expected("the name of an alternative", *name);
    if (ops.index(value) != index) ops.choose(value, index);
    const Form* const chosen = form.fields[index].form;
    const auto its = from.find("value");
    if (!chosen || its == from.end()) return true;
    return within(".value", [&] { return get(*chosen, *its, ops.elements.at(value, index)); });
}

bool JsonReader::getShown(const Form& form, const Json& from, void* value) {
    const Temporary shown(*form.shown->shape.ops);
    if (!get(*form.shown, from, shown.at())) return false;
    return form.shape.shown->take(shown.at(), value) || fail("the type has no such value");
}

}  // namespace RTT::encoding::detail
