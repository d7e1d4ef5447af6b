// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ENCODING_DETAIL_JSON_WRITER_HPP
#define ORO_ENCODING_DETAIL_JSON_WRITER_HPP

#include <rtt/encoding/detail/form.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace RTT {
namespace encoding {
namespace detail {

class JsonWriter {
public:
    explicit JsonWriter(std::string& out) : out_(out) {}

    void put(const Form& form, const void* value);

private:
    template <class Put>
    void putNested(Put put);
    void putNumber(types::Shape::Number number, const void* value);
    template <class Real>
    void putReal(Real number);
    void putChar(char letter);
    void putText(std::string_view text);
    void putQuoted(std::string_view text);
    void putEnumerator(const Form& form, const void* value);
    void putStruct(const Form& form, const void* value);
    void putField(const FormField& field, const void* value);
    void putPart(const Form& form, const types::SequenceOps& ops, const void* whole, std::size_t index);
    void putSequence(const Form& form, const void* value);
    void putVariant(const Form& form, const void* value);

    std::string& out_;
    unsigned depth_ = 0;
};

}  // namespace detail
}  // namespace encoding
}  // namespace RTT

#endif
