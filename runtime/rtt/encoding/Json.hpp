// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ENCODING_JSON_HPP
#define ORO_ENCODING_JSON_HPP

#include <rtt/rtt-config.h>

#include <memory>
#include <string>
#include <string_view>

namespace RTT {
namespace types {
class TypeInfo;
}

namespace encoding {

namespace detail {
struct Form;
}

/**
 * How the values of a type are written as JSON, for people, logs and tests. A constant that any number of threads may
 * use. Allocates.
 *
 * A struct is an object of its fields, a container an array. Numbers have all their digits; "NaN", "Infinity" and
 * "-Infinity" are texts. An enumerator is its name, or its number if it has none. A variant is {"alternative": "name",
 * "value": …}. A text that is not UTF-8 is an array of its bytes, a char that is no ASCII letter its number.
 */
class RTT_API Json {
public:
    /** Null, with the reason in `why`, if the type, or a part of it, has no shape. */
    static std::shared_ptr<const Json> make(const types::TypeInfo& type, std::string& why);
    ~Json();
    Json(const Json&) = delete;
    Json& operator=(const Json&) = delete;

    /** The value in one line; "null" instead of what nests deeper than Plan::kDeepest. */
    std::string text(const void* value) const;
    /** Sets the value. Fields that are not there keep theirs; those that are read-only are ignored. Empty if all went
        well; otherwise what is wrong, with its place, and the value is some valid value: "joints[2].position: found a
        text, expected a number". */
    std::string parse(std::string_view text, void* value) const;

    /** Describes the texts in the part of JSON Schema that Foxglove reads: objects, their fields with descriptions, and
        arrays of objects, texts, numbers or truth values. Fields with other arrays, variants and structs that contain
        themselves are left out; empty if the type itself is such. Allocates. */
    std::string schema() const;

private:
    explicit Json(std::shared_ptr<const detail::Form> form);

    const std::shared_ptr<const detail::Form> form_;
};

}  // namespace encoding
}  // namespace RTT

#endif
