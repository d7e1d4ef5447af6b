// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// From the words on the command line to headers, and to the text by which generated code includes them.
#ifndef OROFORGE_TYPEKIT_GEN_COLLECT_HEADER_INPUTS_HPP
#define OROFORGE_TYPEKIT_GEN_COLLECT_HEADER_INPUTS_HPP

#include <string>
#include <vector>

#include <diag/sink.hpp>
#include <model/type_model.hpp>

namespace oroforge::typekit {

/// Files stay, folders are searched for headers (*.h *.hh *.hpp *.hxx, sorted, names with "Typekit" left out).
/// What does not exist is an error TK001, a folder without headers TK002. A file that is listed twice is there once.
std::vector<std::string> expandInputs(const std::vector<std::string>& inputs, diag::Sink& sink);

/// The header as other packages include it, never an absolute path:
/// relative to one of the include folders (a result that begins with "PACKAGE/" is preferred, then the first folder
/// that holds it), else what follows ".../include/", else relative to here, else the bare file name.
std::string includeSpelling(const std::string& header, const std::vector<std::string>& includeDirs,
                            const std::string& package);

/// The folders of -I and -isystem among compiler flags.
std::vector<std::string> includeDirsOf(const std::vector<std::string>& flags);

std::vector<model::Header> findHeaders(const std::vector<std::string>& inputs, const std::vector<std::string>& flags,
                                       const std::string& package, diag::Sink& sink);

}  // namespace oroforge::typekit

#endif
