// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_LEAF_KINDS_HPP
#define ORO_OCL_REPORTING_LEAF_KINDS_HPP

#include <cstddef>
#include <typeinfo>

namespace OCL::reporting {

class Record;

/** Appends the value at `value`. Allocates only if the record has to grow. */
typedef void (*Encode)(const void* value, Record& record);

/** How numbers, characters and strings go into a record; null for other types. */
Encode encodeOf(const std::type_info& type);

/** A std::vector of numbers, which need not be looked at element by element. */
struct NumberVector {
    Encode encode;  ///< its elements
    std::size_t (*size)(const void* vector);
};
/** Null for other types. */
const NumberVector* numberVectorOf(const std::type_info& type);

}  // namespace OCL::reporting

#endif
