// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Sets values from bytes that may be wrong in any way.
#ifndef ORO_ENCODING_DETAIL_DECODER_HPP
#define ORO_ENCODING_DETAIL_DECODER_HPP

#include <rtt/encoding/Plan.hpp>
#include <rtt/encoding/detail/form.hpp>

#include <cstddef>
#include <cstdint>

namespace RTT {
namespace encoding {
namespace detail {

class Decoder {
public:
    Decoder(const void* from, std::size_t size, bool swaps, const Rules& rules)
        : begin_(static_cast<const unsigned char*>(from)), size_(size), swaps_(swaps), rules_(rules) {}

    bool get(const Form& form, void* value);
    /** False if bytes are left. */
    bool end() { return position_ == size_ || fail("there are bytes behind the value"); }
    const DecodeError& error() const { return error_; }
    /** Always false. The first problem counts. */
    bool fail(const char* problem) {
        if (!error_) error_ = {problem, position_};
        return false;
    }

private:
    std::size_t left() const { return size_ - position_; }
    bool align(std::size_t to);
    bool bytes(void* to, std::size_t count);
    bool getNumbers(void* first, std::size_t count, std::size_t size, bool areBools);
    bool getCount(std::size_t& count);
    bool getEnumerator(const Form& form, void* value);
    bool getText(const Form& form, void* value);
    bool getStruct(const Form& form, void* value);
    bool getStep(const FormStep& step, unsigned char* begin);
    bool getField(const FormField& field, unsigned char* begin);
    bool getPart(const Form& form, const types::SequenceOps& ops, void* whole, std::size_t index);
    bool getMany(const Form& form, void* first, std::size_t count);
    bool getSequence(const Form& form, void* value);
    bool getElements(const Form& form, void* value, std::size_t count);
    bool getLinked(const Form& form, void* value);
    bool getRows(const Form& form, void* value, std::size_t count);
    bool getInserted(const Form& form, void* value, std::size_t count);
    bool getVariant(const Form& form, void* value);
    bool getShown(const Form& form, void* value);
    /** The bytes here are those of memory, and any of them are values. */
    bool isCopy(bool hasBool, std::size_t alignment) const { return !swaps_ && !hasBool && position_ % alignment == 0; }

    const unsigned char* const begin_;
    const std::size_t size_;
    const bool swaps_;
    const Rules rules_;
    std::size_t position_ = 0;
    unsigned depth_ = 0;
    DecodeError error_;
};

}  // namespace detail
}  // namespace encoding
}  // namespace RTT

#endif
