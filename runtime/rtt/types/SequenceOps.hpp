// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SEQUENCE_OPS_HPP
#define ORO_SEQUENCE_OPS_HPP

#include <cstddef>

namespace RTT {
namespace types {

/** typeid(T).name(): the C++ type of a member, as a function so that tables can be constexpr. */
using TypeRef = const char* (*)();
template <class T>
const char* typeRef();

/** Access to the elements of a container of an erased type. One constant table per container type. */
struct SequenceOps {
    std::size_t (*size)(const void* container);
    std::size_t (*capacity)(const void* container);
    bool (*resize)(void* container, std::size_t size);  ///< null: the size is fixed
    void* (*at)(void* container, std::size_t index);    ///< null: elements have no address (vector<bool>)
    void (*load)(const void* container, std::size_t index, void* element);
    void (*store)(void* container, std::size_t index, const void* element);
    TypeRef elementType;
    /** If set: the container places elements itself, and resize() only empties it. False if it has the element
        already. */
    bool (*insert)(void* container, const void* element) = nullptr;
    /** If set: faster than load() of one index after another. */
    void (*visit)(const void* container, void (*each)(void* context, const void* element), void* context) = nullptr;
    /** If set: the elements lie one after another from this address. */
    void* (*data)(void* container) = nullptr;
};

}  // namespace types
}  // namespace RTT

#endif
