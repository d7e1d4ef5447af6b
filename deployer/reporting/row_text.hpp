// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_ROW_TEXT_HPP
#define ORO_OCL_REPORTING_ROW_TEXT_HPP

#include <cstddef>
#include <vector>

namespace OCL::reporting {

enum class Tag : unsigned char;
class RecordReader;

/** Appends the value after a tag. */
void appendValue(std::vector<char>& text, Tag tag, RecordReader& record, int digits);

/**
 * Appends the line of a record: a blank before each value, another one before a value with members, and a blank at the
 * end. Numbers are written as by a C++ stream with that many digits. A line end inside a text is written as `\n`, so
 * that a row is one line.
 */
void appendRow(std::vector<char>& text, const char* record, std::size_t size, int digits);

}  // namespace OCL::reporting

#endif
