// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_ROW_TEXT_HPP
#define ORO_OCL_REPORTING_ROW_TEXT_HPP

#include "record.hpp"

#include <string_view>
#include <vector>

namespace OCL::reporting {

/** How reports are written as text. */
enum class TextFormat {
    Columns,  ///< a blank before each field, another one before a value with members, and a blank at the end
    Csv       ///< RFC 4180, with lines that end with '\n'
};

/**
 * Appends the next value of the record, which has that tag. In Columns, numbers are written as by a C++ stream with
 * that many digits, and in Csv with as many as are needed to read the same number again. Locales have no influence.
 */
void appendValue(std::vector<char>& text, Tag tag, RecordReader& record, TextFormat format, int digits);

/** Appends a text as one field. In Columns, blanks, control characters and what plotting programs take for the begin of
    a quotation or comment become `\xNN`, or `\n`, `\t`, `\\`. An empty text is `""` in both formats. */
void appendField(std::vector<char>& text, std::string_view value, TextFormat format);

}  // namespace OCL::reporting

#endif
