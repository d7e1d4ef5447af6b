// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "plain_text.hpp"

namespace oroforge::mcap {
namespace {

constexpr char kFirstByte = '\xC2';

bool isControl(unsigned char byte) { return (byte < ' ' && byte != '\n' && byte != '\t') || byte == 0x7F; }

}  // namespace

PlainText::PlainText(std::ostream& stream) : stream_(stream), to_(stream.rdbuf(this)) {}

PlainText::~PlainText() {
    (void)PlainText::sync();
    stream_.rdbuf(to_);
}

bool PlainText::release() {
    if (!held_) return true;
    held_ = false;
    return to_->sputc(kFirstByte) != traits_type::eof();
}

bool PlainText::put(char letter) {
    const auto byte = static_cast<unsigned char>(letter);
    const bool isBeyond = held_ && byte >= 0x80 && byte < 0xA0;
    if (isBeyond)
        held_ = false;
    else if (!release())
        return false;
    if (letter == kFirstByte) return held_ = true;
    return to_->sputc(isBeyond || isControl(byte) ? '?' : letter) != traits_type::eof();
}

PlainText::int_type PlainText::overflow(int_type letter) {
    if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
    return put(traits_type::to_char_type(letter)) ? letter : traits_type::eof();
}

std::streamsize PlainText::xsputn(const char* letters, std::streamsize count) {
    for (std::streamsize i = 0; i != count; ++i)
        if (!put(letters[i])) return i;
    return count;
}

int PlainText::sync() { return release() ? to_->pubsync() : -1; }

}  // namespace oroforge::mcap
