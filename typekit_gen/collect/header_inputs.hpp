// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Turns the words of the command line into headers, and into the text by which generated code includes them.
#ifndef OROFORGE_TYPEKIT_GEN_COLLECT_HEADER_INPUTS_HPP
#define OROFORGE_TYPEKIT_GEN_COLLECT_HEADER_INPUTS_HPP

#include <string>
#include <vector>

#include <diag/sink.hpp>
#include <model/type_model.hpp>

namespace oroforge::typekit {

/// Keeps files, and searches folders for headers (*.h *.hh *.hpp *.hxx, sorted, without names that contain "Typekit").
/// A missing path is error TK001, a folder without headers TK002. A file that is listed twice is returned once.
std::vector<std::string> expandInputs(const std::vector<std::string>& inputs, diag::Sink& sink);

/// Returns the header as other packages include it, never as an absolute path: relative to an include folder
/// (preferably with a result that begins with "PACKAGE/", else the first folder that holds it), else what follows
/// ".../include/", else relative to the current folder, else the bare file name.
std::string includeSpelling(const std::string& header, const std::vector<std::string>& includeDirs,
                            const std::string& package);

/// Returns the folders of -I and -isystem among compiler flags.
std::vector<std::string> includeDirsOf(const std::vector<std::string>& flags);

std::vector<model::Header> findHeaders(const std::vector<std::string>& inputs, const std::vector<std::string>& flags,
                                       const std::string& package, diag::Sink& sink);

}  // namespace oroforge::typekit

#endif
