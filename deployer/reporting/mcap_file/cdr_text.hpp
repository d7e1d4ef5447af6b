// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_RECORDING_CDR_TEXT_HPP
#define OROFORGE_RECORDING_CDR_TEXT_HPP

#include <reporting/mcap/format.hpp>

#include <cstdint>
#include <string_view>

namespace OCL::recording {

/** A message of this library's own types, as plain CDR with little endian. */
class CdrText {
public:
    CdrText() : bytes_{0, 1, 0, 0} {}

    CdrText& number(std::uint32_t number) {
        while (bytes_.size() % 4 != 0) bytes_.push_back(0);
        bytes_.resize(bytes_.size() + sizeof number);
        oroforge::mcap::putNumber(&bytes_[bytes_.size() - sizeof number], number);
        return *this;
    }
    CdrText& byte(std::uint8_t byte) {
        bytes_.push_back(byte);
        return *this;
    }
    CdrText& text(std::string_view text) {
        number(static_cast<std::uint32_t>(text.size() + 1));
        bytes_.insert(bytes_.end(), text.begin(), text.end());
        bytes_.push_back(0);
        return *this;
    }

    const oroforge::mcap::Bytes& bytes() const { return bytes_; }

private:
    oroforge::mcap::Bytes bytes_;
};

}  // namespace OCL::recording

#endif
