// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// A model as a component manifest: what the reader reads.
#ifndef OROFORGE_GENERATOR_MANIFEST_WRITER_HPP
#define OROFORGE_GENERATOR_MANIFEST_WRITER_HPP

#include <string>

#include <model/package.hpp>

namespace oroforge::manifest {

/// The same text for the same model. Reading it gives the model again, places aside; what is as it would be if it were not
/// written is left out.
std::string write(const model::Package& package);

}  // namespace oroforge::manifest

#endif
