// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "frame_text.hpp"

#include "other_value.hpp"
#include "record.hpp"
#include "row_text.hpp"

#include <algorithm>
#include <utility>

namespace OCL::reporting {
namespace {

typedef std::vector<char> Text;

void append(Text& text, std::string_view more) { text.insert(text.end(), more.begin(), more.end()); }

bool isControl(char c) { return (static_cast<unsigned char>(c) < 0x20U && c != '\t') || c == '\x7f'; }

void appendControl(Text& text, char c) {
    constexpr char kDigits[] = "0123456789abcdef";
    if (c == '\n' || c == '\r') return append(text, c == '\n' ? "\\n" : "\\r");
    append(text, "\\x");
    text.push_back(kDigits[static_cast<unsigned char>(c) >> 4U]);
    text.push_back(kDigits[static_cast<unsigned char>(c) & 0xfU]);
}

void appendOneLine(Text& text, std::string_view value) {
    while (!value.empty()) {
        const auto* const control = std::find_if(value.begin(), value.end(), isControl);
        const std::size_t plain = static_cast<std::size_t>(control - value.begin());
        append(text, value.substr(0, plain));
        if (plain == value.size()) return;
        appendControl(text, value[plain]);
        value.remove_prefix(plain + 1);
    }
}

void appendName(Text& text, std::string_view name) {
    append(text, "202 ");
    appendOneLine(text, name);
    text.push_back('\n');
}

/** Writes values and their members. Members without a name get a number: elements from 0, others from 1. */
class Decoder {
public:
    Decoder(RecordReader& record, Text& text, int digits) : record_(record), text_(text), digits_(digits) {}

    /** Writes the next value after its name, with all members. */
    void value(const Field& field, std::string_view name) {
        appendName(text_, name);
        const Tag tag = record_.tag();
        switch (field.kind) {
            case Field::Kind::Value: return appendPlain(tag);
            case Field::Kind::Group: return members(field);
            case Field::Kind::Sequence: return elements(field.parts.front());
        }
    }

private:
    void members(const Field& group) {
        std::size_t number = 0;
        for (const Field& part : group.parts) {
            ++number;
            if (part.name.empty())
                value(part, std::to_string(number));
            else
                value(part, part.name);
        }
    }
    void elements(const Field& element) {
        const auto count = record_.value<std::uint32_t>();
        for (std::uint32_t i = 0; i != count; ++i) value(element, std::to_string(i));
    }
    void appendPlain(Tag tag) {
        append(text_, "205 ");
        if (tag == Tag::Text) {
            appendOneLine(text_, record_.text());
        } else if (tag == Tag::Char) {
            appendOneLine(text_, std::string_view(record_.bytes(1), 1));
        } else if (tag == Tag::Other) {
            const OtherValue* const other = record_.value<const OtherValue*>();
            appendOneLine(text_, other->text(record_.bytes(other->size())));
        } else {
            appendValue(text_, tag, record_, TextFormat::Columns, digits_);
        }
        text_.push_back('\n');
    }

    RecordReader& record_;
    Text& text_;
    const int digits_;
};

}  // namespace

std::string onOneLine(std::string_view text) {
    Text line;
    appendOneLine(line, text);
    return std::string(line.begin(), line.end());
}

FrameText::FrameText(Field report) : report_(std::move(report)), parts_(report_.parts.size()) {
    for (const Field& field : report_.parts) lines_.push_back(onOneLine(field.name));
}

void FrameText::decode(const char* record, std::size_t size, int digits) {
    RecordReader reader(record, size);
    Decoder decoder(reader, text_, digits);
    text_.clear();
    for (std::size_t i = 0; i != parts_.size(); ++i) {
        const std::size_t begin = text_.size();
        if (reader.next() == Tag::Absent)
            (void)reader.tag();
        else
            decoder.value(report_.parts[i], report_.parts[i].name);
        parts_[i] = {begin, text_.size() - begin};
    }
}

std::string_view FrameText::part(std::size_t name) const {
    return {text_.data() + parts_[name].begin, parts_[name].size};
}

}  // namespace OCL::reporting
