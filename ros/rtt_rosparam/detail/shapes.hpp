// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSPARAM_DETAIL_SHAPES_HPP
#define RTT_ROSPARAM_DETAIL_SHAPES_HPP

#include <rtt/types/Shape.hpp>

#include <map>
#include <string>

namespace rtt_rosparam {

/** Values nest at most this deep. */
constexpr unsigned kDeepest = 64;

/** The shapes of the types that one conversion meets, each looked up once. Types are named by type_info::name(). */
class Shapes {
public:
    /** Of kind None, with the reason, if there is none. */
    const RTT::types::Shape& of(const char* type);

    /** The name for messages: "float64[]". */
    static std::string nameOf(const char* type);

    /** An unsized sequence whose elements, as rows of a matrix, are sequences of one length. */
    bool hasRows(const RTT::types::SequenceOps& elements);

private:
    std::map<std::string, RTT::types::Shape> known_;
};

}  // namespace rtt_rosparam

#endif
