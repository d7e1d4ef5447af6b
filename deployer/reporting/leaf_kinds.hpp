// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_LEAF_KINDS_HPP
#define ORO_OCL_REPORTING_LEAF_KINDS_HPP

#include "fields.hpp"

#include <cstddef>
#include <typeinfo>

namespace OCL::reporting {

class Record;

/** Appends the value at `value`. Allocates only if the record must grow. */
typedef void (*Encode)(const void* value, Record& record);

/** The function that encodes numbers, characters or strings of that type; null for other types. */
Encode encodeOf(const std::type_info& type);

/** The type of what it encodes. */
Number numberOf(const std::type_info& type);

/** A std::vector of numbers, which is encoded as a whole. */
struct NumberVector {
    Encode encode;  ///< encodes the elements
    std::size_t (*size)(const void* vector);
    Number number;
};
/** Null for other types. */
const NumberVector* numberVectorOf(const std::type_info& type);

}  // namespace OCL::reporting

#endif
