// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "frame_text.hpp"

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

/** Writes a value and its members. Members without a name get a number: elements from 0, others from 1. */
class Decoder {
public:
    Decoder(RecordReader& record, Text& text, Text& value, int digits)
        : record_(record), text_(text), value_(value), digits_(digits) {}

    /** Writes the value after its name, with all members. */
    void all() {
        for (std::size_t depth = step(0); depth != 0;) depth = step(depth);
    }

private:
    /** Decodes one value; returns how many bags are open after it. */
    std::size_t step(std::size_t depth) {
        Tag tag = record_.tag();
        if (tag == Tag::End) {
            members_.pop_back();
            return depth - 1;
        }
        if (depth != 0) nameOf(tag);
        if (tag == Tag::Bag) {
            members_.push_back(0);
            return depth + 1;
        }
        append(text_, "205 ");
        appendPlain(tag);
        text_.push_back('\n');
        return depth;
    }
    /** Writes the name of a member, and goes on to the tag of its value. */
    void nameOf(Tag& tag) {
        const std::size_t number = members_.back()++;
        if (tag != Tag::Name) return appendName(text_, std::to_string(number));
        const std::string_view name = record_.text();
        appendName(text_, name.empty() ? std::string_view(std::to_string(number + 1)) : name);
        tag = record_.tag();
    }
    void appendPlain(Tag tag) {
        if (tag == Tag::Text) return appendOneLine(text_, record_.text());
        if (tag != Tag::Char && tag != Tag::Other) return appendValue(text_, tag, record_, digits_);
        value_.clear();
        appendValue(value_, tag, record_, digits_);
        appendOneLine(text_, std::string_view(value_.data(), value_.size()));
    }

    RecordReader& record_;
    Text& text_;
    Text& value_;
    const int digits_;
    std::vector<std::size_t> members_;  // how many members each open bag has had
};

}  // namespace

std::string onOneLine(std::string_view text) {
    Text line;
    appendOneLine(line, text);
    return std::string(line.begin(), line.end());
}

FrameText::FrameText(std::vector<std::string> names) : names_(std::move(names)), parts_(names_.size()) {
    for (const std::string& name : names_) lines_.push_back(onOneLine(name));
}

void FrameText::decode(const char* record, std::size_t size, int digits) {
    RecordReader reader(record, size);
    text_.clear();
    parts_.assign(names_.size(), Place());
    for (std::size_t name = 0; reader.more();) {
        (void)reader.tag();  // Tag::Name
        const std::string_view wanted = reader.text();
        // A row may leave out some names, but has no others.
        while (name != names_.size() && names_[name] != wanted) ++name;
        if (name == names_.size()) return;
        const std::size_t begin = text_.size();
        appendName(text_, wanted);
        Decoder(reader, text_, value_, digits).all();
        parts_[name] = {begin, text_.size() - begin};
    }
}

std::string_view FrameText::part(std::size_t name) const {
    return {text_.data() + parts_[name].begin, parts_[name].size};
}

}  // namespace OCL::reporting
