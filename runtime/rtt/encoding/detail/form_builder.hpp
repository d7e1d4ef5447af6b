// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ENCODING_DETAIL_FORM_BUILDER_HPP
#define ORO_ENCODING_DETAIL_FORM_BUILDER_HPP

#include <rtt/encoding/Rules.hpp>
#include <rtt/encoding/detail/form.hpp>

#include <memory>
#include <string>

namespace RTT {
namespace types {
class TypeInfo;
}

namespace encoding {
namespace detail {

/** Fields without a way to set them are for people only. */
enum class ReadOnly { LeftOut, Kept };

/** The form of a type, which owns those of its parts. Null, with the reason in `why`, if there is none. */
std::shared_ptr<const Form> buildForm(const types::TypeInfo& type, const Rules& rules, ReadOnly readOnly,
                                      std::string& why);

/** Computes the steps of a struct from its fields. */
void layOut(Form& form, const Rules& rules);

}  // namespace detail
}  // namespace encoding
}  // namespace RTT

#endif
