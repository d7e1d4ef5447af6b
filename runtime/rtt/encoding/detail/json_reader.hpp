// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ENCODING_DETAIL_JSON_READER_HPP
#define ORO_ENCODING_DETAIL_JSON_READER_HPP

#include <rtt/encoding/detail/form.hpp>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>

namespace RTT {
namespace encoding {
namespace detail {

/** Sets values from JSON. Its functions return false if something is wrong, and then error() says what. */
class JsonReader {
public:
    bool get(const Form& form, const nlohmann::json& from, void* value);
    const std::string& error() const { return error_; }

private:
    using Json = nlohmann::json;

    bool fail(const std::string& problem);
    bool expected(const char* what, const Json& found);
    template <class Get>
    bool nested(Get get);
    template <class Get>
    bool within(const std::string& part, Get get);
    bool getNumber(types::Shape::Number number, const Json& from, void* value);
    template <class Whole>
    bool getWhole(const Json& from, void* value);
    template <class Real>
    bool getReal(const Json& from, void* value);
    bool getEnumerator(const Form& form, const Json& from, void* value);
    bool getText(const Form& form, const Json& from, void* value);
    bool getStruct(const Form& form, const Json& from, void* value);
    bool getField(const FormField& field, const Json& from, void* value);
    bool getArray(const FormField& field, const Json& from, void* first);
    bool getPart(const Form& form, const types::SequenceOps& ops, const Json& from, void* whole, std::size_t index);
    bool getSequence(const Form& form, const Json& from, void* value);
    bool getLinked(const Form& form, const Json& from, void* value);
    bool getElement(const Form& form, const Json& from, void* value, std::size_t index);
    bool getVariant(const Form& form, const Json& from, void* value);
    bool getShown(const Form& form, const Json& from, void* value);

    std::string path_;
    std::string error_;
    unsigned depth_ = 0;
};

}  // namespace detail
}  // namespace encoding
}  // namespace RTT

#endif
