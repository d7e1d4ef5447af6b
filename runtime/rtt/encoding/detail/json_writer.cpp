// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/encoding/detail/json_writer.hpp>

#include <rtt/encoding/detail/walk.hpp>
#include <rtt/types/ShownTable.hpp>
#include <rtt/types/StructTable.hpp>
#include <rtt/types/VariantTable.hpp>

#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace RTT::encoding::detail {

using types::Shape;

namespace {

template <class T>
T numberAt(const void* at) {
    T number;
    std::memcpy(&number, at, sizeof number);
    return number;
}

/** The shortest text that gives this number again. */
template <class T>
std::string digits(T number) {
    char text[64];
    return std::string(text, std::to_chars(text, text + sizeof text, number).ptr);
}

}  // namespace

void JsonWriter::put(const Form& form, const void* value) {
    switch (form.shape.kind) {
        case Shape::Kind::Number: putNumber(form.shape.number, value); break;
        case Shape::Kind::Enumeration: putEnumerator(form, value); break;
        case Shape::Kind::Text: putText(form.shape.text->get(value)); break;
        case Shape::Kind::Struct: putStruct(form, value); break;
        case Shape::Kind::Sequence: putNested([&] { putSequence(form, value); }); break;
        case Shape::Kind::Variant: putNested([&] { putVariant(form, value); }); break;
        case Shape::Kind::Shown: {
            const Temporary shown(*form.shown->shape.ops);
            form.shape.shown->show(value, shown.at());
            put(*form.shown, shown.at());
            break;
        }
        case Shape::Kind::None: out_ += "null"; break;
    }
}

template <class Put>
void JsonWriter::putNested(Put put) {
    if (const Deeper deeper(depth_); deeper)
        put();
    else
        out_ += "null";
}

void JsonWriter::putNumber(Shape::Number number, const void* value) {
    switch (number) {
        case Shape::Number::Bool: out_ += numberAt<std::uint8_t>(value) != 0 ? "true" : "false"; break;
        case Shape::Number::Char: putChar(numberAt<char>(value)); break;
        case Shape::Number::Int8: out_ += digits<int>(numberAt<std::int8_t>(value)); break;
        case Shape::Number::UInt8: out_ += digits<unsigned>(numberAt<std::uint8_t>(value)); break;
        case Shape::Number::Int16: out_ += digits(numberAt<std::int16_t>(value)); break;
        case Shape::Number::UInt16: out_ += digits(numberAt<std::uint16_t>(value)); break;
        case Shape::Number::Int32: out_ += digits(numberAt<std::int32_t>(value)); break;
        case Shape::Number::UInt32: out_ += digits(numberAt<std::uint32_t>(value)); break;
        case Shape::Number::Int64: out_ += digits(numberAt<std::int64_t>(value)); break;
        case Shape::Number::UInt64: out_ += digits(numberAt<std::uint64_t>(value)); break;
        case Shape::Number::Float32: putReal(numberAt<float>(value)); break;
        case Shape::Number::Float64: putReal(numberAt<double>(value)); break;
    }
}

template <class Real>
void JsonWriter::putReal(Real number) {
    if (std::isnan(number))
        out_ += "\"NaN\"";
    else if (std::isinf(number))
        out_ += number > 0 ? "\"Infinity\"" : "\"-Infinity\"";
    else if (number == 0)
        out_ += std::signbit(number) ? "-0.0" : "0";
    else if (static_cast<Real>(std::strtod(digits(number).c_str(), nullptr)) == number)
        out_ += digits(number);
    else
        out_ += digits<double>(number);  // for readers that round to double first
}

void JsonWriter::putChar(char letter) {
    if (letter >= ' ' && letter <= '~')
        putQuoted(std::string_view(&letter, 1));
    else
        out_ += digits<int>(letter);
}

void JsonWriter::putText(std::string_view text) {
    try {
        putQuoted(text);
    } catch (const nlohmann::json::exception&) {  // it is not UTF-8
        const char* separator = "[";
        for (const char letter : text) {
            out_ += separator + digits<unsigned>(static_cast<unsigned char>(letter));
            separator = ",";
        }
        out_ += ']';
    }
}

void JsonWriter::putQuoted(std::string_view text) { out_ += nlohmann::json(text).dump(); }

void JsonWriter::putEnumerator(const Form& form, const void* value) {
    const long long number = form.shape.numbers->get(value);
    for (const Shape::Enumerator& one : form.shape.enumerators)
        if (one.value == number) return putQuoted(one.name);
    out_ += form.shape.numbers->isUnsigned ? digits(static_cast<unsigned long long>(number)) : digits(number);
}

void JsonWriter::putStruct(const Form& form, const void* value) {
    const char* separator = "{";
    for (const FormField& field : form.fields) {
        out_ += separator;
        putQuoted(field.name);
        out_ += ':';
        putField(field, value);
        separator = ",";
    }
    out_ += form.fields.empty() ? "{}" : "}";
}

void JsonWriter::putField(const FormField& field, const void* value) {
    if (field.access && field.access->at) return put(*field.form, field.access->at(const_cast<void*>(value), 0));
    if (field.access) return putPart(*field.form, *field.access, value, 0);
    const auto* at = static_cast<const unsigned char*>(value) + field.offset;
    if (field.count == 0) return put(*field.form, at);
    for (std::size_t i = 0; i != field.count; ++i, at += field.form->size()) {
        out_ += i == 0 ? '[' : ',';
        put(*field.form, at);
    }
    out_ += ']';
}

void JsonWriter::putPart(const Form& form, const types::SequenceOps& ops, const void* whole, std::size_t index) {
    const Temporary part(*form.shape.ops);
    ops.load(whole, index, part.at());
    put(form, part.at());
}

void JsonWriter::putSequence(const Form& form, const void* value) {
    const types::SequenceOps& ops = *form.shape.elements;
    bool isFirst = true;
    const auto separate = [&] {
        if (!isFirst) out_ += ',';
        isFirst = false;
    };
    out_ += '[';
    if (ops.visit) {
        visitWhile(ops, value, [&](const void* element) {
            separate();
            put(*form.element, element);
            return true;
        });
    } else {
        for (std::size_t i = 0, count = ops.size(value); i != count; ++i) {
            separate();
            if (ops.at)
                put(*form.element, ops.at(const_cast<void*>(value), i));
            else
                putPart(*form.element, ops, value, i);
        }
    }
    out_ += ']';
}

void JsonWriter::putVariant(const Form& form, const void* value) {
    const types::VariantOps& ops = *form.shape.variant;
    const std::size_t index = ops.index(value);
    if (index >= form.fields.size()) {
        out_ += "null";
        return;
    }
    out_ += "{\"alternative\":";
    putQuoted(form.fields[index].name);
    if (const Form* const chosen = form.fields[index].form) {
        out_ += ",\"value\":";
        put(*chosen, ops.elements.at(const_cast<void*>(value), index));
    }
    out_ += '}';
}

}  // namespace RTT::encoding::detail
