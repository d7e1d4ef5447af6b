// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ENCODING_DETAIL_SCHEMA_JSON_HPP
#define ORO_ENCODING_DETAIL_SCHEMA_JSON_HPP

#include <rtt/encoding/detail/form.hpp>

#include <nlohmann/json.hpp>

namespace RTT {
namespace encoding {
namespace detail {

/** Describes what JsonWriter writes, see Json::schema(). Null if it cannot be described. */
nlohmann::json jsonSchema(const Form& form);

}  // namespace detail
}  // namespace encoding
}  // namespace RTT

#endif
