// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_TEXT_SINK_HPP
#define ORO_OCL_REPORTING_TEXT_SINK_HPP

#include "row_sink.hpp"
#include "row_text.hpp"
#include "text_target.hpp"

#include <memory>
#include <optional>
#include <string>

namespace OCL::reporting {

/** Writes lines with one field per column; a column without a value in a row has "nan", or nothing in Csv. */
std::unique_ptr<RowSink> textSink(std::unique_ptr<TextTarget> target, TextFormat format);

/** The format of that name. Otherwise logs an error with the names that there are. */
std::optional<TextFormat> textFormat(const std::string& name, const std::string& component);

}  // namespace OCL::reporting

#endif
