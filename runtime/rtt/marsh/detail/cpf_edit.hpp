// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// New values in the text of a property file that exists.
#ifndef ORO_CPF_EDIT_HPP
#define ORO_CPF_EDIT_HPP

#include <rtt/PropertyBag.hpp>

#include <xml/element.hpp>

#include <string>

namespace RTT {
namespace marsh {

/**
 * The text of a property file, whose root is `root`, with the values of `bag`, whose items have the form of such files
 * (types::decomposePropertyBag()). What the bag lacks in the file is added if `addNew`. All else stays as it is:
 * comments, layout, descriptions, and what only the file has. A value of a struct or sequence is written as a whole,
 * whatever `addNew` is: the file then has all of its members and no others. Its elements in the file stay if they are
 * the first members in their order, or all of them and the type finds them by name; else they are made anew, behind
 * the comments.
 */
RTT_API std::string editedCpf(const std::string& text, const oroforge::xml::Element& root, const PropertyBag& bag,
                              bool addNew);

}  // namespace marsh
}  // namespace RTT

#endif
